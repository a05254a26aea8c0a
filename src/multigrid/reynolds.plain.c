/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual and mass-flow imbalance (equations in reynolds.h). */
#include <math.h>

#include "multigrid/plain.h"

void ovr_residual_plain(const ovr_lanes *g, const ovr_weights *w,
                        const ovr_fields *f)
{
    ptrdiff_t last = (ptrdiff_t)g->n - 1;
    for (ptrdiff_t i = 1; i < last; i++) {
        const double *P = f->P + i, *eps = f->eps + i, *q = f->q + i;
        double a[3], flow = (eps[-1] + eps[0]) * (P[-1] - P[0]) +
                            (eps[0] + eps[1]) * (P[1] - P[0]);
        ovr_row_weights(w, i, a);
        f->r[i] = f->F[i] - w->half * flow + a[0] * q[0] + a[1] * q[-1];
        if (i > 1)
            f->r[i] += a[2] * q[-2];
    }
    f->r[0] = f->r[last] = 0;
}

double ovr_imbalance_plain(const ovr_lanes *g, const ovr_weights *w,
                           const ovr_fields *f)
{
    double sum = 0;
    for (size_t i = 1; i + 1 < g->n; i++) {
        const double *eps = f->eps + i;
        double d = w->half * (eps[-1] + 2 * eps[0] + eps[1]), r = f->r[i];
        sum += r < 0 ? -r : fmin(r, f->P[i] * d);
    }
    return sum;
}
