/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transfers between grids (equations in fas.h), and sums of arrays. */
#include <math.h>

#include "multigrid/plain.h"

double ovr_sum_plain(const ovr_lanes *g, const double *x)
{
    double sum = 0;
    for (size_t i = 0; i < g->n; i++)
        sum += x[i];
    return sum;
}

void ovr_combine_plain(size_t n, double a, const double *x, double b,
                       const double *y, double *result)
{
    for (size_t i = 0; i < n; i++)
        result[i] = a * x[i] + b * y[i];
}

void ovr_coarse_gap_plain(const ovr_lanes *g, double H0, const double *w,
                          double *gap)
{
    for (size_t i = 0; i < g->n; i++)
        gap[i] = gap[i] - H0 + w[i];
}

void ovr_restrict_fields_plain(const ovr_lanes *coarse, const ovr_lanes *fine,
                               const ovr_fields *f, double *Pc, double *entry,
                               double *Hc, double *rc)
{
    size_t last = coarse->n - 1;
    (void)fine;
    for (size_t I = 1; I < last; I++) {
        const double *p = f->P + 2 * I, *d = f->r + 2 * I;
        const unsigned char *wet = f->wet + 2 * I;
        bool all = wet[-1] && wet[0] && wet[1];
        double sum = 2 * d[0] + (wet[-1] ? d[-1] : 0) + (wet[1] ? d[1] : 0);
        entry[I] = Pc[I] = all ? (p[-1] + 2 * p[0] + p[1]) / 4 : p[0];
        rc[I] = wet[0] ? sum / 4 : 0;
    }
    Pc[0] = entry[0] = rc[0] = Pc[last] = entry[last] = rc[last] = 0;
    for (size_t I = 0; I <= last; I++)
        Hc[I] = f->H[2 * I];
}

void ovr_coarse_side_plain(const ovr_lanes *g, const double *residual,
                           double *F, double *r)
{
    for (size_t i = 0; i < g->n; i++) {
        F[i] = residual[i] - r[i];
        r[i] = residual[i];
    }
}

void ovr_correct_plain(const ovr_lanes *coarse, const ovr_lanes *fine,
                       double factor, const double *Pc, const double *entry,
                       const ovr_fields *f)
{
    (void)coarse;
    for (size_t i = 1; i + 1 < fine->n; i++) {
        size_t I = i / 2, J = (i + 1) / 2; /* the same at even i */
        double change = 0.5 * factor * (Pc[I] - entry[I] + Pc[J] - entry[J]);
        if (f->wet[i])
            f->P[i] = fmax(f->P[i] + change, 0);
    }
}

static double within(double x, double low, double high)
{
    return fmin(fmax(x, low), high);
}

static double shifted(const double c[4], const double *x)
{
    double sum = 0, low = x[0], high = x[0];
    for (int k = 0; k < 4; k++) {
        sum += c[k] * x[k];
        low = fmin(low, x[k]);
        high = fmax(high, x[k]);
    }
    return within(sum, low, high);
}

void ovr_carry_plain(size_t n, const double c[4], const double *const from[3],
                     double *P)
{
    for (size_t i = 0; i < n; i++) {
        double here = from[0][i], moved = shifted(c, from[1] + i);
        double low = fmin(here, moved), high = fmax(here, moved);
        double beyond = 0.1 * (high - low) + 0.02;
        double sum = here + moved - shifted(c, from[2] + i);
        sum = within(sum, low - beyond, high + beyond);
        P[i] = here > 0 ? fmax(sum, 0) : here;
    }
}

void ovr_extrapolate_plain(size_t n, size_t count, const double weight[],
                           const double *const from[], double *P)
{
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t k = 0; k < count; k++)
            sum += weight[k] * from[k][i];
        P[i] = from[0][i] > 0 ? fmax(sum, 0) : from[0][i];
    }
}
