/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Distributive line relaxation (equations in line.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "multigrid/reynolds_row.h"

/* A[d + 3] = dN_i/dP_{i+d} without d eps/dH, d = -3..3. */
static void derivatives(const ovr_weights *w, const double *k,
                        const ovr_fields *f, ptrdiff_t i, double A[7])
{
    row_kind kind = row_kind_of(f);
    row_weights c = i == 1 ? row_first(w, kind) : row_inner(w, kind);
    double e[3];
    row_by_film(f, &c, i, e);
    for (int d = -3; d <= 3; d++)
        A[d + 3] = row_elastic(e, k, d);
    row_by_pressure(f, &c, i, A + 1);
}

/* Share of delta_j given to a neighbour: none from node 1 and, in steady
 * solutions, none from cavitated nodes; at the ends delta = 0. */
static double share_given(double share, const ovr_shares *shares,
                          const ovr_fields *f, ptrdiff_t j, ptrdiff_t last)
{
    bool gives = j > 1 && j < last && (shares->transient || f->wet[j]);
    return gives ? share : 0;
}

/* Includes column d = -3 of row i, which is outside the band, by delta_{i-3} =
 * 2 delta_{i-2} - delta_{i-1} (line.h). */
static void fold(const ovr_weights *w, const ovr_fields *f, ptrdiff_t i,
                 double plus, const ovr_band *band)
{
    row_weights c = row_inner(w, row_kind_of(f));
    double cut = plus * row_wedge_by_pressure(f, &c, 2, i);
    band->b[0][i] -= 2 * cut;
    band->b[1][i] += cut;
}

/* Row i keeps P_i constant: exactly in transient steps, delta_i = 0 in steady
 * solutions. */
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
        derivatives(w, k, f, i, A);
        for (ptrdiff_t d = 0; d < 5; d++) {
            minus[d] = share_given(shares->minus, shares, f, i + d - 2, last);
            plus[d] = share_given(shares->plus, shares, f, i + d - 2, last);
            if (shares->transient && i + d - 1 == last && f->wet[last - 1])
                plus[d] = 0;
            band->b[d][i] = A[d + 1] + minus[d] * A[d] + plus[d] * A[d + 2];
        }
        bool transient = shares->transient;
        if (transient && i > 2)
            fold(w, f, i, share_given(shares->plus, shares, f, i - 3, last),
                 band);
        band->delta[i] = f->r[i];
        if (f->held[i])
            hold(band, i, transient ? plus[1] : 0, transient ? minus[3] : 0);
    }
    hold(band, 0, 0, 0);
    hold(band, last, 0, 0);
}

void ovr_distribute_plain(const ovr_lanes *g, double limit,
                          const ovr_shares *shares, const ovr_band *band,
                          const ovr_fields *f)
{
    double *P = f->P, *delta = band->delta;
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    double from_left = 0;
    for (ptrdiff_t i = 1; i < last; i++) {
        double change = delta[i] + from_left +
                        share_given(shares->minus, shares, f, i + 1, last) *
                            delta[i + 1];
        from_left = share_given(shares->plus, shares, f, i, last) * delta[i];
        change = fmax(-limit, fmin(limit, change));
        P[i] = shares->transient && f->held[i] ? 0 : fmax(0, P[i] + change);
    }
    P[0] = P[last] = 0;
}
