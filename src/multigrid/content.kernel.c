/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation: phases, residual, line relaxation and transfer to
 * coarser grids. */
#include "multigrid/content.h"
#include "multigrid/vector.h"

#include "multigrid/content_row.h"

/* ---------------------------------------------------------- sets of nodes */

static inline void mark_node(const ovr_lanes *g, unsigned char *set, size_t i,
                             bool in)
{
    size_t place = ovr_lanes_place(g, i);
    unsigned bit = 1U << place % VEC, rest = set[place / VEC] & ~bit;
    set[place / VEC] = (unsigned char)(rest | (in ? bit : 0));
}

/* Copies the ends of lanes, as repeat_ends of vector.h does. Nodes beyond the
 * ends of the grid are in no set. */
static void repeat_set(unsigned char *set, ptrdiff_t S)
{
    const unsigned mask = (1U << VEC) - 1;
    for (ptrdiff_t J = -1; J >= -OVR_CONTENT_HALO; J--)
        set[J] = (unsigned char)((unsigned)set[S + J] << 1 & mask);
    for (ptrdiff_t J = S; J < S + OVR_CONTENT_HALO; J++)
        set[J] = set[J - S] >> 1;
}

static void drop_end(const ovr_lanes *g, unsigned char *set)
{
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        mark_node(g, set, i, false);
}

static void zero_end(const ovr_lanes *g, double *x)
{
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        x[ovr_lanes_place(g, i)] = 0;
}

/* ----------------------------------------------------- states and residual */

static inline void settle_vector(const ovr_fields *f, ptrdiff_t J)
{
    vec q = at(f->q, J), full = at(f->full, J);
    ivec wet = in_set(f->wet, J), dried = in_set(f->dried, J);
    wet |= row_overflows(q, full) & ~dried;
    put(f->q, J, choose(wet | dried, full, q));
    put_set(f->wet, J, wet);
    f->dried[J] = 0;
}

static inline void limit_vector(const ovr_weights *w, const ovr_fields *f,
                                ptrdiff_t J)
{
    vec q = at(f->q, J);
    ivec limited = at(f->q, J - 1) > 2 * q, empty = at(f->P, J) <= 0;
    ivec spent = at(f->kept, J) > -w->time * q;
    put_set(f->limited, J, limited & empty);
    put_set(f->spent, J, spent & empty);
}

void OVR_KERNEL(content_settle)(const ovr_lanes *g, const ovr_weights *w,
                                bool limits, const ovr_fields *f)
{
    const ovr_fields own = *f;
    ptrdiff_t S = (ptrdiff_t)g->S;
    for (ptrdiff_t J = 0; J < S; J++)
        settle_vector(&own, J);
    drop_end(g, own.wet);
    repeat_set(own.wet, S);
    repeat_ends(own.q, S, OVR_HALO);
    if (!limits)
        return;
    for (ptrdiff_t J = 0; J < S; J++)
        limit_vector(w, &own, J);
    mark_node(g, own.limited, 0, false);
    repeat_set(own.limited, S);
}

static INLINE void residual_vector(const ovr_weights *w, const ovr_fields *f,
                                   const row_weights *free, row_kind kind,
                                   ptrdiff_t J)
{
    row_weights c = row_limited(f, w, free, J);
    c.kind = kind; /* a compile-time constant */
    put(f->r, J, row_content_residual(f, &c, J));
}

static INLINE void residual_vectors(const ovr_weights *w, const ovr_fields *f,
                                    row_kind kind, ptrdiff_t S)
{
    row_weights first = row_first(w, kind), rest = row_inner(w, kind);
    residual_vector(w, f, &rest, kind, 0);
    residual_vector(w, f, &first, kind, 1);
    for (ptrdiff_t J = 2; J < S; J++)
        residual_vector(w, f, &rest, kind, J);
}

/* r in rows 1..n-2; zero at both ends. */
void OVR_KERNEL(content_residual)(const ovr_lanes *g, const ovr_weights *w,
                                  const ovr_fields *f)
{
    const ovr_fields own = *f;
    ptrdiff_t S = (ptrdiff_t)g->S;
    if (own.skew && own.flow) /* in both cases, whether the flow is stored
                               * because of a rheological model or not */
        residual_vectors(w, &own, ROW_STORED | ROW_SKEWED, S);
    else if (own.skew)
        residual_vectors(w, &own, ROW_SUMS | ROW_SKEWED, S);
    else if (own.flow)
        residual_vectors(w, &own, ROW_STORED, S);
    else
        residual_vectors(w, &own, ROW_SUMS, S);
    own.r[ovr_lanes_place(g, 1)] -= w->source;
    own.r[0] = 0;
    zero_end(g, own.r);
    repeat_ends(own.r, S, 1);
}

/* sum |r_i| */
double OVR_KERNEL(content_imbalance)(const ovr_lanes *g, const ovr_fields *f)
{
    vec sum = all(0);
    for (ptrdiff_t J = 0; J < (ptrdiff_t)g->S; J++) {
        vec r = at(f->r, J);
        sum += larger(r, -r);
    }
    return sum_of_lanes(sum);
}

/* --------------------------------------------------------- line relaxation */

static INLINE void restrict_sides(const ovr_fields *f, bool stored, vec half,
                                  ptrdiff_t S)
{
    for (ptrdiff_t J = 0; J < S; J++) {
        ivec wet = in_set(f->wet, J), falls = row_falls(f, J);
        ivec rises = row_rises(f, stored, half, J);
        put_set(f->wet, J, (wet & ~falls) | (~wet & rises));
    }
}

/* Decides the phase of nodes with P = 0 and q = rho H, and which columns are
 * distributed. */
void OVR_KERNEL(content_choose)(const ovr_lanes *g, const ovr_weights *w,
                                const ovr_fields *f)
{
    const ovr_fields own = *f;
    ptrdiff_t S = (ptrdiff_t)g->S;
    bool open = own.wet[0] & 1;
    if (own.flow)
        restrict_sides(&own, true, all(w->half), S);
    else
        restrict_sides(&own, false, all(w->half), S);
    mark_node(g, own.wet, 0, open);
    drop_end(g, own.wet);
    repeat_set(own.wet, S);
    for (ptrdiff_t J = 0; J < S; J++) {
        own.left[J] = own.wet[J] & own.wet[J - 1];
        own.right[J] = own.wet[J] & own.wet[J + 1];
    }
    mark_node(g, own.left, 1, false);
    repeat_set(own.left, S);
    repeat_set(own.right, S);
}

typedef struct line {
    ovr_fields f;
    ovr_weights w;
    double k[6];
    ovr_shares shares;
    ovr_band band;
} line;

/* A[d + 3] = dN_i/dP_{i+d}, d = -3..3, without d eps/dH */
static INLINE void derivatives(const line *l, const row_weights *c, ptrdiff_t J,
                               vec A[7])
{
    vec e[3];
    row_content_by_film(&l->f, c, J, e);
    for (int d = -3; d <= 3; d++)
        A[d + 3] = row_elastic(e, l->k, d);
    row_by_pressure(&l->f, c, J, A + 1);
}

/* Contribution of a pressurized node's column to a row. In steady solutions the
 * shares are -1, 0, and additions are sufficient. */
static inline vec wet_column(const line *l, bool transient, ptrdiff_t d,
                             ptrdiff_t J, const vec A[7])
{
    ivec left = in_set(l->f.left, J + d - 2);
    if (!transient)
        return A[d + 1] - within_set(left, A[d]);
    vec minus = within_set(left, all(l->shares.minus));
    vec plus = within_set(in_set(l->f.right, J + d - 2), all(l->shares.plus));
    return fused(minus, A[d], fused(plus, A[d + 2], A[d + 1]));
}

/* Includes column d = -3 (line.h), between pressurized nodes. */
static inline void fold(const line *l, const row_weights *c, ptrdiff_t J,
                        vec b[5])
{
    ivec pairs = in_set(l->f.right, J - 3) & in_set(l->f.wet, J - 1);
    vec plus = within_set(pairs, all(l->shares.plus));
    vec cut = plus * row_wedge_by_pressure(&l->f, c, 2, J);
    b[0] -= 2 * cut;
    b[1] += cut;
}

static INLINE void assemble_vector(const line *l, const row_weights *free,
                                   row_kind kind, bool transient, ptrdiff_t J)
{
    const ovr_band *band = &l->band;
    row_weights c = row_limited(&l->f, &l->w, free, J);
    c.kind = kind;
    vec A[7], b[5];
    derivatives(l, &c, J, A);
    for (ptrdiff_t d = 0; d < 5; d++) {
        vec dry = d < 3 ? -row_content_weight(&l->f, &c, 2 - (int)d, J)
                        : all(0);
        b[d] = choose(in_set(l->f.wet, J + d - 2),
                      wet_column(l, transient, d, J, A), dry);
    }
    if (transient)
        fold(l, &c, J, b);
    for (size_t d = 0; d < 5; d++)
        put(band->b[d], J, b[d]);
    put(band->delta, J, at(l->f.r, J));
}

static INLINE void assemble(const line *l, ptrdiff_t S, row_kind kind,
                            bool transient)
{
    row_weights first = row_first(&l->w, kind);
    row_weights rest = row_inner(&l->w, kind);
    assemble_vector(l, &rest, kind, transient, 0);
    assemble_vector(l, &first, kind, transient, 1);
    for (ptrdiff_t J = 2; J < S; J++)
        assemble_vector(l, &rest, kind, transient, J);
}

/* Assembles the rows with temperatures across the film; compiled once for all
 * kinds. */
static __attribute__((noinline)) void
assemble_skewed(const line *l, ptrdiff_t S, row_kind kind, bool transient)
{
    assemble(l, S, kind | ROW_SKEWED, transient);
}

static INLINE void assemble_kind(const line *l, ptrdiff_t S, bool transient)
{
    row_kind kind = row_kind_of(&l->f);
    if (kind & ROW_SKEWED)
        assemble_skewed(l, S, kind, transient);
    else if (kind == ROW_STORED)
        assemble(l, S, ROW_STORED, transient);
    else
        assemble(l, S, ROW_SUMS, transient);
}

void OVR_KERNEL(content_assemble)(const ovr_lanes *g, const ovr_weights *w,
                                  const double k[6], const ovr_shares *shares,
                                  const ovr_fields *f, const ovr_band *band)
{
    const line l = {.f = *f,
                    .w = *w,
                    .k = {k[0], k[1], k[2], k[3], k[4], k[5]},
                    .shares = *shares,
                    .band = *band};
    ptrdiff_t S = (ptrdiff_t)g->S;
    if (shares->transient)
        assemble_kind(&l, S, true);
    else
        assemble_kind(&l, S, false);
    ovr_band_hold(band, 0);
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        ovr_band_hold(band, ovr_lanes_place(g, i));
}

/* P + limited change at pressurized nodes, which become cavitated at zero; q +
 * delta at cavitated nodes. */
static inline void advance_vector(const ovr_fields *f, double limit,
                                  const ovr_shares *s, const double *delta,
                                  ptrdiff_t J)
{
    vec here = at(delta, J), P = at(f->P, J), q = at(f->q, J);
    vec minus = within_set(in_set(f->left, J + 1), all(s->minus));
    vec plus = within_set(in_set(f->right, J - 1), all(s->plus));
    vec change = fused(minus, at(delta, J + 1),
                       fused(plus, at(delta, J - 1), here));
    ivec wet = in_set(f->wet, J), stays;
    change = smaller(larger(change, all(-limit)), all(limit));
    P = within_set(wet, larger(P + change, all(0)));
    stays = P > 0;
    put(f->P, J, P);
    put(f->q, J, choose(wet, q, larger(q + here, all(0))));
    put_set(f->dried, J, wet & ~stays);
    put_set(f->wet, J, wet & stays);
}

void OVR_KERNEL(content_advance)(const ovr_lanes *g, double limit,
                                 const ovr_shares *shares, const ovr_band *band,
                                 const ovr_fields *f)
{
    const ovr_fields own = *f;
    ptrdiff_t S = (ptrdiff_t)g->S;
    bool open = own.wet[0] & 1;
    repeat_ends(band->delta, S, 1);
    for (ptrdiff_t J = 0; J < S; J++)
        advance_vector(&own, limit, shares, band->delta, J);
    mark_node(g, own.wet, 0, open);
    mark_node(g, own.dried, 0, false);
    own.P[0] = 0;
    zero_end(g, own.P);
}

/* --------------------------------------------------------- to coarser grids */

static void restrict_lanes(ptrdiff_t S, const ovr_fields *f,
                           const ovr_fields *to, double *rc)
{
    for (ptrdiff_t J = 0; J < S; J++) {
        vec r = at(f->r, 2 * J);
        put(to->q, J, at(f->q, 2 * J));
        put(rc, J,
            0.25 * (at(f->r, 2 * J - 1) + (r + r) + at(f->r, 2 * J + 1)));
        to->wet[J] = f->wet[2 * J];
        to->dried[J] = f->dried[2 * J];
        to->limited[J] = f->limited[2 * J];
        to->spent[J] = f->spent[2 * J];
    }
}

static bool has(const ovr_lanes *g, const unsigned char *set, size_t i)
{
    return ovr_lanes_has(g, set, i);
}

static void restrict_nodes(const ovr_lanes *coarse, const ovr_lanes *fine,
                           const ovr_fields *f, const ovr_fields *to,
                           double *rc)
{
    for (size_t I = 0; I + 1 < coarse->n; I++) {
        size_t i = 2 * I, at = ovr_lanes_place(coarse, I);
        to->q[at] = f->q[ovr_lanes_place(fine, i)];
        mark_node(coarse, to->wet, I, has(fine, f->wet, i));
        mark_node(coarse, to->dried, I, has(fine, f->dried, i));
        mark_node(coarse, to->limited, I, has(fine, f->limited, i));
        mark_node(coarse, to->spent, I, has(fine, f->spent, i));
        if (I)
            rc[at] = 0.25 * (f->r[ovr_lanes_place(fine, i - 1)] +
                             2 * f->r[ovr_lanes_place(fine, i)] +
                             f->r[ovr_lanes_place(fine, i + 1)]);
    }
}

/* The residual of all rows; zero at both ends. */
void OVR_KERNEL(content_restrict)(const ovr_lanes *coarse,
                                  const ovr_lanes *fine, const ovr_fields *f,
                                  const ovr_fields *to, double *rc)
{
    const ovr_fields own = *to;
    if (fine->S == 2 * coarse->S)
        restrict_lanes((ptrdiff_t)coarse->S, f, &own, rc);
    else
        restrict_nodes(coarse, fine, f, &own, rc);
    rc[0] = 0;
    zero_end(coarse, rc);
    repeat_set(own.wet, (ptrdiff_t)coarse->S);
    repeat_set(own.limited, (ptrdiff_t)coarse->S);
}
