/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Row i of the discrete Reynolds equation (reynolds.h): residual, derivatives,
 * and the condition for a cavitated node to stay at P = 0. For any number type
 * `num` with all(), at(), fused(), less(): vectors of nodes (vector.h), one
 * node (scalar.h). `J` is the vector, or the node.
 *
 *     N = [before up + after down]/(2 D^2) - a0 q_i - a1 q_{i-1} - a2 q_{i-2}
 *     up = P_{i-1} - P_i       before = eps_{i-1} + eps_i
 *     down = P_{i+1} - P_i     after = eps_i + eps_{i+1}
 *
 * Where the flow at half nodes is stored, by the gap (faces.h) or with a flow
 * law (flow.h), 2 E replaces before and after. The stored derivatives of 2 E
 * (P_{i+1} - P_i) replace the terms below with 1/(2 D^2): out_right at i - 1
 * and out_left at i are the derivatives with respect to P_i.
 *
 * Temperature differences across the film skew the flow and add a wedge
 * (physics/heat/skew.h), with weights b for unit speed:
 *
 *     N <- N - sum_m b_m (s q)_{i-m},  s = s_0 + s_1 P
 *
 * Weights of q are then a_m + b_m s. Terms -b_m s_1 q add to dN/dP.
 *
 * dN_i/dP_{i+d} at fixed film, eps' = d eps/dP:
 *     d = -2:  -a2 rho'_{i-2} H_{i-2}
 *     d = -1:  [before + eps'_{i-1} up]/(2 D^2) - a1 rho'_{i-1} H_{i-1}
 *     d =  0:  -[before + after - eps'_i (up + down)]/(2 D^2) - a0 rho'_i H_i
 *     d = +1:  [after + eps'_{i+1} down]/(2 D^2)
 * and through the film, dH_k/dP_j = -k(j - k):
 *     dN_i/dP_{i+d} = sum_m e_m k(d - m),  e_m = -dN_i/dH_{i+m},  m = -2..1
 *     e_m = a_{-m} rho_{i+m} - (d eps_{i+m}/dH) (up, up + down, down)/(2 D^2)
 */
#ifndef OVR_MULTIGRID_REYNOLDS_ROW_H
#define OVR_MULTIGRID_REYNOLDS_ROW_H

#include <stdlib.h>

#include "multigrid/kernels.h"
#ifndef VEC /* or vector.h came before */
#include "base/scalar.h"
#endif

/* Values stored at half nodes; a compile-time constant in kernels. */
typedef enum row_kind {
    ROW_SUMS = 0,   /* none: sums of eps */
    ROW_STORED = 1, /* 2 E and its derivatives */
    ROW_SKEWED = 2  /* flag: temperatures skew the flow */
} row_kind;

static inline row_kind row_kind_of(const ovr_fields *f)
{
    return (f->flow ? ROW_STORED : ROW_SUMS) | (f->skew ? ROW_SKEWED : 0);
}

/* Weights of a row: a for q_i, q_{i-1} and q_{i-2}; half = 1/(2 D^2); b for
 * the flow skewed by temperature differences. */
typedef struct row_weights {
    num a[3], half, hold, b[3];
    row_kind kind;
} row_weights;

static inline row_weights row_inner(const ovr_weights *w, row_kind kind)
{
    return (row_weights){{all(w->a[0]), all(w->a[1]), all(w->a[2])},
                         all(w->half),
                         all(w->hold),
                         {all(w->skew[0]), all(w->skew[1]), all(w->skew[2])},
                         kind};
}

/* Row 1, the first of its vector, has no q_{-1}: its wedge is of first
 * order. */
static inline row_weights row_first(const ovr_weights *w, row_kind kind)
{
    row_weights c = row_inner(w, kind);
    for (int m = 0; m < 3; m++) {
        c.a[m] = with_first(c.a[m], w->first[m]);
        c.b[m] = with_first(c.b[m], w->skew_first[m]);
    }
    return c;
}

/* The flow into the cell, through its faces at i - 1/2 and i + 1/2. */
typedef struct row_faces {
    num up, down, before, after;
} row_faces;

static inline row_faces row_faces_at(const ovr_fields *f, bool stored,
                                     ptrdiff_t J)
{
    num P = at(f->P, J);
    row_faces s = {.up = at(f->P, J - 1) - P, .down = at(f->P, J + 1) - P};
    if (stored) {
        s.before = at(f->flow, J - 1);
        s.after = at(f->flow, J);
    } else {
        num eps = at(f->eps, J);
        s.before = at(f->eps, J - 1) + eps;
        s.after = eps + at(f->eps, J + 1);
    }
    return s;
}

/* Returns the weight a_m + b_m s of q at node J - m. */
static inline num row_content_weight(const ovr_fields *f, const row_weights *c,
                                     int m, ptrdiff_t J)
{
    if (!(c->kind & ROW_SKEWED))
        return c->a[m];
    num s = fused(at(f->skew_by_P, J - m), at(f->P, J - m), at(f->skew, J - m));
    return fused(c->b[m], s, c->a[m]);
}

/* Returns -dN_i/dP_{i-m} of the wedge at fixed film. */
static inline num row_wedge_by_pressure(const ovr_fields *f,
                                        const row_weights *c, int m,
                                        ptrdiff_t J)
{
    num content = row_content_weight(f, c, m, J) * at(f->dq, J - m);
    if (!(c->kind & ROW_SKEWED))
        return content;
    return fused(c->b[m] * at(f->skew_by_P, J - m), at(f->q, J - m), content);
}

/* r = F - N */
static inline num row_residual(const ovr_fields *f, const row_weights *c,
                               ptrdiff_t J)
{
    row_faces s = row_faces_at(f, c->kind & ROW_STORED, J);
    num N = c->half * (s.before * s.up + s.after * s.down) -
            row_content_weight(f, c, 0, J) * at(f->q, J) -
            row_content_weight(f, c, 1, J) * at(f->q, J - 1) -
            row_content_weight(f, c, 2, J) * at(f->q, J - 2);
    return at(f->F, J) - N;
}

/* Derivative of the outflow of a node with respect to its pressure: d of
 * reynolds.h. */
static inline num row_outflow(const ovr_fields *f, bool stored, num half,
                              ptrdiff_t J)
{
    row_faces s = row_faces_at(f, stored, J);
    return half * (s.before + s.after);
}

/*
 * True if a node stays cavitated: P = 0, and its residual would not make P
 * positive. The threshold for r exceeds rounding errors, about 1e-16 of the
 * largest term a0 q of the row. On coarse grids the residual of a cavitated
 * node is only rounding error, whose sign would select the phase at random
 * (thresholds of 1e-14 to 1e-10 all work). In W cycles, a coarse grid that is
 * solved twice moves the node at the film end back and forth for 1e-7 of a0 q;
 * for steady films the threshold there is 1e-6, and the finest grid decides.
 * The outflow d_i P_i is not a suitable scale: in the far inlet, where eps/D^2
 * is 1e10, hundreds of nodes that should become pressurized would stay
 * cavitated.
 */
static inline truth row_holds(const ovr_fields *f, num r, num hold, ptrdiff_t J)
{
    truth dry = at(f->P, J) <= 0, content = r >= -hold * at(f->q, J);
    return dry & content;
}

/* e[m + 2] without d eps/dH, m = -2..0. */
static inline void row_by_film(const ovr_fields *f, const row_weights *c,
                               ptrdiff_t J, num e[3])
{
    for (int m = 0; m < 3; m++)
        e[2 - m] = row_content_weight(f, c, m, J) * at(f->rho, J - m);
}

/* Adds the terms with d eps/dH to e[m + 2], m = -2..1. */
static inline void row_flow_by_film(const ovr_fields *f, const row_weights *c,
                                    ptrdiff_t J, num e[4])
{
    row_faces s = row_faces_at(f, c->kind & ROW_STORED, J);
    if (c->kind & ROW_STORED) {
        e[1] = less(e[1], c->half * at(f->by_left, J - 1), s.up);
        e[2] = less(
            e[2], c->half,
            fused(at(f->by_right, J - 1), s.up, at(f->by_left, J) * s.down));
        e[3] = less(e[3], c->half * at(f->by_right, J), s.down);
        return;
    }
    e[1] = less(e[1], c->half * at(f->deps_dH, J - 1), s.up);
    e[2] = less(e[2], c->half * at(f->deps_dH, J), s.up + s.down);
    e[3] = less(e[3], c->half * at(f->deps_dH, J + 1), s.down);
}

/* The elastic part of dN_i/dP_{i+d}, e without d eps/dH. */
static inline num row_elastic(const num e[3], const double *k, int d)
{
    return fused(e[2], all(k[abs(d)]),
                 fused(e[1], all(k[abs(d + 1)]), e[0] * k[abs(d + 2)]));
}

/* Derivatives with respect to the pressure where 2 E is stored. */
static INLINE void row_by_stored(const ovr_fields *f, const row_weights *c,
                                 ptrdiff_t J, num A[4])
{
    num before = at(f->out_right, J - 1), after = at(f->out_left, J);
    A[0] = less(A[0], row_content_weight(f, c, 2, J), at(f->dq, J - 2));
    A[1] = less(fused(c->half, at(f->out_left, J - 1), A[1]),
                row_content_weight(f, c, 1, J), at(f->dq, J - 1));
    A[2] = less(less(A[2], c->half, before + after),
                row_content_weight(f, c, 0, J), at(f->dq, J));
    A[3] = fused(c->half, at(f->out_right, J), A[3]);
}

/* Adds dN_i/dP_{i+d} at fixed film to A[d + 2], d = -2..1. */
static INLINE void row_by_pressure(const ovr_fields *f, const row_weights *c,
                                   ptrdiff_t J, num A[4])
{
    for (int m = 0; c->kind & ROW_SKEWED && m < 3; m++)
        A[2 - m] = less(A[2 - m], c->b[m] * at(f->skew_by_P, J - m),
                        at(f->q, J - m));
    if (c->kind & ROW_STORED) {
        row_by_stored(f, c, J, A);
        return;
    }
    row_faces s = row_faces_at(f, false, J);
    A[0] = less(A[0], row_content_weight(f, c, 2, J), at(f->dq, J - 2));
    A[1] = less(fused(c->half, fused(at(f->deps, J - 1), s.up, s.before), A[1]),
                row_content_weight(f, c, 1, J), at(f->dq, J - 1));
    A[2] = less(less(A[2], c->half,
                     less(s.before + s.after, at(f->deps, J), s.up + s.down)),
                row_content_weight(f, c, 0, J), at(f->dq, J));
    A[3] = fused(c->half, fused(at(f->deps, J + 1), s.down, s.after), A[3]);
}

#endif
