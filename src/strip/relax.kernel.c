/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Residual and distributive line relaxation of the strip.
 *
 *     N = flow_{i+1/2} - flow_{i-1/2} + flow_{j+1/2} - flow_{j-1/2}
 *         - a0 q_i - a1 q_{i-1} - a2 q_{i-2},      r = F - N
 *
 * The unknown delta_c of a node c changes P by delta_c at c and by -s_c w_m
 * delta_c at its four neighbours m, if these can change. The deformation of
 * such a change is local, so that lines can be solved separately (Jacobi
 * across).
 *
 *     s_c = 1/(1 + (e/(tau a0 rho k(0,0)))^4)
 *
 * Here e is the sum of the four E, weighted by `along` and `across`.  s_c is 1
 * where elastic deformation dominates the equation and 0 where the flow
 * dominates.  A line is a pentadiagonal system.
 *
 *     sum_d b_d delta_{i+d} = r_i,   d = -2..2,   c = i + d
 *     b_d = B_d - s_c w_left(c) B_{d-1} - s_c w_right(c) B_{d+1}
 *           + w_side(c) Q1(d) - [d = 0](w_north A_north + w_south A_south)
 *     B_d = A_d - Q0(d)
 *     Qe(d) = a0 rho_i k(d,e) + a1 rho_{i-1} k(d+1,e) + a2 rho_{i-2} k(d+2,e)
 *
 * The A_d = dN_i/dP_{i+d} are derivatives at fixed film, and k(d,e) is the
 * influence dH_i/dP_{i+d,j+e}.  Derivatives of E with respect to the film
 * thickness are neglected. Method: Gaussian elimination without pivoting,
 * starting at the inlet. P then changes by delta minus the fractions of its
 * neighbours, damped and limited to `limit`.  Negative pressures are set to
 * zero.
 *
 * A V(1,1) cycle reduces R by a factor of 3 to 5 (M = 5 to 200, Dy = 0.9 D to 5
 * D).  Source: Venner and Lubrecht (2000), Multilevel Methods in Lubrication.
 * Their weights are 1/4.  The weights 1/2 upstream and 0 downstream in steady
 * films, the smooth share and the full derivatives are new.
 *
 * Cost: 100 vector operations per vector of nodes, of which one is a division.
 */
#include "multigrid/vector.h"
#include "strip/kernels.h"
#include "strip/vectors.h"

/* Weights of row i. */
static inline const double *weights_at(const ovr_strip_weights *w, size_t i)
{
    return i == 1 ? w->first : w->a;
}

/* N of the nodes at k and the sum of their four E; neighbours are at distance
 * s. */
static inline vec row_at(const ovr_strip_fields *f, const double a[3], size_t k,
                         size_t s, size_t far, vec *along, vec *across)
{
    vec west = load(f->along + k - s), east = load(f->along + k);
    vec south = load(f->across + k - 1), north = load(f->across + k);
    vec P = load(f->P + k);
    vec N = west * (load(f->P + k - s) - P);
    N = fused(east, load(f->P + k + s) - P, N);
    N = fused(south, load(f->P + k - 1) - P, N);
    N = fused(north, load(f->P + k + 1) - P, N);
    N = less(N, all(a[0]), load(f->q + k));
    N = less(N, all(a[1]), load(f->q + k - s));
    N = less(N, all(a[2]), load(f->q + k - far));
    *along = west + east;
    *across = south + north;
    return N;
}

static inline size_t second_before(const ovr_strip_grid *g, size_t i)
{
    return i >= 2 ? 2 * g->stride : g->stride;
}

/* Clears the first and last row of the grid if they belong to the part; returns
 * the rows between them. */
static ovr_part clear_ends(const ovr_strip_grid *g, ovr_part rows, double *x)
{
    const size_t last = g->n - 1;
    for (size_t j = 0; rows.from == 0 && j < g->lines; j += VEC)
        store(x + j, all(0));
    for (size_t j = 0; rows.to > last && j < g->lines; j += VEC)
        store(x + ovr_strip_row(g, last) + j, all(0));
    return between_ends(g, rows);
}

void OVR_STRIP_KERNEL(residual)(const ovr_strip_grid *g, ovr_part rows,
                                const ovr_strip_weights *w,
                                const ovr_strip_fields *own)
{
    const ovr_strip_fields f = *own;
    vec along, across;
    rows = clear_ends(g, rows, f.r);
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            vec N = row_at(&f, weights_at(w, i), k, g->stride,
                           second_before(g, i), &along, &across);
            store(f.r + k, load(f.F + k) - N);
        }
}

/*
 * A cavitated node is an unknown if its residual would increase P by more than
 * rounding, 1e-10.
 */
void OVR_STRIP_KERNEL(choose)(const ovr_strip_grid *g, ovr_part rows,
                              const ovr_strip_weights *w,
                              const ovr_strip_smoothing *how, double k,
                              const ovr_strip_fields *own)
{
    const double least = 1e-10;
    const ovr_strip_fields f = *own;
    clear_ends(g, rows, f.moves);
    clear_ends(g, rows, f.share);
    rows = clear_ends(g, rows, f.r);
    for (size_t i = rows.from; i < rows.to; i++) {
        const double *a = weights_at(w, i);
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t at_node = ovr_strip_row(g, i) + j;
            vec along, across;
            vec N = row_at(&f, a, at_node, g->stride, second_before(g, i),
                           &along, &across);
            vec r = load(f.F + at_node) - N;
            vec elastic = a[0] * k * load(f.rho + at_node);
            vec x = fused(all(how->along), along, how->across * across) /
                    (how->tau * elastic);
            ivec wet = load(f.P + at_node) > 0;
            ivec rises = -r > least * (along + across + elastic);
            x *= x;
            store(f.r + at_node, r);
            store(f.share + at_node,
                  choose(wet, 1 / fused(x, x, all(1)), all(0)));
            store(f.moves + at_node, choose(wet | rises, all(1), all(0)));
        }
    }
}

/* Sums |r| where P should increase, and min(r, P sum E) elsewhere. */
void OVR_STRIP_KERNEL(imbalance)(const ovr_strip_grid *g, ovr_part rows,
                                 const ovr_strip_fields *own, double *sums)
{
    const ovr_strip_fields f = *own;
    const size_t s = g->stride;
    if (rows.from == 0)
        sums[0] = 0;
    if (rows.to == g->n)
        sums[g->n - 1] = 0;
    rows = between_ends(g, rows);
    for (size_t i = rows.from; i < rows.to; i++) {
        vec sum = all(0);
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            vec out = load(f.along + k - s) + load(f.along + k) +
                      load(f.across + k - 1) + load(f.across + k);
            vec r = load(f.r + k), falls = out * load(f.P + k);
            vec part = choose(r < 0, -r, choose(falls < r, falls, r));
            sum += choose(lines_before(j, g->lines), part, all(0));
        }
        sums[i] = sum_of_lanes(sum);
    }
}

/* ------------------------------------------------------------------ Lines */

enum { BAND = 2, COLUMNS = 2 * BAND + 1, KEPT = 8, MOST = 2 };

/* Fractions of the change of column c in the window: s_c w of its neighbours
 * that can change. */
typedef struct column {
    vec left, right, side, moves;
} column;

/* Arguments of a solve. */
typedef struct lines {
    const ovr_strip_grid *g;
    const ovr_strip_weights *w;
    const ovr_strip_smoothing *how;
    const double *near; /* ovr_strip_level.near */
    ovr_strip_fields f;
    double *kept; /* upper triangle: 2 numbers per node */
} lines;

static inline column column_at(const lines *a, ptrdiff_t c, size_t j)
{
    const ovr_strip_grid *g = a->g;
    if (c < 1 || c + 2 > (ptrdiff_t)g->n)
        return (column){all(0), all(0), all(0), all(0)};
    const double *moves = a->f.moves + ovr_strip_row(g, (size_t)c) + j;
    vec s = load(a->f.share + ovr_strip_row(g, (size_t)c) + j);
    return (column){.left = s * a->how->to_left * load(moves - g->stride),
                    .right = s * a->how->to_right * load(moves + g->stride),
                    .side = s * a->how->to_side *
                            (load(moves - 1) + load(moves + 1)),
                    .moves = load(moves)};
}

/* Influence at a signed offset d. */
static inline double near_at(const lines *a, int e, int d)
{
    return a->near[e * OVR_STRIP_NEAR + (d < 0 ? -d : d)];
}

/* Returns the elastic part of dN_i/dP_{i+d,j+e}.  Without `wedge` a1 and a2 are
 * zero. */
static INLINE vec elastic_at(const lines *a, bool wedge, const vec e[3],
                             int line, int d)
{
    vec sum = e[0] * near_at(a, line, d);
    if (wedge) {
        sum = fused(e[1], all(near_at(a, line, d + 1)), sum);
        sum = fused(e[2], all(near_at(a, line, d + 2)), sum);
    }
    return sum;
}

/* Row i of the linear systems of VEC lines from j on. */
static INLINE void assemble(const lines *a, bool wedge, size_t i, size_t j,
                            const column window[KEPT], vec b[COLUMNS],
                            vec *right_side)
{
    const ovr_strip_grid *g = a->g;
    const ovr_strip_fields *f = &a->f;
    const size_t s = g->stride, k = ovr_strip_row(g, i) + j;
    const double *weight = weights_at(a->w, i);
    const vec west = load(f->along_before + k - s);
    const vec east = load(f->along_after + k);
    const vec south = load(f->across_before + k - 1);
    const vec north = load(f->across_after + k);
    vec A[COLUMNS + 2],
        here = load(f->along_after + k - s) + load(f->along_before + k) +
               load(f->across_after + k - 1) + load(f->across_before + k);
    vec e[3] = {weight[0] * load(f->rho + k), all(0), all(0)};
    /* B_d at d + 3 */
    A[0] = A[1] = all(0);
    A[2] = west;
    A[3] = less(-here, all(weight[0]), load(f->dq + k));
    A[4] = east;
    A[5] = A[6] = all(0);
    if (wedge) {
        size_t far = second_before(g, i);
        A[2] = less(A[2], all(weight[1]), load(f->dq + k - s));
        A[1] = -weight[2] * load(f->dq + k - far);
        e[1] = weight[1] * load(f->rho + k - s);
        e[2] = weight[2] * load(f->rho + k - far);
    }
    UNROLL
    for (int d = -BAND - 1; d <= BAND + 1; d++)
        A[d + 3] -= elastic_at(a, wedge, e, 0, d);
    const vec moves = window[i & (KEPT - 1)].moves;
    UNROLL
    for (int d = -BAND; d <= BAND; d++) {
        const column *c = &window[(i + (size_t)(d + KEPT)) & (KEPT - 1)];
        vec v = less(A[d + 3], c->left, A[d + 2]);
        v = less(v, c->right, A[d + 4]);
        v = fused(c->side, elastic_at(a, wedge, e, 1, d), v);
        if (d == 0) {
            vec part = a->how->to_side * load(f->share + k);
            vec sides = load(f->moves + k + 1) * north;
            sides = fused(load(f->moves + k - 1), south, sides);
            v = less(v, part, sides);
        }
        b[d + BAND] = v * (moves * c->moves);
    }
    b[BAND] = choose(moves > 0, b[BAND], all(1));
    *right_side = choose(moves > 0, load(f->r + k), all(0));
}

/* Eliminates `count` groups of VEC lines from line j on; rows are assembled as
 * they are eliminated. */
static INLINE void eliminate(const lines *a, bool wedge, size_t count, size_t j)
{
    const ovr_strip_grid *g = a->g;
    column window[MOST][KEPT];
    vec u[MOST][BAND][BAND], x[MOST][BAND]; /* rows before the present one */
    UNROLL
    for (size_t v = 0; v < count; v++) {
        for (ptrdiff_t c = 1 - BAND; c < 1 + BAND; c++)
            window[v][(size_t)(c + KEPT) & (KEPT - 1)] = column_at(a, c,
                                                                   j + v * VEC);
        for (int e = 0; e < BAND; e++) {
            x[v][e] = all(0);
            for (int k = 0; k < BAND; k++)
                u[v][e][k] = all(0);
        }
    }
    for (size_t i = 1; i + 1 < g->n; i++) {
        double *kept = a->kept + i * BAND * MOST * VEC;
        UNROLL
        for (size_t v = 0; v < count; v++) {
            vec b[COLUMNS], right;
            window[v][(i + BAND) & (KEPT - 1)] = column_at(
                a, (ptrdiff_t)i + BAND, j + v * VEC);
            assemble(a, wedge, i, j + v * VEC, window[v], b, &right);
            /* Index 0 is row i - 1, index 1 is row i - 2. */
            b[1] = less(b[1], b[0], u[v][1][0]);
            b[2] = less(b[2], b[0], u[v][1][1]);
            right = less(right, b[0], x[v][1]);
            b[2] = less(b[2], b[1], u[v][0][0]);
            b[3] = less(b[3], b[1], u[v][0][1]);
            right = less(right, b[1], x[v][0]);
            vec inverse = 1 / b[2];
            u[v][1][0] = u[v][0][0];
            u[v][1][1] = u[v][0][1];
            x[v][1] = x[v][0];
            u[v][0][0] = b[3] * inverse;
            u[v][0][1] = b[4] * inverse;
            x[v][0] = right * inverse;
            store(kept + v * VEC, u[v][0][0]);
            store(kept + (MOST + v) * VEC, u[v][0][1]);
            store(a->f.delta + ovr_strip_row(g, i) + j + v * VEC, x[v][0]);
        }
    }
}

/* Back substitution for the lines that `eliminate` has treated. */
static INLINE void substitute(const lines *a, size_t count, size_t j)
{
    const ovr_strip_grid *g = a->g;
    vec next[MOST], second[MOST];
    UNROLL
    for (size_t v = 0; v < count; v++)
        next[v] = second[v] = all(0);
    for (size_t i = g->n - 2; i >= 1; i--) {
        const double *kept = a->kept + i * BAND * MOST * VEC;
        UNROLL
        for (size_t v = 0; v < count; v++) {
            double *delta = a->f.delta + ovr_strip_row(g, i) + j + v * VEC;
            vec d = less(load(delta), load(kept + v * VEC), next[v]);
            d = less(d, load(kept + (MOST + v) * VEC), second[v]);
            second[v] = next[v];
            next[v] = d;
            store(delta, d);
        }
    }
}

static INLINE void solve_group(const lines *a, bool wedge, size_t count,
                               size_t j)
{
    eliminate(a, wedge, count, j);
    substitute(a, count, j);
}

static INLINE void all_lines(const lines *a, bool wedge, ovr_part groups)
{
    size_t j = groups.from * OVR_STRIP_GROUP;
    size_t end = groups.to * OVR_STRIP_GROUP;
    if (end > a->g->lines)
        end = a->g->lines;
    for (; j + VEC < end; j += 2 * VEC)
        solve_group(a, wedge, 2, j);
    if (j < end)
        solve_group(a, wedge, 1, j);
}

void OVR_STRIP_KERNEL(solve_lines)(const ovr_strip_grid *g, ovr_part groups,
                                   const ovr_strip_weights *w,
                                   const ovr_strip_smoothing *how,
                                   const double *near,
                                   const ovr_strip_fields *f, double *work)
{
    const lines a = {g, w, how, near, *f, work};
    if (w->a[1] != 0 || w->a[2] != 0 || w->first[1] != 0)
        all_lines(&a, true, groups);
    else
        all_lines(&a, false, groups);
}

void OVR_STRIP_KERNEL(damp)(const ovr_strip_grid *g, ovr_part rows,
                            const ovr_strip_smoothing *how, int colour,
                            const ovr_strip_fields *own)
{
    const ovr_strip_fields f = *own;
    ivec odd;
    for (int l = 0; l < VEC; l++)
        odd[l] = -(l & 1);
    rows = between_ends(g, rows);
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            vec s = load(f.share + k);
            vec d = load(f.delta + k) *
                    fused(all(how->whole - how->plain), s, all(how->plain));
            if (colour == 0 || colour == 1)
                d = choose(colour ? odd : ~odd, d, all(0));
            store(f.delta + k, d);
            store(f.spread + k, s * d);
        }
}

void OVR_STRIP_KERNEL(distribute)(const ovr_strip_grid *g, ovr_part rows,
                                  const ovr_strip_smoothing *how,
                                  const ovr_strip_fields *own)
{
    const ovr_strip_fields f = *own;
    const size_t s = g->stride;
    rows = between_ends(g, rows);
    for (size_t i = rows.from; i < rows.to; i++)
        for (size_t j = 0; j < g->lines; j += VEC) {
            size_t k = ovr_strip_row(g, i) + j;
            const double *t = f.spread + k;
            vec part = how->to_side * (load(t - 1) + load(t + 1));
            part = fused(all(how->to_right), load(t - s), part);
            part = fused(all(how->to_left), load(t + s), part);
            vec d = less(load(f.delta + k), load(f.moves + k), part);
            d = smaller(all(how->limit), larger(all(-how->limit), d));
            store(f.P + k, larger(all(0), load(f.P + k) + d));
        }
}
