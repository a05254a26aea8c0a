/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The headers of a result file: datasets, dimensions, attributes. */
#ifndef OVR_RESULTS_HEADER_H
#define OVR_RESULTS_HEADER_H

#include "results/file.h"

/* A dataset to be made: any number of dimensions, the unlimited one first.
 * One that is along nothing is a dimension itself. */
typedef struct ovr_new_dataset {
    const char *name, *long_name;
    const char *comment; /* definition of the quantity (CF), or NULL */
    ovr_unit_kind kind;
    hid_t type;
    hsize_t rows; /* in a chunk; 0: nothing is unlimited */
    int rank;
    hsize_t shape[OVR_MAX_RANK]; /* 0: unlimited */
    hid_t along[OVR_MAX_RANK];
    bool attached_later; /* to the datasets that it is along */
    int deflate;
    hid_t creation, access; /* properties shared by several; else 0 */
} ovr_new_dataset;

/* Makes one, described.  Negative: failed. */
hid_t ovr_header_dataset(hid_t where, const ovr_new_dataset *d,
                         const ovr_scales *scales);

/* Maximum bytes of an attribute in a header without its name. */
enum { OVR_ATTRIBUTE = 64 };

/* A group that keeps the order of its links and attributes; `bytes` is their
 * estimated size in the header. */
hid_t ovr_header_group(hid_t where, const char *name, size_t bytes);

/* Writes all headers into the open, empty file and opens its datasets. */
bool ovr_header_write(ovr_file *file, const ovr_file_plan *plan);

/* Opens the datasets of a file that has its headers already; fields that it
 * lacks are made. */
bool ovr_header_open(ovr_file *file, const ovr_file_plan *plan);

/* Writes the group `case` again: what is stored, or the end, may be another. */
bool ovr_header_new_case(ovr_file *file, const ovr_file_plan *plan);

/* The attributes of the extremes over the run; NULL: not known yet. */
bool ovr_header_extremes(hid_t root, const ovr_scales *scales,
                         const ovr_statistics *total);

/* File creation properties: the order of links and attributes is kept. */
hid_t ovr_header_creation(void);

/* "running", "complete", "stopped", "failed" */
const char *ovr_run_status_name(ovr_run_status status);

/* The time now. */
void ovr_date_now(char date[OVR_DATE_SIZE]);

#endif
