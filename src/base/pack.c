/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/pack.h"

#include <limits.h>
#include <string.h>

ovr_status ovr_packer_prepare(ovr_packer *packer, size_t bytes, int level,
                              ovr_arena *arena, ovr_error *err)
{
    packer->deflate = NULL;
    packer->bytes = bytes;
    if (level <= 0)
        return OVR_OK;
    if (bytes > UINT_MAX)
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "a snapshot of %zu bytes is too large for one chunk of the file; "
            "set output.window or output.stride to store fewer nodes",
            bytes);
    packer->shuffled = ovr_arena_take(arena, bytes, 1, err);
    packer->packed = ovr_arena_take(arena, bytes, 1, err);
    if (packer->shuffled && packer->packed)
        packer->deflate = libdeflate_alloc_compressor(level);
    if (!packer->deflate)
        return ovr_fail(err, OVR_NO_MEMORY,
                        "out of memory: compression of %zu bytes", bytes);
    return OVR_OK;
}

/* Byte b of element i to place b * count + i: bytes of like weight together. */
static void shuffle(unsigned char *to, const unsigned char *from, size_t count,
                    size_t size)
{
    for (size_t b = 0; b < size; b++)
        for (size_t i = 0; i < count; i++)
            to[b * count + i] = from[i * size + b];
}

size_t ovr_pack(ovr_packer *packer, const void *values, size_t count,
                size_t size)
{
    size_t bytes = count * size;
    if (!packer->deflate || bytes < 2 || bytes > packer->bytes)
        return 0;
    shuffle(packer->shuffled, values, count, size);
    return libdeflate_zlib_compress(packer->deflate, packer->shuffled, bytes,
                                    packer->packed, bytes - 1);
}

void ovr_packer_release(ovr_packer *packer)
{
    if (packer->deflate) /* older versions do not take NULL */
        libdeflate_free_compressor(packer->deflate);
    packer->deflate = NULL;
}

/* Inflates a chunk to exactly `bytes` bytes. */
static bool inflate_all(const unsigned char *chunk, size_t bytes,
                        unsigned char *to, size_t target, bool *starved)
{
    struct libdeflate_decompressor *inflate = libdeflate_alloc_decompressor();
    if (!inflate) {
        *starved = true;
        return false;
    }
    bool whole = libdeflate_zlib_decompress(inflate, chunk, bytes, to, target,
                                            NULL) == LIBDEFLATE_SUCCESS;
    libdeflate_free_decompressor(inflate);
    return whole;
}

static void unshuffle(unsigned char *to, const unsigned char *from,
                      size_t count, size_t size)
{
    for (size_t b = 0; b < size; b++)
        for (size_t i = 0; i < count; i++)
            to[i * size + b] = from[b * count + i];
}

unsigned char *ovr_unpack(const unsigned char *chunk, size_t bytes,
                          unsigned left_out, size_t count, size_t size,
                          ovr_arena *arena, bool *starved)
{
    size_t target = count * size;
    unsigned char *packed = ovr_arena_take(arena, target, 1, NULL);
    unsigned char *values = ovr_arena_take(arena, target, 1, NULL);
    bool capacity = packed && values;
    *starved = *starved || !capacity;
    if (!capacity)
        return NULL;
    if (left_out & 2 && bytes == target)
        memcpy(packed, chunk, target);
    else if (left_out & 2 ||
             !inflate_all(chunk, bytes, packed, target, starved))
        return NULL;
    if (left_out & 1)
        return packed;
    unshuffle(values, packed, count, size);
    return values;
}
