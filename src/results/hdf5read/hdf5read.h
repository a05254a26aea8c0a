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

/* A file from which pieces are read into memory of the arena. `starved` is set
 * if memory was insufficient, which is not an error of the file. */
typedef struct ovr_source {
    int fd;
    uint64_t
        bytes; /* size of the file, or its end according to the superblock */
    ovr_arena *arena;
    bool starved;
    struct ovr_kept_block *kept; /* cache of metadata blocks */
    size_t kept_since; /* `releases` of the arena when the cache was created */
} ovr_source;

typedef struct ovr_container {
    ovr_source source;
    uint64_t root; /* address of the root group; all addresses of objects are
                      offsets in the file */
} ovr_container;

/* Results of ovr_container_open. */
typedef enum ovr_found {
    OVR_FOUND_CONTAINER,
    OVR_FOUND_OTHER_HDF5, /* an HDF5 file of a form that the writer does not use
                           */
    OVR_FOUND_TRUNCATED,  /* truncated or damaged */
    OVR_FOUND_NO_HDF5,
    OVR_FOUND_NO_MEMORY
} ovr_found;

/* Opens a container in an open file, which the caller must keep open. All
 * memory belongs to the arena. */
ovr_found ovr_container_open(ovr_container *container, int fd,
                             ovr_arena *arena);

typedef struct ovr_link {
    char name[64];
    uint64_t order, object;
} ovr_link;

/* Finds an object in a group by its name; false if it does not exist or cannot
 * be read. */
bool ovr_container_find(ovr_container *container, uint64_t group,
                        const char *name, uint64_t *object);

/* Lists all objects of a group in order of creation; NULL if the file is
 * damaged. Names that this program never gives to variables (with characters
 * other than letters, digits and _) are omitted. */
ovr_link *ovr_container_links(ovr_container *container, uint64_t group,
                              size_t *count);

/* Return an attribute: a text of fixed or variable length (NULL if there is
 * none), or a number (NAN if there is none). */
char *ovr_container_text(ovr_container *container, uint64_t object,
                         const char *name);
double ovr_container_number(ovr_container *container, uint64_t object,
                            const char *name);

/* An attribute that is a single number. ovr_container_numbers lists those with
 * a plain name in order of creation; NULL if the file is damaged. */
typedef struct ovr_named_number {
    char name[64];
    size_t order;
    double value;
} ovr_named_number;
ovr_named_number *ovr_container_numbers(ovr_container *container,
                                        uint64_t object, size_t *count);

/* Kind of an object that is not a dataset of numbers. */
typedef enum ovr_object {
    OVR_OBJECT_GROUP,
    OVR_OBJECT_TEXTS,  /* a dataset of texts */
    OVR_OBJECT_UNKNOWN /* unknown, damaged, or of a layout that the writer does
                          not use */
} ovr_object;
ovr_object ovr_container_object(ovr_container *container, uint64_t object);

/* Data type of the elements in the file. */
typedef struct ovr_datatype {
    char kind; /* 'f' number, 'i' integer, 's' characters, 'v' text */
    size_t size;
} ovr_datatype;

/* A dataset of numbers with at most OVR_DIMENSIONS dimensions, the rows
 * first. */
enum { OVR_DIMENSIONS = 4 };
typedef struct ovr_dataset {
    ovr_datatype element;
    int rank;
    uint64_t shape[OVR_DIMENSIONS], width; /* `width`: values per row */
    bool chunked, packed;
    uint64_t at, chunk; /* address of the values or of the chunk B-tree; rows
                           per chunk */
} ovr_dataset;
bool ovr_container_dataset(ovr_container *container, uint64_t object,
                           ovr_dataset *set);

/* Reads a one-dimensional dataset of texts; NULL if there is none or it is
 * damaged. */
const char **ovr_container_texts(ovr_container *container, uint64_t object,
                                 size_t *count);

/* Reads values. One dimension: `count` values from row `row` on. Several
 * dimensions: row `row`, which has `count` values. Rows that were never written
 * are NaN (integers: -1). */
bool ovr_container_values(ovr_container *container, const ovr_dataset *set,
                          uint64_t row, uint64_t count, double *values);

#endif
