/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Decides when a snapshot is due.
 *
 * By steps: at every multiple of every_steps.  By time: at the first state
 * at or after each multiple of every_time and each given time.  The answer
 * depends only on this state and the one before it, so that a resumed run
 * stores what an uninterrupted one does.
 */
#ifndef OVR_RESULTS_SCHEDULE_H
#define OVR_RESULTS_SCHEDULE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "overroll/results.h"
#include "results/results.h"

typedef struct ovr_schedule {
    long every_steps;
    double every_time;
    size_t count;
    double *times; /* increasing */
} ovr_schedule;

ovr_status ovr_schedule_make(ovr_schedule *schedule,
                             const ovr_write_options *options, ovr_arena *arena,
                             ovr_error *err);

/* Is the state of this step at T due, the one before it having been at
 * T_before (-INFINITY: there was none)? */
bool ovr_schedule_due(const ovr_schedule *schedule, long step, double T_before,
                      double T);

/* First time after T to be hit, or INFINITY. */
double ovr_schedule_next(const ovr_schedule *schedule, double T);

#endif
