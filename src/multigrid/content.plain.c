/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation (equations in content.h). */
#include <math.h>
#include <string.h>

#include "multigrid/plain.h"

#include "multigrid/content_row.h"

static row_weights weights_at(const ovr_fields *f, const ovr_weights *w,
                              ptrdiff_t i)
{
    row_kind kind = row_kind_of(f);
    row_weights free = i == 1 ? row_first(w, kind) : row_inner(w, kind);
    return row_limited(f, w, &free, i);
}

void ovr_content_settle_plain(const ovr_lanes *g, const ovr_weights *w,
                              bool limits, const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    f->wet[last] = 0;
    for (ptrdiff_t i = 0; i <= last; i++) {
        if (!f->dried[i] && row_overflows(f->q[i], f->full[i]))
            f->wet[i] = i < last;
        if (f->wet[i] || f->dried[i])
            f->q[i] = f->full[i];
        f->dried[i] = 0;
    }
    for (ptrdiff_t i = 1; limits && i <= last; i++) {
        f->limited[i] = f->P[i] <= 0 && f->q[i - 1] > 2 * f->q[i];
        f->spent[i] = f->P[i] <= 0 && f->kept[i] > -w->time * f->q[i];
    }
}

void ovr_content_residual_plain(const ovr_lanes *g, const ovr_weights *w,
                                const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        row_weights c = weights_at(f, w, i);
        f->r[i] = row_content_residual(f, &c, i);
    }
    f->r[1] -= w->source;
    f->r[0] = f->r[last] = 0;
}

double ovr_content_imbalance_plain(const ovr_lanes *g, const ovr_fields *f)
{
    double sum = 0;
    for (size_t i = 0; i < g->n; i++)
        sum += fabs(f->r[i]);
    return sum;
}

void ovr_content_choose_plain(const ovr_lanes *g, const ovr_weights *w,
                              const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++)
        f->wet[i] = f->wet[i] ? !row_falls(f, i)
                              : row_rises(f, f->flow, w->half, i);
    for (ptrdiff_t i = 0; i <= last; i++) {
        f->left[i] = i > 1 && f->wet[i] && f->wet[i - 1];
        f->right[i] = i < last && f->wet[i] && f->wet[i + 1];
    }
}

/* A[d + 3] = dN_i/dP_{i+d} without d eps/dH, d = -3..3. */
static void derivatives(const row_weights *c, const double *k,
                        const ovr_fields *f, ptrdiff_t i, double A[7])
{
    double e[3];
    row_content_by_film(f, c, i, e);
    for (int d = -3; d <= 3; d++)
        A[d + 3] = row_elastic(e, k, d);
    row_by_pressure(f, c, i, A + 1);
}

static void row_of_band(const row_weights *c, const double A[7],
                        const ovr_shares *s, const ovr_fields *f, ptrdiff_t i,
                        const ovr_band *band)
{
    for (ptrdiff_t d = 0; d < 5; d++) {
        ptrdiff_t j = i + d - 2;
        double minus = f->left[j] ? s->minus : 0;
        double plus = f->right[j] ? s->plus : 0;
        double dry = d < 3 ? -row_content_weight(f, c, 2 - (int)d, i) : 0;
        double wet = A[d + 1] + minus * A[d] + plus * A[d + 2];
        band->b[d][i] = f->wet[j] ? wet : dry;
    }
}

/* Includes column d = -3 (line.h), between pressurized nodes. */
static void fold(const row_weights *c, double plus, const ovr_fields *f,
                 ptrdiff_t i, const ovr_band *band)
{
    if (!f->right[i - 3] || !f->wet[i - 1])
        return;
    double cut = plus * row_wedge_by_pressure(f, c, 2, i);
    band->b[0][i] -= 2 * cut;
    band->b[1][i] += cut;
}

static void hold(const ovr_band *band, ptrdiff_t i)
{
    for (int d = 0; d < 5; d++)
        band->b[d][i] = d == 2;
    band->delta[i] = 0;
}

void ovr_content_assemble_plain(const ovr_lanes *g, const ovr_weights *w,
                                const double k[6], const ovr_shares *shares,
                                const ovr_fields *f, const ovr_band *band)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        double A[7] = {0};
        row_weights c = weights_at(f, w, i);
        derivatives(&c, k, f, i, A);
        row_of_band(&c, A, shares, f, i, band);
        if (shares->transient && i > 2)
            fold(&c, shares->plus, f, i, band);
        band->delta[i] = f->r[i];
    }
    hold(band, 0);
    hold(band, last);
}

void ovr_content_advance_plain(const ovr_lanes *g, double limit,
                               const ovr_shares *shares, const ovr_band *band,
                               const ovr_fields *f)
{
    const double *delta = band->delta;
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        if (!f->wet[i]) {
            f->q[i] = fmax(0, f->q[i] + delta[i]);
            f->P[i] = 0;
            continue;
        }
        double change = delta[i];
        change += f->left[i + 1] ? shares->minus * delta[i + 1] : 0;
        change += f->right[i - 1] ? shares->plus * delta[i - 1] : 0;
        change = fmax(-limit, fmin(limit, change));
        f->P[i] = fmax(0, f->P[i] + change);
        f->dried[i] = !(f->P[i] > 0);
    }
    for (ptrdiff_t i = 1; i < last; i++)
        if (f->dried[i])
            f->wet[i] = 0;
    f->P[0] = f->P[last] = 0;
}

void ovr_content_restrict_plain(const ovr_lanes *coarse, const ovr_lanes *fine,
                                const ovr_fields *f, const ovr_fields *to,
                                double *rc)
{
    (void)fine;
    for (size_t I = 0; I < coarse->n; I++) {
        size_t i = 2 * I;
        bool end = I == 0 || I == coarse->n - 1;
        to->q[I] = f->q[i];
        to->wet[I] = f->wet[i];
        to->dried[I] = f->dried[i];
        to->limited[I] = f->limited[i];
        to->spent[I] = f->spent[i];
        rc[I] = end ? 0 : (f->r[i - 1] + 2 * f->r[i] + f->r[i + 1]) / 4;
    }
}
