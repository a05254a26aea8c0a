/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A steady solve is made of this, for the physics that solve in their own way.
 */
#ifndef OVR_SIMULATION_STEADY_H
#define OVR_SIMULATION_STEADY_H

#include "simulation/internal.h"

/* R and load of a level with film H at X = 0 where it is done; `data` is the
 * simulation. */
double ovr_steady_tolerance(const void *data, const ovr_level *level, double H);

/* The number of cycles given, else that. */
int ovr_steady_max_cycles(const ovr_simulation *sim, int unless_given);

/* Full multigrid, or what the attempt has in its place, for the finest gap as
 * it is. */
ovr_defect ovr_steady_film(ovr_simulation *sim, const ovr_full *how,
                           int *cycles);

/* Cycles on the finest level, whose right-hand sides are set, to the tolerance
 * asked for. */
ovr_defect ovr_steady_cycles(ovr_simulation *sim, const ovr_full *how,
                             int *cycles);

/* True if what was found is a solution. */
bool ovr_steady_found(const ovr_simulation *sim, const ovr_outcome *outcome);

#endif
