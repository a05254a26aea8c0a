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
 *
 * What is frozen within a cycle - a correction of higher order, a temperature,
 * a patch - attaches where the cycle offers its ends.
 */
#ifndef OVR_MULTIGRID_CYCLE_H
#define OVR_MULTIGRID_CYCLE_H

#include "multigrid/smoother.h"

/* The ends of a cycle.  On each level that restricts: before it does, film and
 * residual up to date; when it has been corrected, before they are made again.
 * On the level of the cycle alone: when it is done, film and residual up to
 * date. */
typedef enum ovr_cycle_end {
    OVR_BEFORE_RESTRICTION,
    OVR_AFTER_CORRECTION,
    OVR_AFTER_CYCLE
} ovr_cycle_end;

/* Called at the ends of a cycle; true when it has changed the level's P, gap
 * or F: film and residual are then made again.  Others follow it. */
typedef struct ovr_attached {
    bool (*at)(void *data, ovr_hierarchy *grids, ovr_level *level,
               ovr_cycle_end end);
    void *data;
    const struct ovr_attached *next;
} ovr_attached;

/* The way in which a cycle is done. */
typedef struct ovr_cycling {
    ovr_smoothing smoothing;
    int sweeps_before, sweeps_after;
    int index;  /* 1: V, 2: W */
    int bottom; /* level where cycles end: the coarsest or the next finer */
    int newton_steps; /* a visit of the bottom */
    double newton_limit;
    bool paper_balance; /* bottom: relaxation and H0 by the paper */
    double correction;  /* factor on the correction into the finest level */
    const ovr_attached *attached; /* may be NULL */
} ovr_cycling;

/* One cycle on the given level.  Before and after it the level's film,
 * properties and residual are up to date. */
void ovr_cycle(ovr_hierarchy *grids, ovr_level *level, ovr_cycling how);

/* The measures of how far a level is from solved. */
typedef struct ovr_defect {
    double imbalance; /* R of reynolds.h */
    double load;      /* relative: (force - D sum P)/force */
    double centre;    /* H at X = 0 */
} ovr_defect;

ovr_defect ovr_cycle_defect(const ovr_hierarchy *grids, const ovr_level *level);

/* Solved to a tolerance on R, and ten times as much of load. */
bool ovr_below(ovr_defect d, double tolerance);

#endif
