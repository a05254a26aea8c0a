/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Input files of a case (profiles, lift tables, flow curves) stored in its
 * result file. The group `inputs` has a dataset of bytes for each file, with
 * its name, size and SHA-256 as attributes. Attributes of the group name the
 * dataset of each key. A file of more than OVR_INPUT_MAX bytes has a dataset
 * without bytes, and a file that is not regular also has no SHA-256.
 */
#ifndef OVR_RESULTS_INPUTS_H
#define OVR_RESULTS_INPUTS_H

#include "results/file.h"
#include "results/hdf5read/hdf5read.h"

/* 64 hexadecimal digits and a NUL. */
typedef struct ovr_sha256 {
    char text[65];
} ovr_sha256;

/* Reads the files and writes the group into a file without one. */
ovr_status ovr_inputs_write(const ovr_file *file, const ovr_file_plan *plan,
                            ovr_error *err);

/* Fails if an input file has changed since the beginning of the run. */
ovr_status ovr_inputs_check(ovr_container *container,
                            const ovr_write_options *options, ovr_error *err);

#endif
