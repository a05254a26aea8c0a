/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual and mass-flow imbalance of the equation stated in reynolds.h. */
#include "multigrid/reynolds.h"
#include "multigrid/reynolds_row.h"
#include "multigrid/vector.h"

/* r = F - N of vector J */
static inline void residual_at(const ovr_fields *f, double half, const wedge *c,
                               ptrdiff_t J)
{
    vec P = at(f->P, J), e = at(f->eps, J);
    vec up = (at(f->eps, J - 1) + e) * (at(f->P, J - 1) - P);
    vec down = (e + at(f->eps, J + 1)) * (at(f->P, J + 1) - P);
    vec N = half * (up + down) - c->a0 * at(f->q, J) - c->a1 * at(f->q, J - 1) -
            c->a2 * at(f->q, J - 2);
    put(f->r, J, at(f->F, J) - N);
}

/* r in rows 1..n-2, zero at both ends. */
void OVR_KERNEL(residual)(const ovr_lanes *g, const ovr_weights *w,
                          const ovr_fields *f)
{
    ptrdiff_t S = (ptrdiff_t)g->S;
    wedge first = first_wedge(w), rest = inner_wedge(w);
    residual_at(f, w->half, &rest, 0);
    residual_at(f, w->half, &first, 1);
    for (ptrdiff_t J = 2; J < S; J++)
        residual_at(f, w->half, &rest, J);
    f->r[0] = 0;
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        f->r[ovr_lanes_place(g, i)] = 0;
    repeat_ends(f->r, S, 1);
}

/* sum rho_i of the residual in f->r */
double OVR_KERNEL(imbalance)(const ovr_lanes *g, const ovr_weights *w,
                             const ovr_fields *f)
{
    ptrdiff_t S = (ptrdiff_t)g->S;
    vec sum = all(0);
    for (ptrdiff_t J = 0; J < S; J++) {
        vec e = at(f->eps, J), r = at(f->r, J);
        vec d = w->half * (at(f->eps, J - 1) + (e + e) + at(f->eps, J + 1));
        vec fall = smaller(at(f->P, J) * d, r);
        sum += choose(r < 0, -r, fall);
    }
    return sum_of_lanes(sum);
}
