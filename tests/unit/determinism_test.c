/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The same input gives the same bits, and on other instruction sets the same
 * numbers within 1e-9. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"
#include "support/test.h"

enum { LEVEL = 6, NODES = 7 * 64 + 1, STEPS = 60 };

typedef struct ending {
    double P[NODES], H[NODES], H0;
    int cycles;
} ending;

/* A dent at a load that needs the continuation; false: not on this machine. */
static bool run_on(const char *kernels, double M, ending *end)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    test_feature dent = {'l', -0.02, 0.5, -1.2, 1, 0};
    ovr_march march = {.end = STEPS * 5.5 / (NODES - 1)};
    o.level = LEVEL;
    ovr_simulation *sim = test_simulation(M, 10, &o);
    const ovr_kernels *set = ovr_kernels_choose(kernels);
    bool here = set != NULL;
    if (here) {
        ovr_hierarchy_kernels(&sim->grids, set);
        ovr_simulation_surface(sim, test_feature_heights, &dent);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
        const ovr_state *s = ovr_simulation_state(sim);
        assert_int_equal(s->n, NODES);
        memset(end, 0, sizeof *end);
        memcpy(end->P, s->P, sizeof end->P);
        memcpy(end->H, s->H, sizeof end->H);
        end->H0 = s->H0;
        end->cycles = (int)ovr_simulation_statistics(sim)->cycles;
    }
    ovr_simulation_free(sim);
    return here;
}

TEST(same_bits_again)
{
    static ending first, again;
    assert_true(run_on(NULL, 20, &first) && run_on(NULL, 20, &again));
    assert_memory_equal(&first, &again, sizeof first);
    assert_true(run_on(NULL, 100, &first) && run_on(NULL, 100, &again));
    assert_memory_equal(&first, &again, sizeof first);
}

static ovr_status count(void *data, const ovr_simulation *sim, ovr_error *err)
{
    (void)sim, (void)err;
    ++*(int *)data;
    return OVR_OK;
}

static ovr_simulation *started(void)
{
    static test_feature dent = {'l', -0.02, 0.5, -1.2, 1, 0};
    ovr_error err = {0};
    ovr_options o = test_options();
    o.level = 5;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

/* A loop of one's own takes the steps of a march, adaptive ones too, and asks
 * its observers as often. */
TEST(same_bits_step_by_step)
{
    for (int adaptive = 0; adaptive < 2; adaptive++) {
        int asked[2] = {0};
        bool more = true;
        ovr_error err = {0};
        ovr_observer one = {count, NULL, &asked[0]};
        ovr_march march = {
            .end = 0.7, .count = 1, .adaptive = adaptive, .observers = &one};
        ovr_simulation *a = started(), *b = started();
        const ovr_state *s = ovr_simulation_state(a);
        const ovr_state *t = ovr_simulation_state(b);
        CHECK_OK(ovr_simulation_march(a, &march, &err), &err);
        one.data = &asked[1];
        while (more)
            CHECK_OK(ovr_simulation_advance(b, &march, &more, &err), &err);
        assert_int_equal(asked[0], asked[1] + 1); /* at the start too */
        assert_int_equal(s->step, t->step);
        assert_memory_equal(s->P, t->P, s->n * sizeof *s->P);
        CHECK_OK(ovr_simulation_advance(b, &march, &more, &err), &err);
        assert_false(more);
        assert_int_equal(s->step, t->step);
        march.dT = NAN;
        assert_int_equal(ovr_simulation_advance(b, &march, &more, &err),
                         OVR_BAD_INPUT);
        ovr_simulation_free(a), ovr_simulation_free(b);
    }
}

TEST(same_numbers_on_every_instruction_set)
{
    static const char *const names[] = {"plain", "avx2", "avx512"};
    static ending base, other;
    assert_true(run_on("base", 20, &base));
    for (int k = 0; k < 3; k++) {
        double worst = 0;
        if (!run_on(names[k], 20, &other))
            continue;
        for (int i = 0; i < NODES; i++)
            worst = fmax(worst, fmax(fabs(base.P[i] - other.P[i]),
                                     fabs(base.H[i] / other.H[i] - 1)));
        printf("base and %s differ by %.1e\n", names[k], worst);
        CHECK_NEAR(worst, 0, 1e-9);
    }
}

/* However the lanes cut a fine grid, the finest level takes as many cycles and
 * ends as near: what is lost where lanes meet would cost one more. */
TEST(same_cycles_on_a_fine_grid)
{
    static const char *const names[] = {"plain", "base", "avx2", "avx512"};
    double R[4] = {0};
    int cycles[4] = {0};
    for (int k = 0; k < 4; k++) {
        ovr_error err = {0};
        ovr_options o = test_options();
        const ovr_kernels *set = ovr_kernels_choose(names[k]);
        int count;
        if (!set)
            continue;
        o.level = 15;
        o.stop = OVR_STOP_TRUNCATION;
        ovr_simulation *sim = test_simulation(20, 10, &o);
        ovr_hierarchy_kernels(&sim->grids, set);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        const ovr_refinement *r = ovr_simulation_refinements(sim, &count);
        cycles[k] = r[count - 1].cycles;
        R[k] = r[count - 1].residual;
        ovr_simulation_free(sim);
        assert_int_equal(cycles[k], cycles[0]);
        CHECK_CLOSE(R[k], R[0], 0.5);
    }
}
