/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Multigrid cycles and full multigrid (FMG) for Reynolds equation, film and
 * force balance.
 *
 * A cycle on a level, V (index 1) or W (index 2):
 *     relax `before` times; restrict (fas.h); `index` cycles on the coarser
 *     level; correct; relax `after` times.
 * H0 changes on the coarsest level only, where the force balance is solved
 * with the pressures (coarsest.h) or, as the paper does, relaxed.
 */
#ifndef OVR_MULTIGRID_CYCLE_H
#define OVR_MULTIGRID_CYCLE_H

#include "multigrid/hierarchy.h"

/* One cycle on the given level.  Before and after it the level's film,
 * properties and residual are up to date. */
void ovr_cycle(ovr_hierarchy *grids, ovr_level *level);

/* How far a level is from solved. */
typedef struct ovr_defect {
    double imbalance; /* R of reynolds.h */
    double load;      /* relative: (force - D sum P)/force */
    double centre;    /* H at X = 0 */
} ovr_defect;

ovr_defect ovr_cycle_defect(const ovr_hierarchy *grids, const ovr_level *level);

#endif
