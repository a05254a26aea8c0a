/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a study (overroll/run.h): a row for each task; the columns are
 * the varied keys and then the numbers of the summaries.  Files of tables are
 * read into the same type. */
#ifndef OVR_RUN_STUDY_TABLE_H
#define OVR_RUN_STUDY_TABLE_H

#include <stdio.h>

#include "run/study.h"
#include "run/study_rows.h"

enum { OVR_TABLE_COLUMNS = 256 };

struct ovr_table {
    ovr_arena arena;
    size_t rows, columns;
    ovr_table_column column[OVR_TABLE_COLUMNS];
    double *number[OVR_TABLE_COLUMNS]; /* the numbers of the columns */
    /* members for the table of a study, otherwise NULL and 0 */
    const ovr_study *study;
    const ovr_study_key *key[OVR_STUDY_MAX_KEYS]; /* keys of the first
                                                   * columns */
    size_t keys;
    const ovr_sweep_state *state;
    size_t count[OVR_SWEEP_STATES];
    ovr_rows *results; /* tables of a study, or NULL */
};

ovr_table *ovr_table_make(const ovr_allocator *allocator, ovr_error *err);

/* Fails with the reason why no case of a table has results. */
ovr_status ovr_table_fail_empty(const ovr_table *table, ovr_error *err);

/* Returns the column of a number of the summaries, or NULL. */
const ovr_table_column *ovr_table_summary(const ovr_table *table,
                                          const char *name);

/* True if the key's value is a number in all tasks. */
bool ovr_table_numeric(const ovr_table_column *key);

/* Writes CSV and replaces an existing file. The complete table, or for the
 * manifest one row per task with values as in the study, state, files, main
 * numbers and error messages. */
ovr_status ovr_sweep_write_csv(const ovr_table *table, const char *path,
                               bool manifest, ovr_error *err);

/* Fails unless the HDF5 file `path` is a table of cases or does not exist. */
ovr_status ovr_sweep_netcdf_ours(const char *path, ovr_error *err);

/* Writes the complete table as netCDF-4 with the dimension `case`. */
ovr_status ovr_sweep_write_netcdf(const ovr_table *table, const char *path,
                                  ovr_error *err);

#endif
