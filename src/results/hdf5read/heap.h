/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * HDF5 keeps in heaps what does not fit into an object's header: links and
 * attributes in fractal heaps that a B-tree (version 2) lists, texts in global
 * heaps.
 */
#ifndef OVR_HDF5READ_HEAP_H
#define OVR_HDF5READ_HEAP_H

#include "results/hdf5read/pieces.h"

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
