/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/cycle.h"

#include <math.h>

#include "multigrid/coarsest.h"
#include "multigrid/fas.h"
#include "multigrid/hybrid.h"

static void solve_bottom(ovr_hierarchy *grids, ovr_level *level,
                         const ovr_cycling *how)
{
    if (how->paper_balance) {
        ovr_coarsest_paper(grids, level, &how->smoothing, how->index);
        return;
    }
    for (int step = 0; step < how->newton_steps; step++) {
        if (step)
            ovr_level_film(grids, level);
        if (!ovr_newton_step(grids, level, how->newton_limit))
            return;
    }
}

static void offer(ovr_hierarchy *grids, ovr_level *level,
                  const ovr_cycling *how, ovr_cycle_end end)
{
    for (const ovr_attached *to = how->attached; to; to = to->next)
        if (to->at(to->data, grids, level, end) && end != OVR_AFTER_CORRECTION)
            ovr_level_refresh(grids, level);
}

/* Levels on which a relaxation sweep takes tenths of a second. */
enum { LARGE = 13 };

/* One cycle; film and residual are not updated for the final P. */
static void descend(ovr_hierarchy *grids, ovr_level *level,
                    const ovr_cycling *how)
{
    if (level->number == how->bottom) {
        solve_bottom(grids, level, how);
        return;
    }
    ovr_level *coarse = level - 1;
    bool finest = level->number == grids->finest;
    if (level->number >= LARGE && ovr_hierarchy_stops(grids))
        return;
    for (int s = 0; s < how->sweeps_before; s++) {
        how->smoothing.relax(grids, level, &how->smoothing);
        ovr_level_refresh(grids, level);
    }
    offer(grids, level, how, OVR_BEFORE_RESTRICTION);
    ovr_fas_restrict(grids, level, coarse);
    for (int c = 0; c < how->index; c++) {
        if (c)
            ovr_level_refresh(grids, coarse);
        descend(grids, coarse, how);
    }
    ovr_fas_correct(grids, coarse, level, finest ? how->correction : 1);
    offer(grids, level, how, OVR_AFTER_CORRECTION);
    for (int s = 0; s < how->sweeps_after; s++) {
        ovr_level_refresh(grids, level);
        how->smoothing.relax(grids, level, &how->smoothing);
    }
}

/* Sets the threshold for cavitated nodes of coarse grids that are solved twice
 * (reynolds_row.h). */
static void hold_coarse(ovr_hierarchy *grids, const ovr_level *finest)
{
    const double share = 1e-6;
    for (int l = grids->coarsest; l < finest->number; l++) {
        ovr_weights *w = &grids->level[l].weights;
        w->hold = share * w->a[0];
    }
}

/* True while Newton steps are too large: far from the solution, or if the last
 * cycle hardly reduced the residual. A time step starts close to the solution;
 * if its cycles converge slowly, secants make them slower. */
static bool needs_secants(const ovr_hierarchy *grids, double before,
                          double after)
{
    double far = grids->op.transient ? 1 : 1e-3;
    double slow = grids->op.transient ? 1 : 0.5;
    return !(after < far && after < slow * before);
}

void ovr_cycle(ovr_hierarchy *grids, ovr_level *level, ovr_cycling how)
{
    if (ovr_hierarchy_stops(grids))
        return;
    grids->stopping.work += (double)level->grid.n;
    /* Only the logarithmic mean has secants, and Newton's method for asperity
     * contact converges with exact slopes. */
    const bool logarithmic = grids->fluid.logarithmic && !grids->touch.at;
    double before = 0;
    if (logarithmic) {
        before = ovr_level_imbalance(grids, level);
        grids->fluid.secants = grids->fluid.secants ||
                               needs_secants(grids, INFINITY, before);
    }
    if (grids->touch.at) {
        how.bottom = level->number;
        grids->fluid.secants = false;
    }
    if (how.index > 1 && !grids->op.transient)
        hold_coarse(grids, level);
    descend(grids, level, &how);
    ovr_level_refresh(grids, level);
    if (logarithmic)
        grids->fluid.secants = needs_secants(grids, before,
                                             ovr_level_imbalance(grids, level));
    offer(grids, level, &how, OVR_AFTER_CYCLE);
}

ovr_defect ovr_cycle_defect(const ovr_hierarchy *grids, const ovr_level *level)
{
    ovr_defect d;
    d.imbalance = ovr_level_imbalance(grids, level);
    d.load = fabs(level->force - ovr_level_load(grids, level)) /
             (level->force > 0 ? level->force : 1);
    d.centre = ovr_level_centre(level, level->f.H);
    if (grids->stopping.now)
        d.imbalance = INFINITY;
    return d;
}

/* A negative film thickness reverses the flow; the residual then is meaningless
 * and may even be negative. */
bool ovr_below(ovr_defect d, double tolerance)
{
    return d.imbalance >= 0 && d.imbalance <= tolerance &&
           d.load <= 10 * tolerance && d.centre > 0;
}
