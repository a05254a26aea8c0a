/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Solution of the pentadiagonal system of the line relaxation.
 *
 *     l2_i x_{i-2} + l1_i x_{i-1} + c_i x_i + u1_i x_{i+1} + u2_i x_{i+2} = d_i
 *
 * LU without pivoting is a sequential chain of divisions. Here each lane
 * (lanes.h) is a separate partition:
 *  1. Elimination from the left within each partition.  L = the last two
 *     unknowns of the partition before stay as two columns, A and B:
 *         x_J = D - U1 x_{J+1} - U2 x_{J+2} - A L_0 - B L_1.
 *     On the way the first two unknowns are expressed by the two next ones,
 *         x_m = p - e x_J - f x_{J+1} - a L_0 - b L_1,   m = 0, 1.
 *  2. That leaves each partition's first two unknowns h and last two t in
 *     terms of t of the partition before and h of the next: block elimination
 *     over the partitions, 2x2 blocks, scalar.
 *  3. Back substitution within each partition.
 * One division per row and vector. The result agrees with the scalar LU to
 * rounding; both require a sufficiently dominant diagonal.
 *
 * Where diffusion dominates, as in the inlet on fine grids, the rows are third
 * differences, whose solutions grow as the square of the distance. The unknowns
 * of step 2 then have a relative error of about S^2 times the rounding error,
 * and residuals have peaks at the partition boundaries. Therefore
 *  4. on fine grids, and on coarser ones with a long inlet, the rows around
 *     each boundary of partitions are solved again between fixed values on both
 *     sides: its error is spread over a window w rows wide, and its third
 *     difference is w^3 times smaller.  Without it the corrections of fourth
 *     order do not converge for inlets at some -45.
 */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* One eliminated row: coefficients as above. */
typedef struct row {
    vec U1, U2, D, A, B;
} row;

/* x_m in terms of the next two unknowns */
typedef struct head {
    vec p, e, f, a, b;
} head;

typedef struct chain {
    row last, before; /* rows J - 1 and J - 2 */
    head h[2];
} chain;

/* Rows -2 and -1 are L itself. */
static inline chain begin_chain(void)
{
    const row none = {all(0), all(0), all(0), all(0), all(0)};
    const head zero = {all(0), all(0), all(0), all(0), all(0)};
    chain c = {.last = none, .before = none, .h = {zero, zero}};
    c.before.A = c.last.B = c.h[0].e = c.h[1].f = all(-1);
    return c;
}

/* U1 of the last row is available last, so it enters the division as late as
 * possible. */
static inline row eliminate(const chain *c, vec l2, vec l1, vec diagonal,
                            vec u1, vec u2, vec d)
{
    const row *a = &c->last, *b = &c->before;
    vec left = less(l1, l2, b->U1);
    vec scale = 1 / less(less(diagonal, l2, b->U2), left, a->U1);
    return (row){.U1 = less(u1, left, a->U2) * scale,
                 .U2 = u2 * scale,
                 .D = less(less(d, l2, b->D), left, a->D) * scale,
                 .A = -fused(l2, b->A, left * a->A) * scale,
                 .B = -fused(l2, b->B, left * a->B) * scale};
}

static inline head follow(head h, const row *r)
{
    return (head){.p = less(h.p, h.e, r->D),
                  .e = less(h.f, h.e, r->U1),
                  .f = -h.e * r->U2,
                  .a = less(h.a, h.e, r->A),
                  .b = less(h.b, h.e, r->B)};
}

static inline void advance(chain *c, row r)
{
    c->before = c->last;
    c->last = r;
    c->h[0] = follow(c->h[0], &r);
    c->h[1] = follow(c->h[1], &r);
}

/* The reduced system that couples the partitions. For each partition: first two
 * unknowns (m = 0, 1), then last two (m = 2, 3). */
typedef struct reduced {
    double D[4][VEC], left[4][2][VEC], right[4][2][VEC];
    double first[2][VEC + 1]; /* solution; 0 after the last partition */
    double last[2][VEC + 1];  /* solution; partition s at index s + 1, zero at
                                 index 0 */
} reduced;

static inline void end_chain(const chain *c, reduced *out)
{
    const row *l = &c->last, *b = &c->before;
    const row ends[4] = {
        {c->h[0].e, c->h[0].f, c->h[0].p, c->h[0].a, c->h[0].b},
        {c->h[1].e, c->h[1].f, c->h[1].p, c->h[1].a, c->h[1].b},
        {.U1 = less(b->U2, b->U1, l->U1),
         .U2 = -b->U1 * l->U2,
         .D = less(b->D, b->U1, l->D),
         .A = less(b->A, b->U1, l->A),
         .B = less(b->B, b->U1, l->B)},
        *l};
    for (size_t m = 0; m < 4; m++) {
        store(out->D[m], ends[m].D);
        store(out->left[m][0], ends[m].A);
        store(out->left[m][1], ends[m].B);
        store(out->right[m][0], ends[m].U1);
        store(out->right[m][1], ends[m].U2);
    }
}

typedef struct pair {
    double x, y;
} pair;

typedef struct block {
    double xx, xy, yx, yy;
} block;

/* Block of unknowns k and k + 1 of partition s. */
static block block_of(double m[4][2][VEC], size_t k, size_t s)
{
    return (block){m[k][0][s], m[k][1][s], m[k + 1][0][s], m[k + 1][1][s]};
}

static pair apply(block m, pair v)
{
    return (pair){m.xx * v.x + m.xy * v.y, m.yx * v.x + m.yy * v.y};
}

static block product(block m, block k)
{
    return (block){m.xx * k.xx + m.xy * k.yx, m.xx * k.xy + m.xy * k.yy,
                   m.yx * k.xx + m.yy * k.yx, m.yx * k.xy + m.yy * k.yy};
}

/* (I - m)^-1 */
static block resolvent(block m)
{
    double a = 1 - m.xx, d = 1 - m.yy, scale = 1 / (a * d - m.xy * m.yx);
    return (block){d * scale, m.xy * scale, m.yx * scale, a * scale};
}

/*
 * h_s = D - left t_{s-1} - right h_{s+1} and the same for t_s.  With
 * t_{s-1} = alpha - beta h_s from the left,
 *     (I - left beta) h_s = D - left alpha - right h_{s+1}.
 */
static void solve_reduced(reduced *r)
{
    pair gamma[VEC], alpha[VEC], a = {0, 0};
    block delta[VEC], beta[VEC], b = {0, 0, 0, 0};
    for (size_t s = 0; s < VEC; s++) {
        block hl = block_of(r->left, 0, s), tl = block_of(r->left, 2, s);
        block tr = block_of(r->right, 2, s), inverse;
        inverse = resolvent(product(hl, b));
        pair g = apply(hl, a), u;
        gamma[s] = apply(inverse, (pair){r->D[0][s] - g.x, r->D[1][s] - g.y});
        delta[s] = product(inverse, block_of(r->right, 0, s));
        u = apply(b, gamma[s]);
        u = apply(tl, (pair){a.x - u.x, a.y - u.y});
        b = product(tl, product(b, delta[s]));
        alpha[s] = a = (pair){r->D[2][s] - u.x, r->D[3][s] - u.y};
        beta[s] = b = (block){tr.xx + b.xx, tr.xy + b.xy, tr.yx + b.yx,
                              tr.yy + b.yy};
    }
    pair h = {0, 0}, u;
    r->first[0][VEC] = r->first[1][VEC] = 0;
    r->last[0][0] = r->last[1][0] = 0;
    for (size_t s = VEC; s-- > 0;) {
        u = apply(beta[s], h);
        r->last[0][s + 1] = alpha[s].x - u.x;
        r->last[1][s + 1] = alpha[s].y - u.y;
        u = apply(delta[s], h);
        r->first[0][s] = h.x = gamma[s].x - u.x;
        r->first[1][s] = h.y = gamma[s].y - u.y;
    }
}

static inline void keep(const ovr_band *band, ptrdiff_t J, const row *r)
{
    put(band->b[0], J, r->A);
    put(band->b[1], J, r->B);
    put(band->b[3], J, r->U1);
    put(band->b[4], J, r->U2);
    put(band->delta, J, r->D);
}

static void forward(const ovr_band *band, ptrdiff_t S, reduced *out)
{
    chain c = begin_chain();
    for (ptrdiff_t J = 0; J < S; J++) {
        row r = eliminate(&c, at(band->b[0], J), at(band->b[1], J),
                          at(band->b[2], J), at(band->b[3], J),
                          at(band->b[4], J), at(band->delta, J));
        advance(&c, r);
        keep(band, J, &r);
    }
    end_chain(&c, out);
}

static void backward(const ovr_band *band, ptrdiff_t S, const reduced *in)
{
    vec next = load(in->first[0] + 1), after = load(in->first[1] + 1);
    vec L0 = load(in->last[0]), L1 = load(in->last[1]);
    for (ptrdiff_t J = S - 1; J >= 0; J--) {
        vec x = less(at(band->delta, J), at(band->b[0], J), L0);
        x = less(x, at(band->b[1], J), L1);
        x = less(x, at(band->b[4], J), after);
        after = next;
        next = less(x, at(band->b[3], J), next);
        put(band->delta, J, next);
    }
}

/* Rows on both sides of the partition boundaries: the last HALF rows of each
 * partition and the first HALF of the next, stored in the element of the first.
 */
enum { HALF = 24, MIN = 4 * HALF, FINE = 4096 };
typedef struct window {
    vec b[5][2 * HALF], d[2 * HALF];
} window;

/* After the last partition delta = 0. */
static void copy_window(const ovr_band *band, ptrdiff_t S, window *w)
{
    for (ptrdiff_t k = 0; k < HALF; k++) {
        for (int d = 0; d < 5; d++) {
            w->b[d][k] = at(band->b[d], S - HALF + k);
            w->b[d][HALF + k] = lanes_down(at(band->b[d], k), all(d == 2));
        }
        w->d[k] = at(band->delta, S - HALF + k);
        w->d[HALF + k] = lanes_down(at(band->delta, k), all(0));
    }
}

/* The two unknowns before a window and the two after it are known. They are
 * moved to the right-hand side, so L has no columns there. */
static void solve_window(const ovr_band *band, ptrdiff_t S, const window *w)
{
    chain c = begin_chain();
    vec U1[2 * HALF], U2[2 * HALF], x[2 * HALF + 2];
    double *delta = band->delta;
    c.before.A = c.last.B = all(0);
    c.before.D = at(delta, S - HALF - 2);
    c.last.D = at(delta, S - HALF - 1);
    for (int k = 0; k < 2 * HALF; k++) {
        row r = eliminate(&c, w->b[0][k], w->b[1][k], w->b[2][k], w->b[3][k],
                          w->b[4][k], w->d[k]);
        c.before = c.last;
        c.last = r;
        U1[k] = r.U1, U2[k] = r.U2, x[k] = r.D;
    }
    x[2 * HALF] = lanes_down(at(delta, HALF), all(0));
    x[2 * HALF + 1] = lanes_down(at(delta, HALF + 1), all(0));
    for (int k = 2 * HALF - 1; k >= 0; k--)
        x[k] = less(less(x[k], U2[k], x[k + 2]), U1[k], x[k + 1]);
    for (ptrdiff_t k = 0; k < HALF; k++) {
        put(delta, S - HALF + k, x[k]);
        put(delta, k, lanes_up(at(delta, k), x[HALF + k]));
    }
}

void OVR_KERNEL(band_solve)(const ovr_lanes *g, const ovr_band *band)
{
    ptrdiff_t S = (ptrdiff_t)g->S;
    bool again = S >= MIN && (double)S * band->reach >= FINE;
    reduced system;
    window meetings;
    if (again)
        copy_window(band, S, &meetings);
    forward(band, S, &system);
    solve_reduced(&system);
    backward(band, S, &system);
    if (again)
        solve_window(band, S, &meetings);
}
