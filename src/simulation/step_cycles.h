/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles on the equations of a step, from what P and H0 are, until residual
 * and load are below tolerance; a step by continuation (continuation.c). */
#ifndef OVR_SIMULATION_STEP_CYCLES_H
#define OVR_SIMULATION_STEP_CYCLES_H

#include "simulation/internal.h"

typedef struct ovr_step_cycling {
    ovr_cycling cycle;
    bool close; /* the first cycles do without the relaxation after them */
    int maximum;
    double hopeless;  /* R from which no cycle helps */
    double tolerance; /* a looser one than the step's own; or 0 */
} ovr_step_cycling;

/* True if it is solved, with H > 0; the solution is read. */
bool ovr_step_cycles(ovr_simulation *sim, ovr_step_cycling how,
                     ovr_outcome *outcome);

/* The step whose equations are set, from the last solution.  `cycle`: of a
 * careful attempt. */
bool ovr_step_continued(ovr_simulation *sim, const ovr_cycling *cycle,
                        ovr_outcome *outcome);

/* The steady solution of surfaces that grow out of smooth ones, and that from
 * the film as it is, in a time of its own (continuation.c). */
ovr_defect ovr_steady_grown(ovr_simulation *sim, const ovr_full *how,
                            int *cycles);
ovr_defect ovr_steady_settled(ovr_simulation *sim, const ovr_full *how,
                              int *cycles);

/* The same by Newton's method, if cycles fail (step.c). Returns false if the
 * method does not support the film. */
bool ovr_step_newton(ovr_simulation *sim, const ovr_cycling *how,
                     ovr_outcome *outcome);

#endif
