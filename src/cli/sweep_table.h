/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All cases of a study in one table: its values, states and summaries. */
#ifndef OVR_CLI_SWEEP_TABLE_H
#define OVR_CLI_SWEEP_TABLE_H

#include "cli/sweep_task.h"

enum { SWEEP_MOST_NUMBERS = 96 };

/* A column of numbers: a key of the summaries. */
typedef struct sweep_column {
    char name[48];
    double *value; /* of each task; NAN: none */
} sweep_column;

/* A varied key: its value in each task. */
typedef struct sweep_values {
    const study_key *key;
    bool numeric;     /* in all tasks */
    const char *unit; /* SI, or "1" */
    double *number;   /* SI, or as given without a unit */
} sweep_values;

typedef struct sweep_table {
    ovr_arena arena;
    const study *s;
    sweep_state *state;
    size_t count[SWEEP_STATES];
    sweep_values values[STUDY_MOST_KEYS];
    size_t keys;
    sweep_column column[SWEEP_MOST_NUMBERS];
    size_t columns;
} sweep_table;

/* States and summaries as they are on disk now. */
ovr_status sweep_gather(const study *s, sweep_table *table, ovr_error *err);
void sweep_table_free(sweep_table *table);

/* OUTPUT/manifest.csv: a row each task, values as in the study, state, files,
 * the main numbers, messages of failures.  Replaced whole. */
ovr_status sweep_write_manifest(const sweep_table *table, ovr_error *err);

/* Everything, as CSV. */
ovr_status sweep_write_csv(const sweep_table *table, const char *path,
                           ovr_error *err);

/* Everything, as netCDF-4 over a dimension `case`. */
ovr_status sweep_write_netcdf(const sweep_table *table, const char *path,
                              ovr_error *err);

#endif
