/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Passes are told by these: some columns of a history, dimensionless, read from
 * a result file or taken down while a simulation runs.  They are those that the
 * layers follow from, and those of the columns of passes. */
#ifndef OVR_RUN_PASS_HISTORY_H
#define OVR_RUN_PASS_HISTORY_H

#include "base/arena.h"
#include "overroll/results.h"
#include "run/pass_columns.h"

typedef enum ovr_pass_quantity {
    OVR_SEEN_TIME,
    OVR_SEEN_SUPPLY,
    OVR_SEEN_INFLOW_RATIO,
    OVR_SEEN_OUTFLOW,
    OVR_SEEN_RESERVOIR,
    OVR_SEEN_SPEED,
    OVR_PASS_QUANTITIES
} ovr_pass_quantity;

enum { OVR_SEEN_MAX = OVR_PASS_QUANTITIES + OVR_PASS_MAX };

/* Behind the ones above the quantity of each column, OVR_PASS_QUANTITIES + k;
 * those of columns beside the quantities are empty. */
typedef struct ovr_pass_history {
    ovr_arena arena;
    size_t n, capacity;
    double *of[OVR_SEEN_MAX];
    const ovr_observable *which[OVR_SEEN_MAX]; /* NULL: empty */
} ovr_pass_history;

/* Empty; ovr_arena_release(&h.arena) frees it. */
ovr_pass_history ovr_pass_history_make(const ovr_allocator *allocator);

/* All rows of a file. */
ovr_status ovr_pass_history_read(ovr_pass_history *h, ovr_result *result,
                                 ovr_error *err);

/* Takes a row down at the start and at each step. */
ovr_observer ovr_pass_history_observer(ovr_pass_history *h);

#endif
