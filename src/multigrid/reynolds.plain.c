/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual, phase and mass-flow imbalance (equations in reynolds.h). */
#include <math.h>

#include "multigrid/plain.h"

#include "multigrid/reynolds_row.h"

static void store_phase(const ovr_fields *f, const ovr_weights *w, ptrdiff_t i)
{
    f->wet[i] = f->P[i] > 0;
    f->held[i] = row_holds(f, f->r[i], w->hold, i);
}

void ovr_residual_plain(const ovr_lanes *g, const ovr_weights *w,
                        const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        row_kind kind = row_kind_of(f);
        row_weights c = i == 1 ? row_first(w, kind) : row_inner(w, kind);
        f->r[i] = row_residual(f, &c, i);
        store_phase(f, w, i);
    }
    f->r[0] = f->r[last] = 0;
}

void ovr_phase_plain(const ovr_lanes *g, const ovr_weights *w,
                     const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++)
        store_phase(f, w, i);
}

double ovr_imbalance_plain(const ovr_lanes *g, const ovr_weights *w,
                           const ovr_fields *f)
{
    double sum = 0;
    for (ptrdiff_t i = 1; i + 1 < (ptrdiff_t)g->n; i++) {
        double r = f->r[i];
        sum += r < 0 ? -r
                     : fmin(r, f->P[i] * row_outflow(f, f->flow, w->half, i));
    }
    return sum;
}
