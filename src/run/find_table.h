/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Evaluations of a search as CSV, written row by row, so that an interrupted
 * search can continue. */
#ifndef OVR_RUN_FIND_TABLE_H
#define OVR_RUN_FIND_TABLE_H

#include <stdio.h>

#include "base/arena.h"
#include "overroll/questions.h"

typedef struct ovr_find_table {
    FILE *file; /* NULL: no table */
    const char *path;
    ovr_find_evaluation *made; /* space for the rows read from the table */
    size_t maximum, count;
} ovr_find_table;

/* Appends a row and syncs it to the disk. */
ovr_status ovr_find_table_add(ovr_find_table *table,
                              const ovr_find_evaluation *one, ovr_error *err);

#endif
