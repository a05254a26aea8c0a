/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Plain kernels compared with independent results: cases for which a formula is
 * exact, derivatives by differences, small cases by direct calculation. Errors
 * that they share with the vector kernels are found in this way. */
#include <math.h>
#include <string.h>

#include "support/kernels.h"
#include "support/test.h"

enum { N = 449 };

static test_grid make(void)
{
    return test_grid_make(test_kernels(0), N);
}

/* r = F - (eps P')' + q' + cT q, exactly where eps and q are linear and P is a
 * parabola; the first row's wedge is of first order. */
TEST(residual_is_exact_for_a_parabola)
{
    test_grid b = make();
    const ovr_fields *f = &b.f;
    for (size_t i = 0; i < N; i++) {
        double X = (double)i * b.D;
        f->P[i] = X * X, f->eps[i] = 2 + X, f->q[i] = 1 + X, f->F[i] = sin(X);
    }
    b.run->residual(&b.lanes, &b.weights, f);
    for (size_t i = 1; i < N - 1; i++) {
        double X = (double)i * b.D, flow = 4 + 4 * X;
        CHECK_NEAR(f->r[i], sin(X) - flow + 1 + 2 * (1 + X), 1e-9);
    }
    assert_true(f->r[0] == 0 && f->r[N - 1] == 0);
    ovr_arena_release(&b.arena);
}

/* Residual of a row with a pressure that should rise, and that should fall from
 * a large and from a small value. */
TEST(imbalance_by_hand)
{
    double P[] = {0, 0, 5, 0.125, 0}, eps[] = {1, 2, 3, 4, 5};
    double r[] = {0, -7, 3, 11, 0};
    const ovr_fields f = {.P = P, .eps = eps, .r = r};
    const ovr_weights w = {.half = 0.5};
    const ovr_lanes g = {5, 4, 1};
    assert_true(test_kernels(0)->imbalance(&g, &w, &f) == 7 + 3 + 0.125 * 8);
}

/* Share of a change at node j; node 1 and, in steady films, a cavitated node
 * share nothing. */
static double share(const test_grid *b, double value, bool transient, size_t j)
{
    bool gives = j > 1 && j < N - 1 && (transient || b->f.P[j] > 0);
    return gives ? value : 0;
}

/* A change of P at j-1, j, j+1. */
typedef struct nudge {
    size_t j;
    double by[3];
} nudge;

/* -N of P + s c about its nodes, in `moved`: properties follow P, the film
 * that flows stays, the film in q follows by the deformation. */
static void move(const test_grid *b, const nudge *c, double s,
                 const test_grid *moved)
{
    const ovr_fields *f = &moved->f;
    memcpy(f->P, b->f.P, N * sizeof(double));
    for (size_t m = 0; m < 3; m++)
        f->P[c->j + m - 1] += s * c->by[m];
    test_grid_film(b, f);
    for (size_t i = c->j > 4 ? c->j - 4 : 0; i < N && i <= c->j + 2; i++)
        for (size_t m = 0; m < 3; m++) {
            size_t at = c->j + m - 1, d = i < at ? at - i : i - at;
            f->q[i] -= f->rho[i] * s * c->by[m] * b->k[d];
        }
    b->run->residual(&b->lanes, &b->weights, f);
}

/* dN_i/ds for i = j-2..j+2. */
static void derivatives(const test_grid *b, const test_grid *work,
                        const nudge *c, double result[5])
{
    const double s = 1e-6;
    double up[5] = {0}, down[5] = {0};
    for (int sign = -1; sign <= 1; sign += 2) {
        move(b, c, sign * s, work);
        for (size_t d = 0; d < 5; d++)
            if (c->j + d >= 2 && c->j + d < N + 2)
                (sign < 0 ? down : up)[d] = work->f.r[c->j + d - 2];
    }
    for (size_t d = 0; d < 5; d++)
        result[d] = (down[d] - up[d]) / (2 * s);
}

/* True for a cavitated node that remains cavitated, within rounding. */
static bool held(const test_grid *b, size_t i)
{
    return b->f.P[i] <= 0 && b->f.r[i] >= 0;
}

/* What row i loses with column i - 3 in time: the share of delta_{i-3} times
 * dN_i/dP_{i-2} with the film as it is. */
static double lost(const test_grid *b, const test_grid *work,
                   const ovr_shares *s, size_t i)
{
    const double step = 1e-6;
    double by_P = 0;
    if (!s->transient || i < 4)
        return 0;
    for (int sign = -1; sign <= 1; sign += 2) {
        memcpy(work->f.P, b->f.P, N * sizeof(double));
        work->f.P[i - 2] += sign * step;
        b->run->film(&b->fluid, 0, &b->lanes, b->gap, b->w, &work->f);
        double a = b->weights.a[2];
        if (b->f.skew)
            a += b->weights.skew[2] *
                 (b->f.skew[i - 2] + b->f.skew_by_P[i - 2] * work->f.P[i - 2]);
        by_P -= sign * a * work->f.q[i - 2] / (2 * step);
    }
    return by_P * share(b, s->plus, s->transient, i - 3);
}

/* Column j of the system is the derivative by delta_j in rows that are not
 * held, with what they lose put on delta_{i-2} and delta_{i-1} by the line
 * through these. */
static void check_column(const test_grid *b, const test_grid *work,
                         const ovr_shares *s, size_t j)
{
    double minus = share(b, s->minus, s->transient, j);
    double plus = share(b, s->plus, s->transient, j), by_delta[5];
    if (s->transient && j == N - 2 && b->f.P[j] > 0) /* P_{N-1} = 0 stays */
        plus = 0;
    derivatives(b, work, &(nudge){j, {minus, 1, plus}}, by_delta);
    for (size_t d = 0; d < 5; d++) {
        size_t i = j + d - 2;
        double size = 1;
        if (j + d < 3 || i > N - 2 || held(b, i))
            continue;
        for (size_t e = 0; e < 5; e++)
            size = fmax(size, fabs(b->band.b[e][i]));
        if (d > 2)
            by_delta[d] += (d == 4 ? 2 : -1) * lost(b, work, s, i);
        CHECK_NEAR(b->band.b[4 - d][i], by_delta[d], 1e-7 * size);
    }
}

/* The row of a constrained node is dP_i = 0; in steady films delta_i = 0. */
static void check_held(const test_grid *b, const ovr_shares *s, size_t i)
{
    double before = share(b, s->plus, s->transient, i - 1);
    double after = share(b, s->minus, s->transient, i + 1);
    const double row[5] = {0, s->transient ? before : 0, 1,
                           s->transient ? after : 0, 0};
    bool dry = held(b, i);
    assert_true(b->band.delta[i] == (dry ? 0 : b->f.r[i]));
    assert_true(b->f.held[i] == dry && b->f.wet[i] == (b->f.P[i] > 0));
    for (int d = 0; dry && d < 5; d++)
        assert_true(b->band.b[d][i] == row[d]);
}

/* What becomes of P_i. */
static void check_change(const test_grid *b, const ovr_shares *s, double limit,
                         const double *P, size_t i)
{
    const double *delta = b->band.delta;
    double change = delta[i] +
                    share(b, s->minus, s->transient, i + 1) * delta[i + 1] +
                    share(b, s->plus, s->transient, i - 1) * delta[i - 1];
    change = fmax(-limit, fmin(limit, change));
    bool stays = s->transient && held(b, i);
    CHECK_NEAR(P[i], stays ? 0 : fmax(0, b->f.P[i] + change), 1e-15);
}

/* The rows of the system and the use of its solution, with means between nodes
 * by the gap or arithmetic, with a flow that temperatures skew or without. */
static void line_is_as(bool gap, bool skewed)
{
    static const ovr_shares shares[] = {
        {-1, 0, false}, {-0.7, -0.3, true}, {-0.5, -0.5, true}};
    static double P[N];
    test_grid b = make(), work = make();
    if (gap) {
        test_grid_gap(&b);
        test_grid_gap(&work);
    }
    if (skewed) {
        test_grid_skew(&b);
        work.f.skew = b.f.skew;
        work.f.skew_by_P = b.f.skew_by_P;
    }
    for (const ovr_shares *s = shares; s < shares + 3; s++) {
        int dry = 0;
        test_grid_fill(&b, 10);
        b.run->band_assemble(&b.lanes, &b.weights, b.k, s, &b.f, &b.band);
        for (size_t i = 1; i < N - 1; i++) {
            check_column(&b, &work, s, i);
            check_held(&b, s, i);
            dry += held(&b, i);
        }
        assert_true(dry > 5);
        b.run->band_solve(&b.lanes, &b.band);
        ovr_fields moved = b.f;
        moved.P = memcpy(P, b.f.P, sizeof P);
        b.run->distribute(&b.lanes, 0.05, s, &b.band, &moved);
        for (size_t i = 1; i < N - 1; i++)
            check_change(&b, s, 0.05, P, i);
        assert_true(P[0] == 0 && P[N - 1] == 0);
    }
    ovr_arena_release(&b.arena);
    ovr_arena_release(&work.arena);
}

TEST(line_is_as_defined)
{
    for (int kind = 0; kind < 4; kind++)
        line_is_as(kind & 1, kind & 2);
}

/* Three pressurized nodes, then a cavitated one between pressurized ones. */
TEST(restriction_by_hand)
{
    double P[] = {0, 1, 2, 5, 4, 0, 6, 7, 0}, H[] = {9, 8, 7, 6, 5, 4, 3, 2, 1};
    double r[] = {0, 8, 8, 8, 8, 100, 8, 8, 0};
    unsigned char wet[] = {0, 1, 1, 1, 1, 0, 1, 1, 0};
    const ovr_fields f = {.P = P, .H = H, .r = r, .wet = wet};
    double Pc[5], entry[5], Hc[5], rc[5];
    const ovr_lanes fine = {9, 8, 1}, coarse = {5, 4, 1};
    const double expected_P[] = {0, 2.5, 4, 6, 0},
                 expected_H[] = {9, 7, 5, 3, 1};
    const double expected_r[] = {0, 8, 6, 6, 0};
    test_kernels(0)->restrict_fields(&coarse, &fine, &f, Pc, entry, Hc, rc);
    assert_memory_equal(Pc, expected_P, sizeof Pc);
    assert_memory_equal(entry, expected_P, sizeof Pc);
    assert_memory_equal(Hc, expected_H, sizeof Hc);
    assert_memory_equal(rc, expected_r, sizeof rc);
}

/* Half of a correction 0, 2, 4, -20, 0: linear between coarse nodes, nothing
 * at dry ones, no pressure below zero. */
TEST(correction_by_hand)
{
    double P[] = {0, 1, 2, 0, 4, 5, 6, 7, 0};
    unsigned char wet[] = {0, 1, 1, 0, 1, 1, 1, 1, 0};
    const ovr_fields f = {.P = P, .wet = wet};
    const double Pc[] = {0, 3, 7, -11, 0}, entry[] = {0, 1, 3, 9, 0};
    const double expected[] = {0, 1.5, 3, 0, 6, 1, 0, 2, 0};
    const ovr_lanes fine = {9, 8, 1}, coarse = {5, 4, 1};
    test_kernels(0)->correct(&coarse, &fine, 0.5, Pc, entry, &f);
    assert_memory_equal(P, expected, sizeof P);
}

TEST(coarse_side_by_hand)
{
    double gap[] = {5, 6, 7}, r[] = {1, 2, 3}, F[3];
    const double w[] = {1, 2, 4}, residual[] = {10, 20, 40};
    const ovr_lanes g = {3, 2, 1};
    const ovr_kernels *run = test_kernels(0);
    run->coarse_gap(&g, 3, w, gap);
    run->coarse_side(&g, residual, F, r);
    assert_memory_equal(gap, ((double[]){3, 5, 8}), sizeof gap);
    assert_memory_equal(F, ((double[]){9, 18, 37}), sizeof F);
    assert_memory_equal(r, residual, sizeof r);
    assert_true(run->sum(&g, residual) == 70);
    run->combine(3, 2, w, -1, residual, r);
    assert_memory_equal(r, ((double[]){-8, -16, -32}), sizeof r);
}
