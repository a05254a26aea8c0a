/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/hybrid.h"

/* dN_i/dP_i and dN_i/dP_{i-1} of one row. */
typedef struct slopes {
    double own, before;
} slopes;

static slopes slopes_at(const ovr_level *level, const ovr_fields *f, size_t i,
                        double a0, double a1, double a2)
{
    const double *P = f->P, *eps = f->eps, *k = level->k;
    double half = level->weights.half;
    double e0 = a0 * f->rho[i], e1 = a1 * f->rho[i - 1],
           e2 = a2 * f->rho[i - 2];
    slopes s;
    s.own = e0 * k[0] + e1 * k[1] + e2 * k[2] - a0 * f->dq[i] -
            half * (eps[i - 1] + 2 * eps[i] + eps[i + 1] -
                    f->deps[i] * (P[i - 1] - 2 * P[i] + P[i + 1]));
    s.before = e0 * k[1] + e1 * k[0] + e2 * k[1] - a1 * f->dq[i - 1] +
               half *
                   (eps[i - 1] + eps[i] + f->deps[i - 1] * (P[i - 1] - P[i]));
    return s;
}

/* Residual of row i with film and properties as they are, P as it is now. */
static double row_residual(const ovr_level *level, const ovr_fields *f,
                           size_t i, slopes *s)
{
    const ovr_weights *w = &level->weights;
    const double *P = f->P, *eps = f->eps, *q = f->q;
    double a0 = i == 1 ? w->a0_first : w->a0, a1 = i == 1 ? w->a1_first : w->a1,
           a2 = i == 1 ? 0 : w->a2;
    *s = slopes_at(level, f, i, a0, a1, a2);
    return f->F[i] + a0 * q[i] + a1 * q[i - 1] + a2 * q[i - 2] -
           w->half * ((eps[i - 1] + eps[i]) * (P[i - 1] - P[i]) +
                      (eps[i] + eps[i + 1]) * (P[i + 1] - P[i]));
}

static double clipped(double x, double limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

/* Dry and not wanting to rise, with room for rounding (see line.h). */
static bool held(const ovr_fields *f, size_t i, double r, slopes s)
{
    return f->P[i] <= 0 && r >= OVR_DRY_TOLERANCE * s.own;
}

static void seidel(const ovr_smoothing *how, const ovr_fields *f, size_t i,
                   double r, slopes s)
{
    double next = f->P[i] + how->relax_seidel * r / s.own;
    if (!held(f, i, r, s))
        f->P[i] = next > 0 ? next : 0;
}

/* One line solve of rows first..last for fixed film, dry nodes that do not
 * want to rise held: Thomas algorithm, then projection. */
static void exit_line(const ovr_hierarchy *grids, const ovr_level *level,
                      const ovr_fields *f, size_t first, size_t last)
{
    double half = level->weights.half, above = 0, change = 0;
    double *upper = grids->band.b[0], *delta = grids->band.delta;
    for (size_t i = first; i <= last; i++) {
        slopes s;
        double r = row_residual(level, f, i, &s);
        double lower = half * (f->eps[i - 1] + f->eps[i]);
        double right = half * (f->eps[i] + f->eps[i + 1]);
        if (held(f, i, r, s)) {
            r = lower = right = 0;
            s.own = 1;
        }
        double scale = 1 / (s.own - lower * above);
        upper[i] = above = right * scale;
        delta[i] = change = (r - lower * change) * scale;
    }
    change = 0;
    for (size_t i = last; i >= first; i--) {
        change = delta[i] - upper[i] * change;
        double next = f->P[i] + change;
        f->P[i] = next > 0 ? next : 0;
    }
}

/* The rows near the end of the film that a line with fixed film may solve,
 * see hybrid.h. */
static bool exit_window(const ovr_level *level, const ovr_fields *f,
                        size_t *first, size_t *last)
{
    enum { BEHIND = 8 };
    const double *P = f->P, *eps = f->eps;
    double D = level->D;
    size_t end = level->n - 2, i;
    while (end > 1 && !(P[end] > 0))
        end--;
    for (i = end; i > 1; i--) {
        double length = D * (double)(end - i + 2);
        if (length * length > 3 * eps[i - 1])
            break;
    }
    *first = i;
    *last = end + BEHIND < level->n - 1 ? end + BEHIND : level->n - 2;
    return end > 1;
}

static void relax_exit(const ovr_hierarchy *grids, const ovr_level *level,
                       const ovr_fields *f)
{
    enum { LINES = 4 };
    size_t first, last;
    if (exit_window(level, f, &first, &last))
        for (int k = 0; k < LINES; k++)
            exit_line(grids, level, f, first, last);
}

void ovr_relax_hybrid(ovr_hierarchy *grids, ovr_level *level,
                      const ovr_smoothing *how)
{
    const ovr_fields *f = ovr_level_ordered(grids, level);
    double *restrict P = f->P, *restrict delta = grids->band.delta;
    const double *eps = f->eps;
    double bound = how->switch_value * level->D * level->D;
    size_t n = level->n;
    for (size_t i = 1; i + 1 < n; i++) {
        slopes s;
        double r = row_residual(level, f, i, &s);
        delta[i] = 0;
        if (0.25 * (eps[i - 1] + 2 * eps[i] + eps[i + 1]) > bound)
            seidel(how, f, i, r, s);
        else
            delta[i] = clipped(how->relax_dipole * r / (s.own - s.before),
                               how->limit);
    }
    delta[n - 1] = 0;
    for (size_t i = 1; i + 1 < n; i++) {
        double next = P[i] + delta[i] - delta[i + 1];
        P[i] = next > 0 ? next : 0;
    }
    relax_exit(grids, level, f);
    ovr_level_write(grids, level, P, level->f.P);
}

void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level,
                        const ovr_smoothing *how, int cycle_index)
{
    int sweeps = cycle_index > 1 ? 20 : 100;
    for (int s = 0; s < sweeps; s++) {
        if (s)
            ovr_level_refresh(grids, level);
        ovr_relax_hybrid(grids, level, how);
        grids->H0 -= 0.02 * (level->force - ovr_level_load(grids, level));
    }
}
