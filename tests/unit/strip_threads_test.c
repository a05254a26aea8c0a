/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bits of a strip do not depend on the number of threads. */
#include <math.h>
#include <string.h>

#include "support/strip.h"
#include "support/strip_cases.h"
#include "support/test.h"

typedef struct variant {
    size_t n, lines;
    bool logarithmic, upstream;
    double Sigma0, sliding; /* 0: Newtonian */
    int coupling;
} variant;

static const variant variants[] = {
    {129, 32, true, false, 0, 0, 0},
    {129, 28, false, true, 0, 0, 1},
    {257, 40, true, false, 0.334, 0.5, 1},
};

static void add_features(test_strip *s, double u)
{
    s->bump[s->bumps++] = (test_bump){
        .A = -0.08, .width = 0.3, .x = -0.8, .y = 0.9, .u = u, .round = true};
    s->bump[s->bumps++] = (test_bump){
        .A = 0.01, .along = 1.1, .across = 1.5, .u = u, .grow = 1};
}

/* A steady film and some steps with so many threads. */
static test_strip *solve(const variant *v, int threads)
{
    enum { STEPS = 6 };
    ovr_strip_shape shape = test_strip_shape(v->n, v->lines);
    shape.threads = threads;
    test_strip *s = test_strip_make(20, 10, shape, NULL);
    s->strip.logarithmic = v->logarithmic;
    if (v->Sigma0 > 0) {
        s->strip.fluid.lubricant.rheology = OVR_EYRING;
        s->strip.fluid.lubricant.Sigma0 = v->Sigma0;
        s->strip.fluid.sliding = v->sliding;
    }
    add_features(s, 1 + v->sliding / 2);
    test_strip_solve(s, 1e-6);
    ovr_strip_march march;
    test_strip_march(s, &march, 1e-3);
    march.characteristic = !v->upstream;
    march.carried = 1 + v->sliding / 2;
    march.coupling = v->coupling;
    double D = test_strip_finest(s)->grid.D;
    for (int step = 1; step <= STEPS; step++) {
        ovr_strip_march_attempt(&march, step * D);
        ovr_strip_march_accept(&march);
    }
    return s;
}

static void check_same(const test_strip *a, const test_strip *b)
{
    const ovr_strip_grid *g = &test_strip_finest(a)->grid;
    assert_memory_equal(&a->strip.H0, &b->strip.H0, sizeof a->strip.H0);
    const ovr_strip_fields *f = &test_strip_finest(a)->f;
    const ovr_strip_fields *h = &test_strip_finest(b)->f;
    for (size_t i = 0; i < g->n; i++) {
        size_t row = ovr_strip_row(g, i), bytes = g->lines * sizeof *f->P;
        assert_memory_equal(f->P + row, h->P + row, bytes);
        assert_memory_equal(f->H + row, h->H + row, bytes);
        assert_memory_equal(f->q + row, h->q + row, bytes);
        assert_memory_equal(f->along + row, h->along + row, bytes);
    }
}

TEST(threads_do_not_change_bits)
{
    static const int threads[] = {2, 3, 5};
    for (size_t v = 0; v < sizeof variants / sizeof *variants; v++) {
        test_strip *one = solve(&variants[v], 1);
        for (size_t k = 0; k < sizeof threads / sizeof *threads; k++) {
            test_strip *s = solve(&variants[v], threads[k]);
            assert_int_equal(s->strip.team.members, threads[k]);
            check_same(one, s);
            test_strip_free(s);
        }
        test_strip_free(one);
    }
}
