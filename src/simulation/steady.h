/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of the steady solve, for physical models with their own solution
 * method. */
#ifndef OVR_SIMULATION_STEADY_H
#define OVR_SIMULATION_STEADY_H

#include "simulation/internal.h"

/* Strategies of steady.c that other solvers use as well. */
enum {
    OVR_STRATEGY_GROWTH = 1, /* growing features */
    OVR_STRATEGY_IN_TIME = 7,
    OVR_STRATEGY_GAP = 8 /* nested iteration with faces = gap */
};

/* Uses faces = gap in place of the logarithmic mean from now on. */
void ovr_steady_by_gap(ovr_simulation *sim);

/* Restores what the strategy of the start, known from a checkpoint, changed in
 * the equations of the steps. */
void ovr_steady_restored(ovr_simulation *sim);

/* Tolerance of R and load for a level with film thickness H at X = 0; `data` is
 * the simulation. */
double ovr_steady_tolerance(const void *data, const ovr_level *level, double H);

/* Returns the maximum number of cycles in the options, or the given default. */
int ovr_steady_max_cycles(const ovr_simulation *sim, int unless_given);

/* Solves the film for the present finest gap by full multigrid, or by the
 * method that replaces it in this attempt. */
ovr_defect ovr_steady_film(ovr_simulation *sim, const ovr_full *how,
                           int *cycles);

/* Performs cycles on the finest level, whose right-hand sides are set, until
 * the requested tolerance is reached. */
ovr_defect ovr_steady_cycles(ovr_simulation *sim, const ovr_full *how,
                             int *cycles);

/* True if the outcome is a solution. */
bool ovr_steady_found(const ovr_simulation *sim, const ovr_outcome *outcome);

#endif
