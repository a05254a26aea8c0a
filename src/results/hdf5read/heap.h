/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heaps of an HDF5 file contain the data that do not fit into an object's
 * header: fractal heaps with a version 2 B-tree contain links and attributes,
 * global heaps contain texts.
 */
#ifndef OVR_HDF5READ_HEAP_H
#define OVR_HDF5READ_HEAP_H

#include "results/hdf5read/hdf5read.h"

/*
 * Pieces of a file that nobody vouches for: what is read lies inside the file,
 * what is taken from it lies inside the piece.
 */

/* Bytes that are left to be taken; once more was asked for than is there,
 * `good` is false and everything taken is zero. */
typedef struct ovr_piece {
    const unsigned char *at;
    size_t left;
    bool good;
} ovr_piece;

/* Little-endian, 1 to 8 bytes. */
uint64_t ovr_take(ovr_piece *bytes, size_t size);
/* The next `size` bytes as a piece of their own. */
ovr_piece ovr_cut(ovr_piece *bytes, uint64_t size);

bool ovr_load(ovr_source *source, uint64_t at, uint64_t size, ovr_piece *out);

/* A block of metadata: its four letters first, its checksum last; `out` is
 * what lies between. */
bool ovr_load_block(ovr_source *source, uint64_t at, uint64_t size,
                    const char *letters, ovr_piece *out);

/* No group or object has more links or attributes than this. */
enum { OVR_MAX_ITEMS = 4096 };

typedef struct ovr_items {
    ovr_piece *item;
    size_t *order; /* of their making; NULL: as they come */
    size_t count;
} ovr_items;

/* All that a tree lists and a heap holds; false: damaged. */
bool ovr_heap_items(ovr_source *source, uint64_t heap, uint64_t tree,
                    ovr_items *items);

/* One object of a global heap. */
bool ovr_heap_text(ovr_source *source, uint64_t heap, uint64_t index,
                   ovr_piece *out);

/* Nothing lies there: the address that HDF5 calls undefined. */
#define OVR_NOWHERE UINT64_MAX

#endif
