/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All cases of a study in one table: its values, states and summaries. */
#ifndef OVR_RUN_SWEEP_TABLE_H
#define OVR_RUN_SWEEP_TABLE_H

#include "run/study.h"

enum { OVR_SWEEP_MAX_NUMBERS = 192 };

/* A column of numbers: a key of the summaries. */
typedef struct ovr_sweep_column {
    char name[48];
    double *value; /* of each task; NAN: none */
} ovr_sweep_column;

/* A varied key: its value in each task. */
typedef struct ovr_sweep_values {
    const ovr_study_key *key;
    bool numeric;     /* in all tasks */
    const char *unit; /* SI, or "1" */
    double *number;   /* SI, or as given without a unit */
} ovr_sweep_values;

typedef struct ovr_sweep_table {
    ovr_arena arena;
    const ovr_study *s;
    ovr_sweep_state *state;
    size_t count[OVR_SWEEP_STATES];
    ovr_sweep_values values[OVR_STUDY_MAX_KEYS];
    size_t keys;
    ovr_sweep_column column[OVR_SWEEP_MAX_NUMBERS];
    size_t columns;
} ovr_sweep_table;

/* States and summaries as they are on disk now. */
ovr_status ovr_sweep_gather(const ovr_study *s, ovr_sweep_table *table,
                            ovr_error *err);
void ovr_sweep_table_free(ovr_sweep_table *table);

/* Writes CSV, replaced whole: everything, or for the manifest a row each task
 * with values as in the study, state, files, the main numbers, messages of
 * failures.
 */
ovr_status ovr_sweep_write_csv(const ovr_sweep_table *table, const char *path,
                               bool manifest, ovr_error *err);

/* Everything, as netCDF-4 over a dimension `case`. */
ovr_status ovr_sweep_write_netcdf(const ovr_sweep_table *table,
                                  const char *path, ovr_error *err);

#endif
