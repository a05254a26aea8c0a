/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual, phase and mass-flow imbalance of the equation stated in
 * reynolds.h. */
#include "multigrid/reynolds.h"
#include "multigrid/vector.h"

#include "multigrid/reynolds_row.h"

/* Sets the phase of vector J from its residual. The ends are in no set. */
static inline void store_phase(const ovr_fields *f, vec hold, ptrdiff_t J,
                               vec r)
{
    put_set(f->wet, J, at(f->P, J) > 0);
    put_set(f->held, J, row_holds(f, r, hold, J));
}

static INLINE void store_row(const ovr_fields *f, const row_weights *c,
                             ptrdiff_t J)
{
    vec r = row_residual(f, c, J);
    store_phase(f, c->hold, J, r);
    put(f->r, J, r);
}

static inline void store_halo_phase(const ovr_fields *f, ptrdiff_t S)
{
    for (ptrdiff_t J = 0; J < OVR_HALO; J++) {
        put_set(f->wet, -1 - J, at(f->P, -1 - J) > 0);
        put_set(f->wet, S + J, at(f->P, S + J) > 0);
    }
}

static INLINE void store_rows(const ovr_lanes *g, const ovr_weights *w,
                              row_kind kind, const ovr_fields *f)
{
    row_weights first = row_first(w, kind), rest = row_inner(w, kind);
    store_row(f, &rest, 0);
    store_row(f, &first, 1);
    for (ptrdiff_t J = 2; J < (ptrdiff_t)g->S; J++)
        store_row(f, &rest, J);
}

/* r in rows 1..n-2, zero at both ends; and the phase. */
void OVR_KERNEL(residual)(const ovr_lanes *g, const ovr_weights *w,
                          const ovr_fields *f)
{
    const ovr_fields own = *f; /* a copy, so that the compiler can assume no
                                * store changes it */
    ptrdiff_t S = (ptrdiff_t)g->S;
    if (own.skew && own.flow) /* in both cases, whether the flow is stored
                               * because of a rheological model or not */
        store_rows(g, w, ROW_STORED | ROW_SKEWED, &own);
    else if (own.skew)
        store_rows(g, w, ROW_SUMS | ROW_SKEWED, &own);
    else if (own.flow)
        store_rows(g, w, ROW_STORED, &own);
    else
        store_rows(g, w, ROW_SUMS, &own);
    own.r[0] = 0;
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        own.r[ovr_lanes_place(g, i)] = 0;
    repeat_ends(own.r, S, 1);
    store_halo_phase(&own, S);
}

void OVR_KERNEL(phase)(const ovr_lanes *g, const ovr_weights *w,
                       const ovr_fields *f)
{
    const ovr_fields own = *f;
    const vec hold = all(w->hold);
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++)
        store_phase(&own, hold, J, at(own.r, J));
    store_halo_phase(&own, (ptrdiff_t)g->S);
}

static INLINE double sum_imbalance(const ovr_lanes *g, const ovr_weights *w,
                                   bool stored, const ovr_fields *f)
{
    const vec half = all(w->half);
    vec sum = all(0);
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec r = at(f->r, J);
        vec fall = smaller(at(f->P, J) * row_outflow(f, stored, half, J), r);
        sum += choose(r < 0, -r, fall);
    }
    return sum_of_lanes(sum);
}

/* sum rho_i of the residual in f->r */
double OVR_KERNEL(imbalance)(const ovr_lanes *g, const ovr_weights *w,
                             const ovr_fields *f)
{
    return f->flow ? sum_imbalance(g, w, true, f)
                   : sum_imbalance(g, w, false, f);
}
