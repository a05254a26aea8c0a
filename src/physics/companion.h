/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A companion is what of a physics goes along with a run: it looks on after
 * each step, may write into the file and has a place in its checkpoints.  A run
 * goes through its companions, those of the physics that its case has turned on
 * (simulation/physics.h), and names none of them.  Any function may be absent.
 */
#ifndef OVR_PHYSICS_COMPANION_H
#define OVR_PHYSICS_COMPANION_H

#include "base/arena.h"
#include "case/setup.h"
#include "overroll/stress.h"
#include "results/results.h"
#include "simulation/internal.h"

/* A run as its companions see it, for one call. */
typedef struct ovr_accompanied_run {
    const ovr_setup *setup;
    ovr_simulation *sim;
    ovr_arena *arena;   /* of the run */
    ovr_writer *writer; /* NULL: nothing is stored */
    const char *output; /* result file or NULL */
    bool force;         /* existing files are replaced */
    bool resumed;
    const ovr_stress_report **stress; /* of surface 1, 2, to be filled in */
    ovr_listener *say;                /* with `listener` */
    void *listener;
} ovr_accompanied_run;

typedef struct ovr_companion {
    /* Messages about a case before the solution; about a run after it. */
    void (*foresee)(const ovr_setup *setup, ovr_listener *say, void *data);
    void (*review)(const ovr_accompanied_run *run);

    /* Makes what it keeps for itself, for a run whose nodes are known. */
    ovr_status (*make)(const ovr_accompanied_run *run, void **own,
                       ovr_error *err);
    void (*release)(void *own);

    /* The run's file is open to be written to; it is complete, and may be read
     * once more. */
    ovr_status (*open)(void *own, const ovr_accompanied_run *run,
                       ovr_error *err);
    void (*set_path)(void *own, const ovr_accompanied_run *run);

    /* Called after the steady start and each step. */
    ovr_status (*observe)(void *own, const ovr_simulation *sim, ovr_error *err);

    /* Its part of a checkpoint; that was read back, of the time T. */
    ovr_status (*visit)(void *own, ovr_visit *visit, void *context,
                        ovr_error *err);
    ovr_status (*restored)(void *own, double T, ovr_error *err);

    /* The end of a run, or a stop on the way: what it has to tell. */
    ovr_status (*finish)(void *own, const ovr_accompanied_run *run,
                         ovr_error *err);
} ovr_companion;

#endif
