/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual, phase and mass-flow imbalance of the equation stated in
 * reynolds.h. */
#include "multigrid/reynolds.h"
#include "multigrid/vector.h"

#include "multigrid/reynolds_row.h"

/* r in rows 1..n-2, zero at both ends. */
void OVR_KERNEL(residual)(const ovr_lanes *g, const ovr_weights *w,
                          const ovr_fields *f)
{
    ptrdiff_t S = (ptrdiff_t)g->S;
    row_weights first = row_first(w), rest = row_inner(w);
    put(f->r, 0, row_residual(f, &rest, 0));
    put(f->r, 1, row_residual(f, &first, 1));
    for (ptrdiff_t J = 2; J < S; J++)
        put(f->r, J, row_residual(f, &rest, J));
    f->r[0] = 0;
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        f->r[ovr_lanes_place(g, i)] = 0;
    repeat_ends(f->r, S, 1);
}

/* Whether the ends are held is not said. */
void OVR_KERNEL(phase)(const ovr_lanes *g, const ovr_weights *w,
                       const ovr_fields *f)
{
    const ovr_fields own = *f; /* a copy that no store can change */
    const vec a0 = all(w->a[0]);
    ptrdiff_t S = (ptrdiff_t)g->S;
    for (ptrdiff_t J = 0; J < S; J++) {
        put_set(own.wet, J, at(own.P, J) > 0);
        put_set(own.held, J, row_holds(&own, at(own.r, J), a0, J));
    }
    for (ptrdiff_t J = 0; J < OVR_HALO; J++) {
        put_set(own.wet, -1 - J, at(own.P, -1 - J) > 0);
        put_set(own.wet, S + J, at(own.P, S + J) > 0);
    }
}

/* sum rho_i of the residual in f->r */
double OVR_KERNEL(imbalance)(const ovr_lanes *g, const ovr_weights *w,
                             const ovr_fields *f)
{
    const vec half = all(w->half);
    vec sum = all(0);
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec r = at(f->r, J);
        vec fall = smaller(at(f->P, J) * row_outflow(f, half, J), r);
        sum += choose(r < 0, -r, fall);
    }
    return sum_of_lanes(sum);
}
