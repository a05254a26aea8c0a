/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pieces of a file that nobody vouches for: what is read lies inside the file,
 * what is taken from it lies inside the piece.
 */
#ifndef OVR_HDF5READ_PIECES_H
#define OVR_HDF5READ_PIECES_H

#include "results/hdf5read/hdf5read.h"

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

/* The checksum of HDF5's metadata (lookup3 of Bob Jenkins, public domain);
 * true where fuzzing would not get past it. */
bool ovr_checksum_holds(const unsigned char *data, size_t size, uint64_t found);

#endif
