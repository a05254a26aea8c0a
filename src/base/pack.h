/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shuffle and deflate like HDF5's filters of these names, so that a complete
 * chunk can be passed to HDF5.
 */
#ifndef OVR_BASE_PACK_H
#define OVR_BASE_PACK_H

#include <stdbool.h>
#include <stddef.h>

#include <libdeflate.h>

#include "base/arena.h"

typedef struct ovr_packer {
    struct libdeflate_compressor *deflate; /* NULL: no compression */
    unsigned char *shuffled, *packed;
    size_t bytes; /* bytes of one chunk */
} ovr_packer;

/* Allocates the memory for packing from the arena, except for the 200 KB of
 * libdeflate, which ovr_packer_release frees. */
ovr_status ovr_packer_prepare(ovr_packer *packer, size_t bytes, int level,
                              ovr_arena *arena, ovr_error *err);

/* Packs `count` elements of `size` bytes. Returns the length of packer->packed,
 * or 0 if packing would not make it smaller. */
size_t ovr_pack(ovr_packer *packer, const void *values, size_t count,
                size_t size);

void ovr_packer_release(ovr_packer *packer);

/* Unpacks `count` elements of `size` bytes into memory of the arena (and
 * temporarily 12 KB of libdeflate). Returns NULL if the chunk is damaged, or
 * without memory, which sets *starved. `left_out` has the bits of filters that
 * were not applied: 1 shuffle, 2 deflate. */
unsigned char *ovr_unpack(const unsigned char *chunk, size_t bytes,
                          unsigned left_out, size_t count, size_t size,
                          ovr_arena *arena, bool *starved);

#endif
