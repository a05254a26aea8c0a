/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Multigrid cycles and full multigrid (FMG) for Reynolds equation, film and
 * force balance.
 *
 * A cycle on a level, V (index 1) or W (index 2):
 *     relax `before` times; restrict (fas.h); `index` cycles on the coarser
 *     level; correct; relax `after` times.
 * H0 changes on the coarsest level only. There the force balance is solved
 * together with the pressures (coarsest.h) or relaxed as in the paper.
 *
 * Quantities that are constant within a cycle (higher-order corrections,
 * temperatures, patches) are updated by functions that are called between the
 * parts of a cycle.
 */
#ifndef OVR_MULTIGRID_CYCLE_H
#define OVR_MULTIGRID_CYCLE_H

#include "multigrid/smoother.h"

/* Times of these calls. On each level that is restricted: before the
 * restriction, with film and residual up to date; and after the correction,
 * before film and residual are recomputed. On the level on which the cycle
 * starts only: after the cycle, with film and residual up to date. */
typedef enum ovr_cycle_end {
    OVR_BEFORE_RESTRICTION,
    OVR_AFTER_CORRECTION,
    OVR_AFTER_CYCLE
} ovr_cycle_end;

/* A function called at these times. It returns true if it has changed the
 * level's P, gap or F; film and residual are then recomputed. Several functions
 * form a list. */
typedef struct ovr_attached {
    bool (*at)(void *data, ovr_hierarchy *grids, ovr_level *level,
               ovr_cycle_end end);
    void *data;
    const struct ovr_attached *next;
} ovr_attached;

/* Parameters of a cycle. */
typedef struct ovr_cycling {
    ovr_smoothing smoothing;
    int sweeps_before, sweeps_after;
    int index;  /* 1: V, 2: W */
    int bottom; /* level where cycles end: the coarsest or the next finer */
    int newton_steps; /* per visit of the bottom level */
    double newton_limit;
    bool paper_balance; /* bottom: relaxation, with H0 changed as in the paper
                         */
    double correction;  /* factor of the correction of the finest level */
    const ovr_attached *attached; /* may be NULL */
} ovr_cycling;

/* One cycle on the given level.  Before and after it the level's film,
 * properties and residual are up to date. */
void ovr_cycle(ovr_hierarchy *grids, ovr_level *level, ovr_cycling how);

/* Measures of the error of a level's solution. */
typedef struct ovr_defect {
    double imbalance; /* R of reynolds.h */
    double load;      /* relative: (force - D sum P)/force */
    double centre;    /* H at X = 0 */
} ovr_defect;

ovr_defect ovr_cycle_defect(const ovr_hierarchy *grids, const ovr_level *level);

/* True if R is below the tolerance and the load error is below ten times the
 * tolerance. */
bool ovr_below(ovr_defect d, double tolerance);

#endif
