/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Distributive line relaxation: assembly of the pentadiagonal system and
 * application of its solution (equations in line.h; solver in band.kernel.c).
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

#include "multigrid/reynolds_row.h"

/* Data of the rows of a grid; copies, so that the compiler can assume no store
 * changes them. */
typedef struct line {
    ovr_fields f;
    double k[6];
    ovr_shares shares;
    ovr_band band;
} line;

/* Columns are processed in two parts: the first vectors, whose columns include
 * node 1, and the others. */
typedef enum stretch { LEFT_END, INSIDE } stretch;
enum { EDGE = 5 };

/* The change of node 1 is not distributed; in steady solutions neither is that
 * of a cavitated node about to become pressurized. (Constrained nodes have
 * delta = 0, as the ends have.) */
static inline void column_shares(const ovr_shares *shares, bool transient,
                                 stretch where, const unsigned char *wet,
                                 ptrdiff_t J, vec *minus, vec *plus)
{
    *minus = all(shares->minus);
    *plus = all(shares->plus);
    if (!transient) {
        ivec gives = in_set(wet, J);
        *minus = choose(gives, *minus, all(0));
        *plus = choose(gives, *plus, all(0));
    }
    if (where == LEFT_END && J == 1)
        (*minus)[0] = (*plus)[0] = 0;
}

/* A[d + 3] = dN_i/dP_{i+d}, d = -3..3: elastic band and local part, without
 * d eps/dH */
static INLINE void derivatives(const line *l, const row_weights *c, ptrdiff_t J,
                               vec A[7])
{
    vec e[3];
    row_by_film(&l->f, c, J, e);
    for (int d = -3; d <= 3; d++)
        A[d + 3] = row_elastic(e, l->k, d);
    row_by_pressure(&l->f, c, J, A + 1);
}

/* b_d = A_d + minus_{i+d} A_{d-1} + plus_{i+d} A_{d+1} */
static inline void distributed(const line *l, bool transient, stretch where,
                               ptrdiff_t J, const vec A[7], vec b[5])
{
    for (ptrdiff_t d = 0; d < 5; d++) {
        vec minus, plus;
        column_shares(&l->shares, transient, where, l->f.wet, J + d - 2, &minus,
                      &plus);
        b[d] = fused(minus, A[d], fused(plus, A[d + 2], A[d + 1]));
    }
}

/* Includes column d = -3, which is outside the band, by delta_{i-3} = 2
 * delta_{i-2} - delta_{i-1} (line.h). */
static inline void fold(const line *l, const row_weights *c, stretch where,
                        ptrdiff_t J, vec b[5])
{
    vec plus = all(l->shares.plus);
    if (where == LEFT_END && J < EDGE)
        plus = with_first(plus, 0);
    vec cut = plus * row_wedge_by_pressure(&l->f, c, 2, J);
    b[0] -= 2 * cut;
    b[1] += cut;
}

/* Computes b for shares -1, 0; additions are sufficient. */
static inline void dipoles(const unsigned char *wet, ptrdiff_t J,
                           const vec A[7], vec b[5])
{
    for (ptrdiff_t d = 0; d < 5; d++)
        b[d] = A[d + 1] - choose(in_set(wet, J + d - 2), A[d], all(0));
}

/* Rows of cavitated nodes keep P_i constant: exactly in transient steps,
 * delta_i = 0 in steady solutions. */
static inline void hold_dry(const line *l, bool transient, stretch where,
                            ptrdiff_t J, ivec dry, vec b[5])
{
    vec held[5] = {all(0), all(0), all(1), all(0), all(0)}, unused;
    if (transient) {
        column_shares(&l->shares, true, where, l->f.wet, J - 1, &unused,
                      &held[1]);
        column_shares(&l->shares, true, where, l->f.wet, J + 1, &held[3],
                      &unused);
    }
    for (size_t d = 0; d < 5; d++)
        b[d] = choose(dry, held[d], b[d]);
}

/* Assembles vector J. `kind` is a compile-time constant, unlike weights->kind.
 */
static INLINE void assemble_vector(const line *l, const row_weights *weights,
                                   row_kind kind, bool transient, stretch where,
                                   ptrdiff_t J)
{
    const ovr_band *band = &l->band;
    row_weights own = *weights, *c = &own;
    own.kind = kind;
    ivec held = in_set(l->f.held, J);
    vec A[7], b[5];
    derivatives(l, c, J, A);
    if (transient || where == LEFT_END)
        distributed(l, transient, where, J, A, b);
    else
        dipoles(l->f.wet, J, A, b);
    if (transient)
        fold(l, c, where, J, b);
    hold_dry(l, transient, where, J, held, b);
    for (size_t d = 0; d < 5; d++)
        put(band->b[d], J, b[d]);
    put(band->delta, J, choose(held, all(0), at(l->f.r, J)));
}

/* Column n - 2 is not distributed to node n - 1, whose P is zero: removes that
 * share from rows n - 4 to n - 2 if the film extends to the outlet (line.h). */
static void end_column(const line *l, const ovr_lanes *g, const row_weights *c)
{
    if (!ovr_lanes_has(g, l->f.wet, g->n - 2))
        return;
    for (size_t d = 0; d < 3; d++) { /* column n - 2 of row n - 2 - d */
        size_t place = ovr_lanes_place(g, g->n - 2 - d);
        vec A[7];
        if (ovr_lanes_has(g, l->f.held, g->n - 2 - d))
            continue;
        derivatives(l, c, (ptrdiff_t)(place / VEC), A);
        l->band.b[d + 2][place] -= l->shares.plus * A[d + 4][place % VEC];
    }
}

static INLINE void assemble(const line *l, const ovr_lanes *g,
                            const ovr_weights *w, bool transient, row_kind kind)
{
    ptrdiff_t S = (ptrdiff_t)g->S, edge = S < EDGE ? S : EDGE;
    row_weights first = row_first(w, kind), rest = row_inner(w, kind);
    assemble_vector(l, &rest, kind, transient, LEFT_END, 0);
    assemble_vector(l, &first, kind, transient, LEFT_END, 1);
    for (ptrdiff_t J = 2; J < edge; J++)
        assemble_vector(l, &rest, kind, transient, LEFT_END, J);
    for (ptrdiff_t J = edge; J < S; J++)
        assemble_vector(l, &rest, kind, transient, INSIDE, J);
    if (transient)
        end_column(l, g, &rest);
}

/* Assembles the rows with temperatures across the film; compiled once for all
 * kinds. */
static __attribute__((noinline)) void
assemble_skewed(const line *l, const ovr_lanes *g, const ovr_weights *w,
                bool transient, row_kind kind)
{
    assemble(l, g, w, transient, kind | ROW_SKEWED);
}

static INLINE void assemble_kind(const line *l, const ovr_lanes *g,
                                 const ovr_weights *w, bool transient)
{
    row_kind kind = row_kind_of(&l->f);
    if (kind & ROW_SKEWED)
        assemble_skewed(l, g, w, transient, kind);
    else if (kind == ROW_STORED)
        assemble(l, g, w, transient, ROW_STORED);
    else
        assemble(l, g, w, transient, ROW_SUMS);
}

void OVR_KERNEL(band_assemble)(const ovr_lanes *g, const ovr_weights *w,
                               const double k[6], const ovr_shares *shares,
                               const ovr_fields *f, const ovr_band *band)
{
    const line l = {.f = *f,
                    .k = {k[0], k[1], k[2], k[3], k[4], k[5]},
                    .shares = *shares,
                    .band = *band};
    if (shares->transient)
        assemble_kind(&l, g, w, true);
    else
        assemble_kind(&l, g, w, false);
    ovr_band_hold(band, 0);
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        ovr_band_hold(band, ovr_lanes_place(g, i));
}

/* P_J <- max(0, P_J + change), |change| <= limit. In transient steps a
 * constrained cavitated node keeps P = 0 exactly. */
static inline void move(const ovr_fields *f, bool transient, ptrdiff_t J,
                        vec change, double limit)
{
    change = smaller(larger(change, all(-limit)), all(limit));
    vec P = larger(at(f->P, J) + change, all(0));
    put(f->P, J, transient ? choose(in_set(f->held, J), all(0), P) : P);
}

/* Applies the change of a node: its own delta plus the shares of its
 * neighbours. */
static INLINE void distribute_lanes(ptrdiff_t S, double limit,
                                    const ovr_shares *shares, bool transient,
                                    const double *delta, const ovr_fields *f)
{
    vec before, minus, plus, next_minus, next_plus;
    column_shares(shares, transient, LEFT_END, f->wet, -1, &minus, &plus);
    before = plus * at(delta, -1);
    column_shares(shares, transient, LEFT_END, f->wet, 0, &minus, &plus);
    for (ptrdiff_t J = 0; J < S; J++) {
        vec here = at(delta, J), after = at(delta, J + 1);
        column_shares(shares, transient, LEFT_END, f->wet, J + 1, &next_minus,
                      &next_plus);
        vec change = here + next_minus * after + before;
        before = plus * here;
        plus = next_plus;
        move(f, transient, J, change, limit);
    }
}

void OVR_KERNEL(distribute)(const ovr_lanes *g, double limit,
                            const ovr_shares *shares, const ovr_band *band,
                            const ovr_fields *f)
{
    const ovr_fields own = *f;
    double *P = f->P;
    ptrdiff_t S = (ptrdiff_t)g->S;
    repeat_ends(band->delta, S, 1);
    if (shares->transient)
        distribute_lanes(S, limit, shares, true, band->delta, &own);
    else
        distribute_lanes(S, limit, shares, false, band->delta, &own);
    P[0] = 0;
    for (size_t i = g->n - 1; i <= g->S * VEC; i++)
        P[ovr_lanes_place(g, i)] = 0;
}
