/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads a result file without the HDF5 library.
 *
 * The HDF5 library does not check all data that it reads: a damaged or
 * malicious file can make it crash, follow a link into another file, or
 * allocate any amount of memory. Result files may be from unknown sources. This
 * reader therefore parses only the part of the format that the writer uses
 * (HDF5 1.8, which the writer selects) and its forms by h5repack and ncks. It
 * rejects other groups, filters and types, links that are not hard, and data in
 * other files. Every address and length is compared with the length of the
 * file, and no table is longer than the bytes from which it was read.
 *
 * Other folders include only this header.
 *
 * Source: The HDF Group, HDF5 File Format Specification, Version 3.0.
 */
#ifndef OVR_RESULTS_HDF5READ_H
#define OVR_RESULTS_HDF5READ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* A file to read pieces of.  Their memory is the arena's; `starved` notes that
 * it had none, which is no fault of the file. */
typedef struct ovr_source {
    int fd;
    uint64_t bytes; /* pieces end there */
    ovr_arena *arena;
    bool starved;
    struct ovr_kept_block *kept; /* blocks of metadata that were read */
    size_t kept_since;           /* `releases` of the arena that they are in */
} ovr_source;

typedef struct ovr_container {
    ovr_source source;
    uint64_t root; /* the root group: an object, as all addresses below */
} ovr_container;

/* The outcomes of ovr_container_open. */
typedef enum ovr_found {
    OVR_FOUND_CONTAINER,
    OVR_FOUND_OTHER_HDF5, /* none of those that the writer makes */
    OVR_FOUND_TRUNCATED,  /* or damaged */
    OVR_FOUND_NO_HDF5,
    OVR_FOUND_NO_MEMORY
} ovr_found;

/* The file stays open with the caller; all memory is the arena's. */
ovr_found ovr_container_open(ovr_container *container, int fd,
                             ovr_arena *arena);

typedef struct ovr_link {
    char name[64];
    uint64_t order, object;
} ovr_link;

/* An object by name in a group; false: none, or none that can be read. */
bool ovr_container_find(ovr_container *container, uint64_t group,
                        const char *name, uint64_t *object);

/* All objects in a group, in the order of their making; NULL: damaged.  Names
 * that no variable of this program has (other than letters, digits and _) are
 * left out. */
ovr_link *ovr_container_links(ovr_container *container, uint64_t group,
                              size_t *count);

/* Attributes: a text of either form, NULL when there is none; a number, NAN
 * when there is none. */
char *ovr_container_text(ovr_container *container, uint64_t object,
                         const char *name);
double ovr_container_number(ovr_container *container, uint64_t object,
                            const char *name);

/* All attributes that are one number and have a plain name, in the order of
 * their making; NULL: damaged. */
typedef struct ovr_named_number {
    char name[64];
    size_t order;
    double value;
} ovr_named_number;
ovr_named_number *ovr_container_numbers(ovr_container *container,
                                        uint64_t object, size_t *count);

/* An object that is no dataset of numbers is one of these. */
typedef enum ovr_object {
    OVR_OBJECT_GROUP,
    OVR_OBJECT_TEXTS,  /* a dataset of those */
    OVR_OBJECT_UNKNOWN /* or damaged, or laid out as the writer never does */
} ovr_object;
ovr_object ovr_container_object(ovr_container *container, uint64_t object);

/* The form that numbers have in the file. */
typedef struct ovr_datatype {
    char kind; /* 'f' number, 'i' integer, 's' characters, 'v' text */
    size_t size;
} ovr_datatype;

/* A dataset of numbers, of any number of dimensions up to this (rows first). */
enum { OVR_DIMENSIONS = 4 };
typedef struct ovr_dataset {
    ovr_datatype element;
    int rank;
    uint64_t shape[OVR_DIMENSIONS], width; /* values in a row */
    bool chunked, packed;
    uint64_t at, chunk; /* the values, or the tree of the chunks; its rows */
} ovr_dataset;
bool ovr_container_dataset(ovr_container *container, uint64_t object,
                           ovr_dataset *set);

/* A dataset of texts of one dimension; NULL: none, or damaged. */
const char **ovr_container_texts(ovr_container *container, uint64_t object,
                                 size_t *count);

/* `count` values from row `row` of one dimension, or row `row` of more, that is
 * `count` wide.  Rows that were never written are NaN (integers: -1). */
bool ovr_container_values(ovr_container *container, const ovr_dataset *set,
                          uint64_t row, uint64_t count, double *values);

#endif
