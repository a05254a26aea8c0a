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
 * Checked access to a file: a piece lies within the file, and values taken from
 * a piece lie within the piece.
 */

/* The remaining bytes of a piece. If more bytes are requested than remain,
 * `good` becomes false, and all further values are zero. */
typedef struct ovr_piece {
    const unsigned char *at;
    size_t left;
    bool good;
} ovr_piece;

/* Reads a little-endian integer of 1 to 8 bytes and moves past it. */
uint64_t ovr_take(ovr_piece *bytes, size_t size);
/* Returns the next `size` bytes as a separate piece and moves past them. */
ovr_piece ovr_cut(ovr_piece *bytes, uint64_t size);

bool ovr_load(ovr_source *source, uint64_t at, uint64_t size, ovr_piece *out);

/* Loads a metadata block and checks its signature (four letters) and checksum.
 * `out` is the content between them. */
bool ovr_load_block(ovr_source *source, uint64_t at, uint64_t size,
                    const char *letters, ovr_piece *out);

/* Maximum number of links of a group, or of attributes of an object. */
enum { OVR_MAX_ITEMS = 4096 };

typedef struct ovr_items {
    ovr_piece *item;
    size_t *order; /* creation order; NULL: not recorded */
    size_t count;
} ovr_items;

/* Reads all objects of a fractal heap that are indexed by a B-tree; false if
 * they are damaged. */
bool ovr_heap_items(ovr_source *source, uint64_t heap, uint64_t tree,
                    ovr_items *items);

/* Reads an object of a global heap. */
bool ovr_heap_text(ovr_source *source, uint64_t heap, uint64_t index,
                   ovr_piece *out);

/* HDF5's undefined address. */
#define OVR_NOWHERE UINT64_MAX

#endif
