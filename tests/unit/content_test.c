/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation (content.h): the kernels of every instruction set
 * compared with the plain ones, and the plain ones with numerical derivatives.
 */
#include <math.h>
#include <string.h>

#include "support/kernels.h"
#include "support/test.h"

enum { N = 449 };

static const ovr_shares shares[] = {
    {-1, 0, false}, {-0.7, -0.3, true}, {-0.5, -0.5, true}};

/* ------------------------------------------------------------ sets of nodes */

static void put_set(const test_grid *b, unsigned char *set, size_t i, bool in)
{
    size_t V = b->lanes.V, place = ovr_lanes_place(&b->lanes, i);
    if (in)
        set[place / V] |= (unsigned char)(1U << place % V);
}

static void copy_set(const unsigned char *from, const test_grid *b,
                     unsigned char *to)
{
    memset(to, 0, b->lanes.S);
    for (size_t i = 0; i < b->n; i++)
        put_set(b, to, i, from[i]);
}

static void same_set(const test_grid *plain, const unsigned char *expected,
                     const test_grid *b, const unsigned char *set)
{
    for (size_t i = 0; i + 1 < plain->n; i++)
        assert_int_equal(ovr_lanes_has(&b->lanes, set, i), expected[i]);
}

/* Fields and the states that kernels begin from. */
static void copy(const test_grid *plain, const test_grid *b)
{
    test_grid_copy(plain, b);
    copy_set(plain->f.wet, b, b->f.wet);
    copy_set(plain->f.dried, b, b->f.dried);
    copy_set(plain->f.limited, b, b->f.limited);
    copy_set(plain->f.spent, b, b->f.spent);
}

static void compare(const test_grid *b, const double *x, const double *plain,
                    double tolerance)
{
    const double *here = test_grid_read(b, x);
    for (size_t i = 0; i < b->n; i++)
        CHECK_NEAR(here[i], plain[i], tolerance * (1 + fabs(plain[i])));
}

/* ------------------------------------------------------------------- fields */

/* Holes in the film, on the kink and of all contents; the inlet closed or
 * open. */
static test_grid filled(uint64_t seed, bool closed, bool skewed)
{
    test_grid b = test_grid_make(test_kernels(0), N);
    const ovr_fields *f = &b.f;
    ovr_weights *w = &b.weights;
    if (skewed)
        test_grid_skew(&b);
    test_grid_fill(&b, seed);
    memcpy(f->full, f->q, N * sizeof *f->q);
    w->out = 1 / b.D;
    w->time = -1.5;
    w->source = closed ? 7 : 0;
    for (size_t i = 1; i + 1 < N; i++) {
        double share = test_random(&seed, 0, 1.2);
        bool hole = i % 61 < 17 && share < 1.1;
        if (hole)
            f->P[i] = 0;
        f->wet[i] = f->P[i] > 0 || (i % 61 == 17);
        f->dried[i] = hole && i % 5 == 0;
        f->q[i] = f->wet[i] || i % 7 == 0 ? f->full[i] : share * f->full[i];
        f->kept[i] = test_random(&seed, 0, 2) * f->full[i];
    }
    f->wet[0] = !closed;
    return b;
}

static void settle(const test_grid *b)
{
    b->run->content_settle(&b->lanes, &b->weights, true, &b->f);
}

static void evaluate(const test_grid *b)
{
    settle(b);
    b->run->content_residual(&b->lanes, &b->weights, &b->f);
}

static void states_agree(const test_grid *plain, const test_grid *b)
{
    same_set(plain, plain->f.wet, b, b->f.wet);
    same_set(plain, plain->f.dried, b, b->f.dried);
    same_set(plain, plain->f.limited, b, b->f.limited);
    same_set(plain, plain->f.spent, b, b->f.spent);
    compare(b, b->f.q, plain->f.q, 1e-15);
    compare(b, b->f.P, plain->f.P, 1e-15);
}

static void residual_agrees(const test_grid *plain, const test_grid *b)
{
    evaluate(plain);
    evaluate(b);
    states_agree(plain, b);
    compare(b, b->f.r, plain->f.r, 1e-11);
    CHECK_CLOSE(b->run->content_imbalance(&b->lanes, &b->f),
                plain->run->content_imbalance(&plain->lanes, &plain->f), 1e-12);
}

static void relax(const test_grid *b, const ovr_shares *s)
{
    b->run->content_choose(&b->lanes, &b->weights, &b->f);
    b->run->content_assemble(&b->lanes, &b->weights, b->k, s, &b->f, &b->band);
}

static double largest(const test_grid *plain, const double *x)
{
    double size = 1;
    for (size_t i = 0; i < plain->n; i++)
        size = fmax(size, fabs(x[i]));
    return size;
}

static void rows_agree(const test_grid *plain, const test_grid *b)
{
    for (size_t i = 1; i + 1 < N; i++) {
        size_t at = ovr_lanes_place(&b->lanes, i);
        double size = 1;
        for (size_t d = 0; d < 5; d++)
            size = fmax(size, fabs(plain->band.b[d][i]));
        for (size_t d = 0; d < 5; d++)
            if (i + d > 2 && i + d < N + 1)
                CHECK_NEAR(b->band.b[d][at], plain->band.b[d][i], 1e-14 * size);
    }
}

static void line_agrees(const test_grid *plain, const test_grid *b,
                        const ovr_shares *s)
{
    relax(plain, s);
    relax(b, s);
    same_set(plain, plain->f.wet, b, b->f.wet);
    same_set(plain, plain->f.left, b, b->f.left);
    same_set(plain, plain->f.right, b, b->f.right);
    rows_agree(plain, b);
    plain->run->band_solve(&plain->lanes, &plain->band);
    for (int d = 0; d < 5; d++)
        b->run->pack(&b->lanes, plain->band.b[d], b->band.b[d]);
    b->run->pack(&b->lanes, plain->band.delta, b->band.delta);
    plain->run->content_advance(&plain->lanes, 0.05, s, &plain->band,
                                &plain->f);
    b->run->content_advance(&b->lanes, 0.05, s, &b->band, &b->f);
    compare(b, b->f.P, plain->f.P, 1e-14);
    compare(b, b->f.q, plain->f.q, 1e-14 * largest(plain, plain->band.delta));
    same_set(plain, plain->f.wet, b, b->f.wet);
    same_set(plain, plain->f.dried, b, b->f.dried);
}

TEST(sets_agree)
{
    const ovr_kernels *run;
    for (int k = 1; (run = test_kernels(k)); k++)
        for (int c = 0; c < 12; c++) {
            bool skewed = c >= 6;
            test_grid plain = filled(20 + (uint64_t)c, c & 1, skewed);
            test_grid other = test_grid_make(run, N);
            if (skewed)
                test_grid_skew(&other);
            other.weights = plain.weights;
            copy(&plain, &other);
            residual_agrees(&plain, &other);
            line_agrees(&plain, &other, &shares[c % 6 / 2]);
            ovr_arena_release(&plain.arena);
            ovr_arena_release(&other.arena);
        }
}

static void to_coarse(const test_grid *fine, const test_grid *coarse)
{
    fine->run->content_restrict(&coarse->lanes, &fine->lanes, &fine->f,
                                &coarse->f, coarse->f.r);
}

TEST(transfers_agree)
{
    const ovr_kernels *run;
    for (int k = 1; (run = test_kernels(k)); k++) {
        test_grid plain = filled(5, true, false),
                  other = test_grid_make(run, N);
        test_grid coarse = test_grid_make(test_kernels(0), N / 2 + 1);
        test_grid there = test_grid_make(run, N / 2 + 1);
        other.weights = plain.weights;
        copy(&plain, &other);
        evaluate(&plain);
        evaluate(&other);
        to_coarse(&plain, &coarse);
        to_coarse(&other, &there);
        same_set(&coarse, coarse.f.wet, &there, there.f.wet);
        same_set(&coarse, coarse.f.limited, &there, there.f.limited);
        same_set(&coarse, coarse.f.spent, &there, there.f.spent);
        compare(&there, there.f.r, coarse.f.r, 1e-11);
        for (size_t i = 0; i + 1 < coarse.n; i++)
            CHECK_NEAR(there.f.q[ovr_lanes_place(&there.lanes, i)],
                       coarse.f.q[i], 1e-15);
        ovr_arena_release(&plain.arena);
        ovr_arena_release(&other.arena);
        ovr_arena_release(&coarse.arena);
        ovr_arena_release(&there.arena);
    }
}

/* ------------------------------------------- what the plain kernels compute */

static double fluxes(const test_grid *b, size_t i)
{
    const ovr_fields *f = &b->f;
    double Q = 1.5 * f->q[i] - 0.5 * f->q[i - 1];
    double P = (f->P[i + 1] - f->P[i]) * (f->eps[i] + f->eps[i + 1]) / 2;
    if (!(f->P[i] > 0))
        Q = fmax(Q, 0.5 * f->q[i]);
    return Q - P / b->D;
}

/* Rows are differences of limited fluxes: their sum telescopes.  The weights
 * of test_grid_make have Cu = 1 and cT = 2. */
TEST(rows_telescope)
{
    test_grid b = filled(3, true, false);
    const ovr_fields *f = &b.f;
    ovr_weights *w = &b.weights;
    double sum = 0, stored = 0, size = 0;
    w->first[0] = w->a[0];
    w->first[1] = -0.5 / b.D;
    f->eps[0] = -f->eps[1];
    evaluate(&b);
    for (size_t i = 1; i + 1 < N; i++) {
        bool spent = f->P[i] <= 0 && f->kept[i] > 1.5 * f->q[i];
        assert_int_equal(f->spent[i], spent);
        sum += b.D * (f->F[i] - f->r[i]);
        stored += b.D * (spent ? 0.5 * f->q[i] + f->kept[i] : 2 * f->q[i]);
        size += b.D * fabs(f->F[i] - f->r[i]);
    }
    CHECK_NEAR(sum, b.D * w->source - fluxes(&b, N - 2) - stored, 1e-13 * size);
    ovr_arena_release(&b.arena);
}

/* Columns of cavitated nodes are the derivatives by q, exactly, because rows
 * are linear in q unless a limit changes. */
TEST(columns_of_cavitated_nodes_are_derivatives)
{
    test_grid b = filled(4, true, false);
    const ovr_fields *f = &b.f;
    double before[N];
    size_t tried = 0;
    evaluate(&b);
    relax(&b, &shares[1]);
    memcpy(before, f->r, sizeof before);
    for (size_t j = 2; j + 4 < N; j++) {
        double q = f->q[j], step = 0.25;
        if (f->wet[j])
            continue;
        f->q[j] = q + step;
        b.run->content_residual(&b.lanes, &b.weights, f);
        f->q[j] = q;
        for (size_t m = 0; m < 3; m++)
            CHECK_NEAR(b.band.b[2 - m][j + m],
                       (before[j + m] - f->r[j + m]) / step, 1e-8);
        tried++;
    }
    assert_true(tried > 50);
    ovr_arena_release(&b.arena);
}
