/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/fas.h"

#include "multigrid/content.h"

/* F = N + restricted residual, with the film of the restricted P. */
static void make_sides(ovr_hierarchy *grids, ovr_level *coarse,
                       const double *residual)
{
    const ovr_kernels *run = grids->kernels;
    const ovr_fields *f = &coarse->f;
    ovr_level_clear(coarse, f->F);
    if (grids->conserving)
        run->content_residual(&coarse->lanes, &coarse->weights, f);
    else
        run->residual(&coarse->lanes, &coarse->weights, f); /* r = -N_c */
    run->coarse_side(&coarse->lanes, residual, f->F, f->r);
    if (!grids->conserving)
        run->phase(&coarse->lanes, &coarse->weights, f);
}

void ovr_fas_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                      ovr_level *coarse)
{
    const ovr_kernels *run = grids->kernels;
    const ovr_fields *f = &coarse->f;
    double *residual = grids->band.delta, H0 = grids->H0;
    run->restrict_fields(&coarse->lanes, &fine->lanes, &fine->f, f->P,
                         coarse->f.entry, coarse->f.gap, residual);
    if (grids->conserving)
        ovr_content_restrict(grids, fine, coarse, residual);
    ovr_level_deform(grids, coarse, f->P, coarse->f.w);
    run->coarse_gap(&coarse->lanes, H0, coarse->f.w, coarse->f.gap);
    ovr_level_properties(grids, coarse);
    make_sides(grids, coarse, residual);
    coarse->force = ovr_level_load(grids, coarse) +
                    (fine->force - ovr_level_load(grids, fine));
}

void ovr_fas_correct(const ovr_hierarchy *grids, const ovr_level *coarse,
                     ovr_level *fine, double factor)
{
    grids->kernels->correct(&coarse->lanes, &fine->lanes, factor, coarse->f.P,
                            coarse->f.entry, &fine->f);
}

static void interpolate(size_t nc, const double *v, double *P)
{
    for (size_t I = 0; I + 1 < nc; I++) {
        double before = I > 0 ? v[I - 1] : 0;
        double after = I + 2 < nc ? v[I + 2] : 0;
        double middle = (9 * (v[I] + v[I + 1]) - before - after) / 16;
        P[2 * I] = v[I];
        P[2 * I + 1] = middle > 0 ? middle : 0;
    }
    P[2 * (nc - 1)] = 0;
}

void ovr_fas_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                    ovr_level *fine)
{
    double *from = grids->scratch[0], *to = grids->scratch[1];
    ovr_level_read(grids, coarse, coarse->f.P, from);
    interpolate(coarse->grid.n, from, to);
    ovr_level_write(grids, fine, to, fine->f.P);
    if (grids->conserving)
        ovr_content_refine(grids, coarse, fine);
}
