/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The headers of a result file: datasets, dimensions, attributes. */
#ifndef OVR_RESULTS_HEADER_H
#define OVR_RESULTS_HEADER_H

#include "results/file.h"

/* Writes all headers into the open, empty file and opens its datasets. */
bool ovr_header_write(ovr_file *file, const ovr_file_plan *plan);

/* Opens the datasets of a file that has its headers already; fields that it
 * lacks are made. */
bool ovr_header_open(ovr_file *file, const ovr_file_plan *plan);

/* Writes the group `case` anew: what is stored, or the end, may be another. */
bool ovr_header_new_case(ovr_file *file, const ovr_file_plan *plan);

/* File creation properties: the order of links and attributes is kept. */
hid_t ovr_header_creation(void);

/* "running", "complete", "stopped", "failed" */
const char *ovr_run_status_name(ovr_run_status status);

/* The time now. */
void ovr_date_now(char date[OVR_DATE_SIZE]);

#endif
