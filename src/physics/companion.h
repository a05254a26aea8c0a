/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A companion is the part of a physical model that accompanies a run: it is
 * called after each step, may write to the result file and is included in
 * checkpoints. A run calls the companions of the models that its case has
 * switched on (simulation/physics.h), without naming any of them. Any function
 * may be absent.
 */
#ifndef OVR_PHYSICS_COMPANION_H
#define OVR_PHYSICS_COMPANION_H

#include "base/arena.h"
#include "case/setup.h"
#include "overroll/stress.h"
#include "results/results.h"
#include "simulation/internal.h"

/* The run as passed to a companion, valid for one call. */
typedef struct ovr_accompanied_run {
    const ovr_setup *setup;
    ovr_simulation *sim;
    ovr_arena *arena;   /* arena of the run */
    ovr_writer *writer; /* NULL: nothing is stored */
    const char *output; /* result file or NULL */
    bool force;         /* existing files are replaced */
    bool resumed;
    const ovr_stress_report **stress; /* surfaces 1 and 2, to be filled in */
    ovr_listener *say; /* receives messages, with `listener` as data */
    void *listener;
} ovr_accompanied_run;

typedef struct ovr_companion {
    /* Messages about a case before the solution; and about a run after it. */
    void (*review_before)(const ovr_setup *setup, ovr_listener *say,
                          void *data);
    void (*review)(const ovr_accompanied_run *run);

    /* Creates the companion's data for a run whose nodes are known. */
    ovr_status (*make)(const ovr_accompanied_run *run, void **own,
                       ovr_error *err);
    void (*release)(void *own);

    /* Called when the run's file has been opened for writing; and when the file
     * is complete and may be read. */
    ovr_status (*open)(void *own, const ovr_accompanied_run *run,
                       ovr_error *err);
    void (*set_path)(void *own, const ovr_accompanied_run *run);

    /* Called after the steady start and each step. */
    ovr_status (*observe)(void *own, const ovr_simulation *sim, ovr_error *err);

    /* Visits the companion's part of a checkpoint; called after the checkpoint
     * of time T has been read. */
    ovr_status (*visit)(void *own, ovr_visit *visit, void *context,
                        ovr_error *err);
    ovr_status (*restored)(void *own, double T, ovr_error *err);

    /* Called at the end of a run, or when the run is stopped earlier; reports
     * results. */
    ovr_status (*finish)(void *own, const ovr_accompanied_run *run,
                         ovr_error *err);
} ovr_companion;

#endif
