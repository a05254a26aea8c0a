/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/cycle.h"

#include <math.h>

#include "multigrid/coarsest.h"
#include "multigrid/fas.h"
#include "multigrid/hybrid.h"

static void solve_coarsest(ovr_hierarchy *grids, ovr_level *level)
{
    if (grids->paper_balance) {
        ovr_coarsest_paper(grids, level);
        return;
    }
    for (int step = 0; step < grids->newton_steps; step++) {
        if (step)
            ovr_level_film(grids, level);
        if (!ovr_newton_step(grids, level, grids->newton_limit))
            return;
    }
}

/* A cycle that leaves film and residual behind P. */
static void descend(ovr_hierarchy *grids, ovr_level *level)
{
    if (level->number == grids->bottom) {
        solve_coarsest(grids, level);
        return;
    }
    ovr_level *coarse = level - 1;
    bool finest = level->number == grids->finest;
    for (int s = 0; s < grids->sweeps_before; s++) {
        grids->relax(grids, level);
        ovr_level_refresh(grids, level);
    }
    ovr_fas_restrict(grids, level, coarse);
    for (int c = 0; c < grids->cycle_index; c++) {
        if (c)
            ovr_level_refresh(grids, coarse);
        descend(grids, coarse);
    }
    ovr_fas_correct(grids, coarse, level, finest ? grids->correction : 1);
    for (int s = 0; s < grids->sweeps_after; s++) {
        ovr_level_refresh(grids, level);
        grids->relax(grids, level);
    }
}

void ovr_cycle(ovr_hierarchy *grids, ovr_level *level)
{
    descend(grids, level);
    ovr_level_refresh(grids, level);
}

ovr_defect ovr_cycle_defect(const ovr_hierarchy *grids, const ovr_level *level)
{
    ovr_defect d;
    d.imbalance = ovr_level_imbalance(grids, level);
    d.load = fabs(level->force - ovr_level_load(grids, level)) /
             (level->force > 0 ? level->force : 1);
    d.centre = ovr_level_centre(grids, level, level->f.H);
    return d;
}
