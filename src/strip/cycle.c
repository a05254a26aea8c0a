/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The FAS cycle of the strip.  It relaxes, restricts the full solution
 * (transfer.kernel.c), corrects by the coarse grids and relaxes again.  H0
 * changes on the coarsest grid only.  The load that is missing on a fine grid
 * is added to the target of the next coarser one.
 *
 * A cycle costs 4/3 of the work on the finest grid.
 */
#include <string.h>

#include "strip/kernels.h"

/* Damping 1 and the weights of a time step: even lines, then odd ones with the
 * residual that even ones leave in the film as it was. */
static void relax_zebra(ovr_strip *strip, ovr_strip_level *level,
                        const ovr_strip_smoothing *how)
{
    const ovr_strip_kernels *run = strip->run;
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_fields *f = &level->f;
    for (int colour = 0; colour < 2; colour++) {
        if (colour)
            run->residual(g, &level->weights, f);
        run->solve_lines(g, &level->weights, how, level->near[0], f,
                         strip->work);
        run->damp(g, how, colour, f);
        run->wrap(g, f->spread);
        run->distribute(g, how, f);
        run->wrap(g, f->P);
    }
}

void ovr_strip_relax(ovr_strip *strip, ovr_strip_level *level,
                     const ovr_strip_smoothing *how)
{
    const ovr_strip_kernels *run = strip->run;
    const ovr_strip_grid *g = &level->grid;
    const ovr_strip_fields *f = &level->f;
    double k = level->near[0][0];
    run->choose(g, &level->weights, how, k, f);
    run->wrap(g, f->moves);
    run->wrap(g, f->share);
    if (how->zebra) {
        relax_zebra(strip, level, how);
    } else {
        run->solve_lines(g, &level->weights, how, level->near[0], f,
                         strip->work);
        run->damp(g, how, -1, f);
        run->wrap(g, f->spread);
        run->distribute(g, how, f);
    }
    if (how->end_sweeps > 0)
        run->sweep_ends(g, &level->weights, how, k, f, strip->work);
    ovr_strip_refresh(strip, level);
}

static void restrict_to(ovr_strip *strip, const ovr_strip_level *fine,
                        ovr_strip_level *coarse)
{
    const ovr_strip_kernels *run = strip->run;
    const ovr_strip_fields *f = &coarse->f;
    run->residual(&fine->grid, &fine->weights, &fine->f);
    run->wrap(&fine->grid, fine->f.r);
    run->restrict_fields(&coarse->grid, &fine->grid, &fine->f, strip->H0, f);
    ovr_strip_deform(strip, coarse, f->P, f->w);
    run->coarse_gap(&coarse->grid, f->w, f->gap);
    ovr_strip_properties(strip, coarse);
    run->wrap(&coarse->grid, f->entry);
    memset(f->F, 0, ovr_strip_size(&coarse->grid) * sizeof *f->F);
    run->residual(&coarse->grid, &coarse->weights, f);
    run->coarse_side(&coarse->grid, f->spread, f->r, f->F);
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
    for (int s = 0; s < how->sweeps_before; s++)
        ovr_strip_relax(strip, level, &how->smoothing);
    restrict_to(strip, level, coarse);
    clear_spread(coarse);
    ovr_strip_cycle(strip, number - 1, how);
    strip->run->wrap(&coarse->grid, coarse->f.P);
    strip->run->correct(&coarse->grid, &level->grid,
                        number == strip->finest ? how->correction : 1,
                        &coarse->f, level->f.P);
    ovr_strip_refresh(strip, level);
    for (int s = 0; s < how->sweeps_after; s++)
        ovr_strip_relax(strip, level, &how->smoothing);
}
