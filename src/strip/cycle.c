/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The FAS cycle of the strip.  It relaxes, restricts the full solution
 * (transfer.kernel.c), corrects by the coarse grids and relaxes again.  H0
 * changes on the coarsest grid only.  The load error of a fine grid is added to
 * the required load of the next coarser one.
 *
 * A cycle costs 4/3 of the work on the finest grid.
 */
#include "strip/kernels.h"

/* Zebra relaxation, with damping 1 and the weights of a time step: even lines,
 * then odd lines with the residual after the change of the even ones, for
 * unchanged film. */
static void relax_zebra(ovr_strip *strip, ovr_strip_level *level,
                        const ovr_strip_smoothing *how)
{
    for (int colour = 0; colour < 2; colour++) {
        if (colour)
            ovr_strip_residual(strip, level, false);
        ovr_strip_relax_lines(strip, level, how, colour);
    }
}

/* One relaxation; film and flow must be up to date before, and are up to date
 * after it. */
static void strip_relax(ovr_strip *strip, ovr_strip_level *level,
                        const ovr_strip_smoothing *how)
{
    ovr_strip_choose_nodes(strip, level, how);
    if (how->zebra)
        relax_zebra(strip, level, how);
    else
        ovr_strip_relax_lines(strip, level, how, -1);
    if (how->end_sweeps > 0)
        strip->run->sweep_ends(&level->grid, &level->weights, how,
                               level->near[0][0], &level->f, strip->work);
    ovr_strip_refresh(strip, level);
}

static void restrict_to(ovr_strip *strip, ovr_strip_level *fine,
                        ovr_strip_level *coarse)
{
    ovr_strip_residual(strip, fine, true);
    ovr_strip_restrict(strip, coarse);
    ovr_strip_deform(strip, coarse, coarse->f.P, coarse->f.w);
    ovr_strip_coarse_gap(strip, coarse);
    ovr_strip_properties(strip, coarse);
    ovr_strip_coarse_side(strip, coarse);
    coarse->force = ovr_strip_load(strip, coarse) + fine->force -
                    ovr_strip_load(strip, fine);
}

static void clear_spread(ovr_strip_level *level)
{
    const ovr_strip_grid *g = &level->grid;
    for (size_t j = 0; j < g->lines; j++)
        level->f.spread[j] = level->f.spread[ovr_strip_row(g, g->n - 1) + j] =
            0;
}

static void solve_coarsest(ovr_strip *strip, int steps)
{
    for (int step = 0; step < steps; step++)
        if (ovr_strip_newton(strip, false) < 0)
            return;
}

void ovr_strip_cycle(ovr_strip *strip, int number, const ovr_strip_cycling *how)
{
    if (number == 0) {
        solve_coarsest(strip, how->newton_steps);
        return;
    }
    ovr_strip_level *level = &strip->level[number], *coarse = level - 1;
    if (number == strip->finest)
        strip->cycled += (double)(level->grid.n * level->grid.lines);
    for (int s = 0; s < how->sweeps_before; s++)
        strip_relax(strip, level, &how->smoothing);
    restrict_to(strip, level, coarse);
    clear_spread(coarse);
    ovr_strip_cycle(strip, number - 1, how);
    ovr_strip_correct(strip, level,
                      number == strip->finest ? how->correction : 1);
    ovr_strip_refresh(strip, level);
    for (int s = 0; s < how->sweeps_after; s++)
        strip_relax(strip, level, &how->smoothing);
}
