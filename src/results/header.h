/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Headers of a result file: datasets, dimensions, attributes. */
#ifndef OVR_RESULTS_HEADER_H
#define OVR_RESULTS_HEADER_H

#include "results/file.h"

/* A dataset to be created, of any rank; an unlimited dimension is the first. A
 * dataset without dimension scales is itself one. */
typedef struct ovr_new_dataset {
    const char *name, *long_name;
    const char *comment; /* definition of the quantity (CF), or NULL */
    ovr_unit_kind kind;
    hid_t type;
    hsize_t rows; /* rows per chunk; 0: no unlimited dimension */
    int rank;
    hsize_t shape[OVR_MAX_RANK]; /* 0: unlimited */
    hid_t along[OVR_MAX_RANK];
    bool attached_later; /* attached to its dimension scales later */
    int deflate;
    hid_t creation, access; /* properties shared by several datasets; 0: own */
} ovr_new_dataset;

/* Creates a dataset with its attributes. Negative on failure. */
hid_t ovr_header_dataset(hid_t where, const ovr_new_dataset *d,
                         const ovr_scales *scales);

/* Maximum bytes of an attribute in a header, without its name. */
enum { OVR_ATTRIBUTE = 64 };

/* Creates a group that keeps the order of its links and attributes; `bytes` is
 * their estimated size in the header. */
hid_t ovr_header_group(hid_t where, const char *name, size_t bytes);

/* Writes all headers into the open, empty file and opens its datasets. */
bool ovr_header_write(ovr_file *file, const ovr_file_plan *plan);

/* Opens the datasets of a file with headers; missing fields are created. */
bool ovr_header_open(ovr_file *file, const ovr_file_plan *plan);

/* Rewrites the group `case`, because stored fields or the end time may have
 * changed. */
bool ovr_header_new_case(ovr_file *file, const ovr_file_plan *plan);

/* Writes the extremes over the run as attributes; NULL: not known yet. */
bool ovr_header_extremes(hid_t root, const ovr_scales *scales,
                         const ovr_statistics *total);

/* Returns file creation properties that keep the order of links and
 * attributes. */
hid_t ovr_header_creation(void);

/* "running", "complete", "stopped", "failed" */
const char *ovr_run_status_name(ovr_run_status status);

/* Writes the present time. */
void ovr_date_now(char date[OVR_DATE_SIZE]);

#endif
