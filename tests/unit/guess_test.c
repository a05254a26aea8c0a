/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a step begins from: the extrapolation by itself, what it is exact for,
 * and what it saves without loss in a run. */
#include <math.h>
#include <string.h>

#include "simulation/internal.h"
#include "support/contact.h"
#include "support/kernels.h"
#include "support/test.h"

/* Every set against the plain sum, dry nodes and partial vectors included. */
static void weighted_sum_where_wet(void **state)
{
    enum { MOST = 41, TERMS = 5 };
    double past[TERMS][MOST], weight[TERMS], P[MOST + 1], plain[MOST];
    const double *from[TERMS];
    const ovr_kernels *run;
    uint64_t seed = 5;
    (void)state;
    for (size_t k = 0; k < TERMS; k++) {
        from[k] = past[k];
        weight[k] = test_random(&seed, -4, 4);
        for (size_t i = 0; i < MOST; i++)
            past[k][i] = fmax(test_random(&seed, -0.5, 1), 0);
    }
    test_kernels(0)->extrapolate(MOST, TERMS, weight, from, plain);
    for (int set = 0; (run = test_kernels(set)); set++)
        for (size_t n = 8; n <= MOST; n++) {
            P[n] = 77;
            run->extrapolate(n, TERMS, weight, from, P);
            assert_true(P[n] == 77);
            for (size_t i = 0; i < n; i++)
                CHECK_NEAR(P[i], plain[i], 1e-14);
        }
}

/* A node that stays dry, one that falls dry, one that stays wet. */
static void plain_sum_by_hand(void **state)
{
    const double *const from[] = {(double[]){0, 1, 3}, (double[]){5, 4, 2}};
    double P[3];
    (void)state;
    test_kernels(0)->extrapolate(3, 2, (double[]){2, -1}, from, P);
    assert_memory_equal(P, ((double[]){0, 0, 4}), sizeof P);
}

/* ------------------------------------------------- what it is exact for */

/* Wet everywhere: what stands and what moves with the surfaces, both growing
 * linearly; or what stands alone, as a parabola. */
static double moving(double X, double T)
{
    return 2 + (0.1 + 0.02 * T) * sin(3 * X) +
           (0.2 - 0.03 * T) * exp(-4 * (X - T) * (X - T));
}

static double standing(double X, double T)
{
    return 2 + (0.1 + 0.02 * T - 0.1 * T * T) * sin(3 * X);
}

/* Largest error of the guess for a step of so many meshes after equal ones;
 * whether it calls itself close. */
static double error_of(double (*P)(double, double), double meshes, bool *close)
{
    ovr_error err;
    ovr_options o = ovr_options_default();
    o.level = 6;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double dT = meshes * sim->finest->grid.D, worst = 0;
    size_t n = sim->finest->grid.n;
    sim->past.steps = 3;
    sim->past.dT = dT;
    for (int k = 0; k < 4; k++) {
        sim->past.T[k] = -k * dT;
        sim->past.H0[k] = pow(-k, 2);
        for (size_t i = 0; i < n; i++)
            sim->past.P[k][i] = P(sim->now.X[i], -k * dT);
    }
    *close = ovr_guess(sim, dT, true);
    for (size_t i = 2; i < n; i++)
        worst = fmax(worst,
                     fabs(sim->grids.scratch[0][i] - P(sim->now.X[i], dT)));
    CHECK_NEAR(sim->grids.H0, 1, 1e-12);
    ovr_simulation_free(sim);
    return worst;
}

static void exact_for_what_moves_by_a_mesh_a_step(void **state)
{
    bool close;
    (void)state;
    assert_true(error_of(moving, 1, &close) < 1e-13 && close);
    assert_true(error_of(standing, 0.5, &close) < 1e-13 && !close);
    assert_true(error_of(moving, 0.5, &close) > 1e-9);
}

/* ------------------------------------------------------------ in a run */

enum { STEPS = 480 };

typedef struct series {
    double H_min[STEPS], H_cen[STEPS];
    long cycles;
} series;

/* The reference dent on level 6, past the contact's middle. */
static series roll(double tolerance)
{
    ovr_error err;
    series s;
    test_feature dent = {'l', -0.1, 0.5, -4.6, 1, 0};
    ovr_options o = ovr_options_default();
    o.level = 6;
    o.tolerance = tolerance;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    long steady = ovr_simulation_statistics(sim)->cycles;
    for (int k = 0; k < STEPS; k++) {
        CHECK_OK(ovr_simulation_step(sim, sim->finest->grid.D, &err), &err);
        s.H_min[k] = sim->observation.H_min_located;
        s.H_cen[k] = sim->observation.H_cen;
    }
    s.cycles = ovr_simulation_statistics(sim)->cycles - steady;
    ovr_simulation_free(sim);
    return s;
}

/* The parabola took 1.75 cycles a step and left 3e-5. */
static void few_cycles_and_no_loss(void **state)
{
    series quick = roll(0), exact = roll(1e-9);
    double worst = 0;
    (void)state;
    for (int k = 0; k < STEPS; k++) {
        worst = fmax(worst, fabs(quick.H_min[k] / exact.H_min[k] - 1));
        worst = fmax(worst, fabs(quick.H_cen[k] / exact.H_cen[k] - 1));
    }
    print_message("%.2f cycles a step, film off by %.1e\n",
                  (double)quick.cycles / STEPS, worst);
    assert_true(2 * quick.cycles < 3 * STEPS);
    assert_true(worst < 2e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(weighted_sum_where_wet),
        cmocka_unit_test(plain_sum_by_hand),
        cmocka_unit_test(exact_for_what_moves_by_a_mesh_a_step),
        cmocka_unit_test(few_cycles_and_no_loss),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
