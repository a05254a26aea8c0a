/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/hybrid.h"

#include <string.h>

/* dN_i/dP_i and dN_i/dP_{i-1} of one row. */
typedef struct slopes {
    double own, before;
} slopes;

static slopes slopes_at(const ovr_level *level, size_t i, double a0, double a1,
                        double a2)
{
    const ovr_fields *f = &level->f;
    const double *P = f->P, *eps = f->eps, *k = level->k;
    double half = level->weights.half;
    double e0 = a0 * f->rho[i], e1 = a1 * f->rho[i - 1],
           e2 = a2 * f->rho[i - 2];
    slopes s;
    s.own = e0 * k[0] + e1 * k[1] + e2 * k[2] - a0 * f->drho[i] * f->H[i] -
            half * (eps[i - 1] + 2 * eps[i] + eps[i + 1] -
                    f->deps[i] * (P[i - 1] - 2 * P[i] + P[i + 1]));
    s.before = e0 * k[1] + e1 * k[0] + e2 * k[1] -
               a1 * f->drho[i - 1] * f->H[i - 1] +
               half *
                   (eps[i - 1] + eps[i] + f->deps[i - 1] * (P[i - 1] - P[i]));
    return s;
}

void ovr_relax_hybrid(ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_weights *w = &level->weights;
    const ovr_fields *f = &level->f;
    double *restrict P = f->P, *restrict delta = grids->band.delta;
    const double *eps = f->eps, *q = f->q;
    double bound = grids->switch_value * level->D * level->D;
    size_t n = level->n;
    memset(delta, 0, (n + 1) * sizeof *delta);
    for (size_t i = 1; i + 1 < n; i++) {
        bool first = i == 1;
        double a0 = first ? w->a0_first : w->a0,
               a1 = first ? w->a1_first : w->a1, a2 = first ? 0 : w->a2;
        double r = f->F[i] + a0 * q[i] + a1 * q[i - 1] + a2 * q[i - 2] -
                   w->half * ((eps[i - 1] + eps[i]) * (P[i - 1] - P[i]) +
                              (eps[i] + eps[i + 1]) * (P[i + 1] - P[i]));
        slopes s = slopes_at(level, i, a0, a1, a2);
        if (eps[i] > bound) {
            double next = P[i] + grids->relax_seidel * r / s.own;
            P[i] = next > 0 ? next : 0;
        } else {
            double d = grids->relax_dipole * r / (s.own - s.before);
            delta[i] = d > grids->limit    ? grids->limit
                       : d < -grids->limit ? -grids->limit
                                           : d;
        }
    }
    for (size_t i = 1; i + 1 < n; i++) {
        double next = P[i] + delta[i] - delta[i + 1];
        P[i] = next > 0 ? next : 0;
    }
}

void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level)
{
    enum { SWEEPS = 10 };
    for (int s = 0; s < SWEEPS; s++) {
        if (s) {
            ovr_level_film(grids, level);
            ovr_level_residual(grids, level);
        }
        ovr_relax_hybrid(grids, level);
        grids->H0 -= 0.05 * (level->force - ovr_level_load(level));
    }
}
