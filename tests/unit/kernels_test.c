/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Kernels of every instruction set compared with the plain ones on the same
 * fields: equal within rounding. plain_test.c tests the plain kernels
 * independently; film_test.c, scan_test.c, dense_test.c and guess_test.c test
 * films, scans, the dense solver and the extrapolation. */
#include <math.h>
#include <string.h>

#include "support/kernels.h"
#include "support/test.h"

enum { N = 449 };

/* Compares x, an array of `of`, with the plain one. */
static void compare(const test_grid *of, const double *x, const double *plain,
                    double tolerance)
{
    const double *here = test_grid_read(of, x);
    for (size_t i = 0; i < of->n; i++)
        CHECK_NEAR(here[i], plain[i], tolerance);
}

typedef void check(const test_grid *plain, const test_grid *other);

enum { MEANS = 3, THIN = 1, SKEW = 2, KINDS = 4 };

static void on_set(const ovr_kernels *run, int mean, int kind, check *agree)
{
    test_grid plain = test_grid_make(test_kernels(0), N);
    test_grid other = test_grid_make(run, N);
    if (mean == 1) {
        test_grid_gap(&plain);
        test_grid_gap(&other);
    } else if (mean == 2) {
        test_grid_logarithmic(&plain);
        test_grid_logarithmic(&other);
    }
    if (kind & THIN) {
        test_grid_thin(&plain, 0.2, 0.4);
        test_grid_thin(&other, 0.2, 0.4);
    }
    if (kind & SKEW) {
        test_grid_skew(&plain);
        test_grid_skew(&other);
    }
    test_grid_fill(&plain, 9);
    test_grid_copy(&plain, &other);
    agree(&plain, &other);
    ovr_arena_release(&plain.arena);
    ovr_arena_release(&other.arena);
}

/* The check on every set of vectors, from filled fields, with means of each
 * kind, without and with a flow law and a skewed flow. */
static void on_every_set(check *agree)
{
    const ovr_kernels *run;
    for (int k = 1; (run = test_kernels(k)); k++) {
        for (int kind = 0; kind < MEANS * KINDS; kind++)
            on_set(run, kind % MEANS, kind / MEANS, agree);
    }
}

/* Every node where lanes.h says, what the neighbours hold in the halos, and
 * back again; lanes that divide the grid or do not. */
TEST(lanes_hold_the_nodes)
{
    static const size_t nodes[] = {15, 29, 57, 113, 449};
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++)
        for (size_t m = 0; m < 5; m++) {
            test_grid b = test_grid_make(run, nodes[m]);
            size_t S = b.lanes.S, V = b.lanes.V, n = b.n;
            double from[N];
            for (size_t i = 0; i < n; i++)
                from[i] = 1 + (double)i;
            run->pack(&b.lanes, from, b.f.F);
            for (size_t i = 0; i + 1 < n; i++)
                assert_true(b.f.F[i % S * V + i / S] == 1 + (double)i);
            assert_true(b.f.F[ovr_lanes_place(&b.lanes, n - 1)] == (double)n);
            for (size_t i = S; i + 1 < n; i += S) {
                assert_true((b.f.F - V)[i / S] == (double)i);
                assert_true((b.f.F - 2 * V)[i / S] == (double)i - 1);
                assert_true((b.f.F + S * V)[i / S - 1] == 1 + (double)i);
            }
            assert_memory_equal(from, test_grid_read(&b, b.f.F),
                                n * sizeof(double));
            ovr_arena_release(&b.arena);
        }
}

static void residual_agrees(const test_grid *plain, const test_grid *other)
{
    const double *F = plain->f.F, *r = plain->f.r, *here;
    double imbalance = plain->run->imbalance(&plain->lanes, &plain->weights,
                                             &plain->f);
    memset(other->f.r, 0, N * sizeof(double));
    other->run->residual(&other->lanes, &other->weights, &other->f);
    here = test_grid_read(other, other->f.r);
    for (size_t i = 0; i < N; i++)
        CHECK_NEAR(here[i], r[i], 1e-13 * (fabs(F[i] - r[i]) + 1));
    assert_true(here[0] == 0 && here[N - 1] == 0);
    CHECK_CLOSE(
        other->run->imbalance(&other->lanes, &other->weights, &other->f),
        imbalance, 1e-12);
}

TEST(residuals_agree)
{
    on_every_set(residual_agrees);
}

static const ovr_shares shares[] = {
    {-1, 0, false}, {-0.7, -0.3, true}, {-0.5, -0.5, true}};

static void assemble(const test_grid *b, const ovr_shares *s)
{
    b->run->band_assemble(&b->lanes, &b->weights, b->k, s, &b->f, &b->band);
}

/* Of row i; columns of the ends, where delta is zero, may hold anything. */
static void row_agrees(const test_grid *plain, const test_grid *other, size_t i)
{
    size_t at = ovr_lanes_place(&other->lanes, i);
    double size = 1;
    for (size_t d = 0; d < 5; d++)
        size = fmax(size, fabs(plain->band.b[d][i]));
    for (size_t d = 0; d < 5; d++)
        if (i + d > 2 && i + d < N + 1)
            CHECK_NEAR(other->band.b[d][at], plain->band.b[d][i], 1e-14 * size);
    assert_true(other->band.delta[at] == plain->band.delta[i]);
    assert_true(ovr_lanes_has(&other->lanes, other->f.held, i) ==
                plain->f.held[i]);
    assert_true(ovr_lanes_has(&other->lanes, other->f.wet, i) ==
                plain->f.wet[i]);
}

static double largest(const test_grid *plain, const double *x)
{
    double size = 1;
    for (size_t i = 0; i < plain->n; i++)
        size = fmax(size, fabs(x[i]));
    return size;
}

/* The rows of the system, its solution (rounding of the largest times what the
 * rows of fine grids make of it), and the use of that. */
static void line_agrees(const test_grid *plain, const test_grid *other)
{
    for (int k = 0; k < 3; k++) {
        test_grid_fill(plain, 10);
        test_grid_copy(plain, other);
        assemble(plain, &shares[k]);
        assemble(other, &shares[k]);
        for (size_t i = 1; i < N - 1; i++)
            row_agrees(plain, other, i);
        test_grid_copy(plain, other);
        plain->run->band_solve(&plain->lanes, &plain->band);
        other->run->band_solve(&other->lanes, &other->band);
        compare(other, other->band.delta, plain->band.delta,
                1e-9 * largest(plain, plain->band.delta));
        test_grid_copy(plain, other);
        plain->run->distribute(&plain->lanes, 0.05, &shares[k], &plain->band,
                               &plain->f);
        other->run->distribute(&other->lanes, 0.05, &shares[k], &other->band,
                               &other->f);
        compare(other, other->f.P, plain->f.P, 1e-15);
        assert_true(test_grid_read(other, other->f.P)[0] == 0);
        assert_true(test_grid_read(other, other->f.P)[N - 1] == 0);
    }
}

TEST(lines_agree)
{
    on_every_set(line_agrees);
}

/* What the solver leaves of the rows it was given. */
TEST(band_solver_solves_the_band)
{
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        test_grid plain = test_grid_make(test_kernels(0), N);
        test_grid b = test_grid_make(run, N);
        const ovr_band *band = &plain.band;
        test_grid_fill(&plain, 10);
        assemble(&plain, &shares[1]);
        test_grid_copy(&plain, &b);
        run->band_solve(&b.lanes, &b.band);
        const double *x = test_grid_read(&b, b.band.delta);
        for (size_t i = 0; i < N; i++) {
            double sum = -band->delta[i], size = fabs(sum);
            for (size_t d = 0; d < 5; d++)
                if (i + d >= 2 && i + d - 2 < N) {
                    double term = band->b[d][i] * x[i + d - 2];
                    sum += term;
                    size += fabs(term);
                }
            CHECK_NEAR(sum, 0, 1e-12 * size + 1e-300);
        }
        ovr_arena_release(&plain.arena);
        ovr_arena_release(&b.arena);
    }
}

/* On a grid so fine that the rows where lanes meet are solved once more. */
TEST(band_solver_solves_long_lanes)
{
    const size_t n = ((size_t)7 << 15) + 1;
    const ovr_kernels *run;
    uint64_t seed = 14;
    test_grid plain = test_grid_make(test_kernels(0), n);
    for (int k = 0; (run = test_kernels(k)); k++) {
        test_grid w = test_grid_make(run, n);
        double *const *row = plain.band.b, *rhs = plain.band.delta;
        for (size_t i = 0; i < n; i++) {
            bool end = i == 0 || i == n - 1;
            for (int d = 0; d < 5; d++)
                row[d][i] = end      ? d == 2
                            : d == 2 ? 4
                                     : test_random(&seed, -1, 1);
            rhs[i] = end ? 0 : test_random(&seed, -1, 1);
        }
        test_grid_copy(&plain, &w);
        run->band_solve(&w.lanes, &w.band);
        const double *x = test_grid_read(&w, w.band.delta);
        for (size_t i = 2; i + 2 < n; i++) {
            double sum = 0;
            for (size_t d = 0; d < 5; d++)
                sum += row[d][i] * x[i + d - 2];
            CHECK_NEAR(sum, rhs[i], 1e-14);
        }
        ovr_arena_release(&w.arena);
    }
    ovr_arena_release(&plain.arena);
}

static void restrict_to(const test_grid *fine, const test_grid *coarse)
{
    fine->run->restrict_fields(&coarse->lanes, &fine->lanes, &fine->f,
                               coarse->f.P, coarse->f.q, coarse->f.H,
                               coarse->f.r);
}

static void correct(const test_grid *coarse, const test_grid *fine)
{
    fine->run->correct(&coarse->lanes, &fine->lanes, 0.5, coarse->f.P,
                       coarse->f.q, &fine->f);
}

/* From a fine grid [0] to a coarse one [1] and back. */
static void transfer_agrees(const ovr_kernels *run, size_t n)
{
    test_grid plain[2], other[2];
    for (size_t k = 0; k < 2; k++) {
        plain[k] = test_grid_make(test_kernels(0), n / (k + 1) + k);
        other[k] = test_grid_make(run, n / (k + 1) + k);
    }
    const ovr_fields *p = &plain[1].f, *o = &other[1].f;
    test_grid_fill(&plain[0], 13);
    for (size_t i = 5; i < n; i += 5) /* cavitated nodes of both kinds */
        plain[0].f.P[i] = 0;
    memcpy(plain[0].f.r + 1, plain[0].f.F + 1, (n - 2) * sizeof(double));
    plain[0].run->phase(&plain[0].lanes, &plain[0].weights, &plain[0].f);
    test_grid_copy(&plain[0], &other[0]);
    restrict_to(&plain[0], &plain[1]);
    restrict_to(&other[0], &other[1]);
    compare(&other[1], o->P, p->P, 1e-15);
    compare(&other[1], o->q, p->q, 1e-15);
    compare(&other[1], o->H, p->H, 0);
    compare(&other[1], o->r, p->r, 1e-15);
    for (size_t I = 1; I + 1 < plain[1].n; I++)
        p->P[I] += 0.01 * sin((double)I);
    test_grid_copy(&plain[1], &other[1]);
    correct(&plain[1], &plain[0]);
    correct(&other[1], &other[0]);
    compare(&other[0], other[0].f.P, plain[0].f.P, 1e-15);
    for (size_t k = 0; k < 2; k++) {
        ovr_arena_release(&plain[k].arena);
        ovr_arena_release(&other[k].arena);
    }
}

TEST(transfers_agree)
{
    static const size_t nodes[] = {29, 57, 113, N};
    const ovr_kernels *run;
    for (int k = 1; (run = test_kernels(k)); k++)
        for (size_t m = 0; m < 4; m++)
            transfer_agrees(run, nodes[m]);
}

static void gap_and_side(const test_grid *b)
{
    b->run->coarse_gap(&b->lanes, 0.3, b->f.q, b->gap);
    b->run->coarse_side(&b->lanes, b->f.H, b->f.F, b->f.r);
}

/* The arrays of coarse grids; ends that nothing reads may differ. */
static void coarse_fields_agree(const test_grid *plain, const test_grid *other)
{
    double here[N], there[N];
    gap_and_side(plain);
    gap_and_side(other);
    plain->f.F[N - 1] = test_grid_read(other, other->f.F)[N - 1];
    plain->f.r[N - 1] = test_grid_read(other, other->f.r)[N - 1];
    compare(other, other->gap, plain->gap, 1e-15);
    compare(other, other->f.F, plain->f.F, 0);
    compare(other, other->f.r, plain->f.r, 0);
    CHECK_CLOSE(other->run->sum(&other->lanes, other->f.P),
                plain->run->sum(&plain->lanes, plain->f.P), 1e-14);
    plain->run->combine(N, 0.3, plain->f.H, -2, plain->f.P, there);
    other->run->combine(N, 0.3, plain->f.H, -2, plain->f.P, here);
    for (size_t i = 0; i < N; i++)
        CHECK_NEAR(here[i], there[i], 1e-15);
}

TEST(coarse_grids_agree)
{
    on_every_set(coarse_fields_agree);
}

/* Results of all kernels of a sweep, in the order of the nodes. */
typedef struct swept {
    double deformation[N], eps[N], P[N], imbalance;
} swept;

static void sweep(const ovr_kernels *run, swept *s)
{
    test_grid plain = test_grid_make(test_kernels(0), N);
    test_grid b = test_grid_make(run, N);
    test_grid_fill(&plain, 11);
    test_grid_copy(&plain, &b);
    run->deformation(&b.mlmi, b.f.P, b.f.q);
    memcpy(s->deformation, test_grid_read(&b, b.f.q), sizeof s->deformation);
    run->film(&b.fluid, 0, &b.lanes, b.gap, b.w, &b.f);
    run->residual(&b.lanes, &b.weights, &b.f);
    s->imbalance = run->imbalance(&b.lanes, &b.weights, &b.f);
    assemble(&b, &shares[0]);
    run->band_solve(&b.lanes, &b.band);
    run->distribute(&b.lanes, 0.1, &shares[0], &b.band, &b.f);
    memcpy(s->P, test_grid_read(&b, b.f.P), sizeof s->P);
    memcpy(s->eps, test_grid_read(&b, b.f.eps), sizeof s->eps);
    ovr_arena_release(&plain.arena);
    ovr_arena_release(&b.arena);
}

/* Any two of plain loops, baseline, AVX2 and AVX-512 differ by rounding. */
TEST(instruction_sets_agree)
{
    static swept s[4];
    for (int k = 0; test_kernels(k); k++) {
        sweep(test_kernels(k), &s[k]);
        for (int m = 0; m < k; m++) {
            CHECK_CLOSE(s[k].imbalance, s[m].imbalance, 1e-12);
            for (size_t i = 0; i < N; i++) {
                CHECK_NEAR(s[k].deformation[i], s[m].deformation[i], 1e-14);
                CHECK_NEAR(s[k].P[i], s[m].P[i], 1e-9);
                CHECK_CLOSE(s[k].eps[i], s[m].eps[i], 1e-14);
            }
        }
    }
}

TEST(sets_are_chosen_by_name)
{
    assert_null(ovr_kernels_choose("mmx"));
    assert_non_null(ovr_kernels_choose("base"));
    assert_non_null(ovr_kernels_choose("plain"));
    assert_true(ovr_kernels_choose(NULL)->lanes > 1);
}
