/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/fas.h"

#include <string.h>

static void restrict_pressure(const double *restrict P, size_t nc,
                              double *restrict Pc)
{
    Pc[0] = Pc[nc - 1] = 0;
    for (size_t I = 1; I + 1 < nc; I++) {
        const double *p = P + 2 * I;
        int wet = (p[-1] > 0) & (p[0] > 0) & (p[1] > 0);
        Pc[I] = wet ? 0.25 * (p[-1] + 2 * p[0] + p[1]) : p[0];
    }
}

/* Adds the residual, full weighting, of wet nodes to F_c. */
static void add_residual(const double *restrict P, const double *restrict r,
                         size_t nc, double *restrict F)
{
    for (size_t I = 1; I + 1 < nc; I++) {
        const double *p = P + 2 * I, *s = r + 2 * I;
        double left = p[-1] > 0 ? s[-1] : 0, right = p[1] > 0 ? s[1] : 0;
        F[I] += p[0] > 0 ? 0.25 * (left + 2 * s[0] + right) : 0;
    }
}

void ovr_fas_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                      ovr_level *coarse)
{
    const ovr_kernels *run = grids->kernels;
    size_t nc = coarse->n;
    double H0 = grids->H0;
    restrict_pressure(fine->f.P, nc, coarse->f.P);
    memcpy(coarse->P_entry, coarse->f.P, nc * sizeof(double));
    run->deformation(&coarse->mlmi, coarse->f.P, coarse->w);
    for (size_t I = 0; I < nc; I++) {
        double H = fine->f.H[2 * I];
        coarse->gap[I] = H - H0 + coarse->w[I];
    }
    run->film(&grids->fluid, H0, nc, coarse->gap, coarse->w, &coarse->f);
    memset(coarse->f.F, 0, nc * sizeof(double));
    ovr_level_residual(grids, coarse); /* r = -N_c */
    for (size_t I = 0; I < nc; I++)
        coarse->f.F[I] = -coarse->f.r[I];
    add_residual(fine->f.P, fine->f.r, nc, coarse->f.F);
    coarse->force = ovr_level_load(coarse) +
                    (fine->force - ovr_level_load(fine));
    ovr_level_residual(grids, coarse);
}

static double lifted(double P, double change)
{
    double sum = P + change;
    return P > 0 && sum > 0 ? sum : 0;
}

void ovr_fas_correct(const ovr_level *coarse, ovr_level *fine, double factor)
{
    const double *restrict Pc = coarse->f.P, *restrict entry = coarse->P_entry;
    double *restrict P = fine->f.P;
    for (size_t I = 0; I + 1 < coarse->n; I++) {
        double left = factor * (Pc[I] - entry[I]);
        double right = factor * (Pc[I + 1] - entry[I + 1]);
        P[2 * I] = lifted(P[2 * I], left);
        P[2 * I + 1] = lifted(P[2 * I + 1], 0.5 * (left + right));
    }
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
