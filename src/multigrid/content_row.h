/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of the discrete equation with mass-conserving cavitation (content.h):
 * the row of reynolds_row.h with weights that depend on the flux limiters, for
 * a number type `num`. */
#ifndef OVR_MULTIGRID_CONTENT_ROW_H
#define OVR_MULTIGRID_CONTENT_ROW_H

#include "multigrid/reynolds_row.h"

#ifndef VEC
static inline truth in_set(const unsigned char *set, ptrdiff_t i)
{
    return set[i] != 0;
}
#endif

/* x at the nodes of a set, 0 elsewhere */
static inline num within_set(truth in, num x)
{
    return choose(in, x, all(0));
}

/* Weights of row J, computed from the weights of a row without limiters, which
 * apply to nearly all rows. */
static inline row_weights row_limited(const ovr_fields *f, const ovr_weights *w,
                                      const row_weights *free, ptrdiff_t J)
{
    row_weights c = *free;
    if (f->limited[J] | f->limited[J - 1] | f->spent[J]) {
        truth own = in_set(f->limited, J), before = in_set(f->limited, J - 1);
        num out = all(w->out), half = all(0.5 * w->out);
        c.a[0] += within_set(in_set(f->spent, J), all(w->time));
        c.a[0] -= within_set(own, out);
        c.a[1] += within_set(own, half) + within_set(before, out);
        c.a[2] -= within_set(before, half);
    }
    return c;
}

/* r = F - N, except for the source of row 1 */
static inline num row_content_residual(const ovr_fields *f,
                                       const row_weights *c, ptrdiff_t J)
{
    num r = row_residual(f, c, J);
    return f->spent[J] ? r + within_set(in_set(f->spent, J), at(f->kept, J))
                       : r;
}

/* e[m + 2] of reynolds_row.h. The content of cavitated nodes does not depend on
 * their film thickness. */
static inline void row_content_by_film(const ovr_fields *f,
                                       const row_weights *c, ptrdiff_t J,
                                       num e[3])
{
    for (int m = 0; m < 3; m++)
        e[2 - m] = row_content_weight(f, c, m, J) *
                   within_set(in_set(f->wet, J - m), at(f->rho, J - m));
}

/* True for a pressurized node with P = 0 whose residual is negative, and for a
 * full cavitated node whose residual is positive by more than rounding. */
static inline truth row_falls(const ovr_fields *f, ptrdiff_t J)
{
    truth empty = at(f->P, J) <= 0, falls = at(f->r, J) > 0;
    return in_set(f->wet, J) & empty & falls;
}

static inline truth row_rises(const ovr_fields *f, bool stored, num half,
                              ptrdiff_t J)
{
    truth full = at(f->q, J) >= at(f->full, J);
    truth rises = at(f->r, J) < -1e-10 * row_outflow(f, stored, half, J);
    return full & rises;
}

/* True if the content of a cavitated node exceeds that of a full gap. */
static inline truth row_overflows(num q, num full)
{
    return q > full * (1 + 1e-12);
}

#endif
