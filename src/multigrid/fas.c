/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/fas.h"

#include <string.h>

void ovr_fas_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                      ovr_level *coarse)
{
    const ovr_kernels *run = grids->kernels;
    const ovr_fields *f = &coarse->f;
    double *residual = grids->band.delta, H0 = grids->H0;
    size_t nc = coarse->n;
    run->restrict_fields(nc, fine->f.P, fine->f.H, fine->f.r, f->P,
                         coarse->P_entry, coarse->gap, residual);
    run->deformation(&coarse->mlmi, f->P, coarse->w);
    run->coarse_gap(nc, H0, coarse->w, coarse->gap);
    run->film(&grids->fluid, H0, nc, coarse->gap, coarse->w, f);
    memset(f->F, 0, nc * sizeof(double));
    ovr_level_residual(grids, coarse); /* r = -N_c */
    run->coarse_side(nc, residual, f->F, f->r);
    coarse->force = ovr_level_load(grids, coarse) +
                    (fine->force - ovr_level_load(grids, fine));
}

void ovr_fas_correct(const ovr_hierarchy *grids, const ovr_level *coarse,
                     ovr_level *fine, double factor)
{
    grids->kernels->correct(coarse->n, factor, coarse->f.P, coarse->P_entry,
                            fine->f.P);
}

void ovr_fas_refine(const ovr_level *coarse, ovr_level *fine)
{
    const double *v = coarse->f.P;
    double *P = fine->f.P;
    size_t nc = coarse->n;
    for (size_t I = 0; I + 1 < nc; I++) {
        double before = I > 0 ? v[I - 1] : 0;
        double after = I + 2 < nc ? v[I + 2] : 0;
        double middle = (9 * (v[I] + v[I + 1]) - before - after) / 16;
        P[2 * I] = v[I];
        P[2 * I + 1] = middle > 0 ? middle : 0;
    }
    P[fine->n - 1] = 0;
}
