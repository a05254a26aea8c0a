/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls the companions of a run (physics/companion.h) in turn. */
#ifndef OVR_RUN_COMPANION_H
#define OVR_RUN_COMPANION_H

#include "overroll/run.h"
#include "physics/companion.h"

/* A companion and its data in a run; `is` of the last element of a list is
 * NULL. */
typedef struct ovr_accompanied {
    const ovr_companion *is;
    void *own;
} ovr_accompanied;

/* Collects the warnings and notes of all physical models about a case or a
 * run. */
void ovr_companions_predict(const ovr_setup *setup, ovr_listener *say,
                            void *data);
void ovr_companions_review(ovr_run *run);

/* Functions of the companions of a run; `data` is the run. */
ovr_status ovr_companions_make(ovr_run *run, ovr_error *err);
void ovr_companions_release(ovr_run *run);
ovr_status ovr_companions_open(ovr_run *run, ovr_error *err);
void ovr_companions_set_path(ovr_run *run);
ovr_status ovr_companions_restore(ovr_run *run, double T, ovr_error *err);
ovr_status ovr_companions_observe(void *data, const ovr_simulation *sim,
                                  ovr_error *err);
ovr_status ovr_companions_finish(ovr_run *run, ovr_error *err);

#endif
