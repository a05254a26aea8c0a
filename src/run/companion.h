/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A companion is what of a physics goes along with a run: it looks on after
 * each step, may write into the file and has a place in its checkpoints.  A run
 * goes through its companions, those of the physics that its case has turned on
 * (simulation/physics.h), and names none of them.  Any function may be absent.
 */
#ifndef OVR_RUN_COMPANION_H
#define OVR_RUN_COMPANION_H

#include "overroll/results.h"
#include "overroll/run.h"

typedef struct ovr_companion {
    /* What is said of a case before it is solved; of a run after it. */
    void (*foresee)(const ovr_setup *setup, ovr_listener *say, void *data);
    void (*review)(ovr_run *run);

    /* Makes what it keeps for itself, for a run whose nodes are known. */
    ovr_status (*make)(const ovr_run *run, void **own, ovr_error *err);
    void (*release)(void *own);

    /* The run's file is open to be written to; it is complete, and may be read
     * once more. */
    ovr_status (*open)(void *own, const ovr_run *run, ovr_error *err);
    void (*told_of)(void *own, const ovr_run *run);

    /* Called after the steady start and each step. */
    ovr_status (*observe)(void *own, const ovr_simulation *sim, ovr_error *err);

    /* Its part of a checkpoint; that was read back, of the time T. */
    ovr_status (*visit)(void *own, ovr_visit *visit, void *context,
                        ovr_error *err);
    ovr_status (*restored)(void *own, double T, ovr_error *err);

    /* The end of a run, or a stop on the way: what it has to tell. */
    ovr_status (*finish)(void *own, ovr_run *run, ovr_error *err);
} ovr_companion;

/* One of a run; is NULL behind the last. */
typedef struct ovr_accompanied {
    const ovr_companion *is;
    void *own;
} ovr_accompanied;

/* Says what all physics of a case, of a run, have to say. */
void ovr_companions_foresee(const ovr_setup *setup, ovr_listener *say,
                            void *data);
void ovr_companions_review(ovr_run *run);

/* Those of a run; all functions take it (`data` is a run). */
ovr_status ovr_companions_make(ovr_run *run, ovr_error *err);
void ovr_companions_release(ovr_run *run);
ovr_status ovr_companions_open(ovr_run *run, ovr_error *err);
void ovr_companions_told_of(ovr_run *run);
ovr_status ovr_companions_restore(ovr_run *run, double T, ovr_error *err);
ovr_status ovr_companions_observe(void *data, const ovr_simulation *sim,
                                  ovr_error *err);
ovr_status ovr_companions_finish(ovr_run *run, ovr_error *err);

#endif
