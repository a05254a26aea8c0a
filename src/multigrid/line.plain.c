/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distributive line relaxation (equations in line.h). */
#include <math.h>
#include <stdlib.h>

#include "multigrid/plain.h"

/* dN_i/dP_{i+d} without d eps/dH; the elastic part first. */
static double derivative(const ovr_weights *w, const double *k,
                         const ovr_fields *f, ptrdiff_t i, ptrdiff_t d)
{
    const double *P = f->P + i, *eps = f->eps + i, *deps = f->deps + i;
    double a[3], sum = 0;
    ovr_row_weights(w, i, a);
    for (ptrdiff_t m = 0; m < 3 && m <= i; m++)
        sum += a[m] * f->rho[i - m] * k[labs(d + m)];
    if (-2 <= d && d <= 0 && i + d >= 0)
        sum -= a[-d] * f->dq[i + d];
    if (d == -1)
        sum += w->half * (eps[-1] + eps[0] + deps[-1] * (P[-1] - P[0]));
    if (d == 0)
        sum -= w->half * (eps[-1] + 2 * eps[0] + eps[1] -
                          deps[0] * (P[-1] - 2 * P[0] + P[1]));
    if (d == 1)
        sum += w->half * (eps[0] + eps[1] + deps[1] * (P[1] - P[0]));
    return sum;
}

/* The share of delta_j that a neighbour gets: node 1 and, when steady, a dry
 * node give nothing away, and at the ends delta = 0. */
static double given(double share, const ovr_shares *shares, const double *P,
                    ptrdiff_t j, ptrdiff_t last)
{
    bool gives = j > 1 && j < last && (shares->transient || P[j] > 0);
    return gives ? share : 0;
}

/* Row i says that P_i stays: exactly in time, delta_i = 0 when steady. */
static void hold(const ovr_band *band, ptrdiff_t i, double before, double after)
{
    const double row[5] = {0, before, 1, after, 0};
    for (int d = 0; d < 5; d++)
        band->b[d][i] = row[d];
    band->delta[i] = 0;
}

void ovr_band_assemble_plain(const ovr_lanes *g, const ovr_weights *w,
                             const double k[6], const ovr_shares *shares,
                             const ovr_fields *f, const ovr_band *band)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        double minus[5], plus[5], A[7]; /* A[d + 3] */
        for (ptrdiff_t d = -3; d <= 3; d++)
            A[d + 3] = derivative(w, k, f, i, d);
        for (ptrdiff_t d = 0; d < 5; d++) {
            minus[d] = given(shares->minus, shares, f->P, i + d - 2, last);
            plus[d] = given(shares->plus, shares, f->P, i + d - 2, last);
            band->b[d][i] = A[d + 1] + minus[d] * A[d] + plus[d] * A[d + 2];
        }
        bool dry = f->P[i] <= 0 && f->r[i] >= OVR_DRY_TOLERANCE * A[3];
        bool transient = shares->transient;
        band->delta[i] = f->r[i];
        band->moves[i] = !(dry && transient);
        if (dry)
            hold(band, i, transient ? plus[1] : 0, transient ? minus[3] : 0);
    }
    hold(band, 0, 0, 0);
    hold(band, last, 0, 0);
}

void ovr_distribute_plain(const ovr_lanes *g, double limit,
                          const ovr_shares *shares, const ovr_band *band,
                          double *P)
{
    const double *delta = band->delta;
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    double from_left = 0;
    for (ptrdiff_t i = 1; i < last; i++) {
        double change = delta[i] + from_left +
                        given(shares->minus, shares, P, i + 1, last) *
                            delta[i + 1];
        from_left = given(shares->plus, shares, P, i, last) * delta[i];
        change = fmax(-limit, fmin(limit, change));
        P[i] = band->moves[i] * fmax(0, P[i] + change);
    }
    P[0] = P[last] = 0;
}
