/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cycles for the equations of a time step, starting from the present P and H0,
 * until residual and load error are below the tolerance; also steps by
 * continuation (continuation.c). */
#ifndef OVR_SIMULATION_STEP_CYCLES_H
#define OVR_SIMULATION_STEP_CYCLES_H

#include "simulation/internal.h"

typedef struct ovr_step_cycling {
    ovr_cycling cycle;
    bool close; /* the first cycles omit the relaxation after the coarse-grid
                 * correction */
    int maximum;
    double hopeless;  /* R above which no cycle can converge */
    double tolerance; /* a larger tolerance than that of the step; 0: none */
} ovr_step_cycling;

/* Returns true if the step is solved with H > 0; the solution has then been
 * read. */
bool ovr_step_cycles(ovr_simulation *sim, ovr_step_cycling how,
                     ovr_outcome *outcome);

/* Solves the step, whose equations are set, by continuation from the last
 * solution. `cycle`: parameters of a careful attempt. */
bool ovr_step_continued(ovr_simulation *sim, const ovr_cycling *cycle,
                        ovr_outcome *outcome);

/* Solves the steady film by pseudo-transient continuation, with surface
 * features that grow from smooth surfaces; or starting from the present film
 * (continuation.c). */
ovr_defect ovr_steady_grown(ovr_simulation *sim, const ovr_full *how,
                            int *cycles);
ovr_defect ovr_steady_settled(ovr_simulation *sim, const ovr_full *how,
                              int *cycles);

/* Solves the step by Newton's method if cycles fail (step.c). Returns false if
 * the method does not support the film. */
bool ovr_step_newton(ovr_simulation *sim, const ovr_cycling *how,
                     ovr_outcome *outcome);

#endif
