/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Initial guess of a step: exactness of the extrapolation, and saved cycles
 * without loss of accuracy in a run. */
#include <math.h>
#include <string.h>

#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "support/contact.h"
#include "support/kernels.h"
#include "support/test.h"

/* Every instruction set compared with the plain sum, with cavitated nodes and
 * partial vectors. */
TEST(weighted_sum_at_pressurized_nodes)
{
    enum { MAX = 41, TERMS = 5 };
    double past[TERMS][MAX], weight[TERMS], P[MAX + 1], plain[MAX];
    const double *from[TERMS];
    const ovr_kernels *run;
    uint64_t seed = 5;
    for (size_t k = 0; k < TERMS; k++) {
        from[k] = past[k];
        weight[k] = test_random(&seed, -4, 4);
        for (size_t i = 0; i < MAX; i++)
            past[k][i] = fmax(test_random(&seed, -0.5, 1), 0);
    }
    test_kernels(0)->extrapolate(MAX, TERMS, weight, from, plain);
    for (int set = 0; (run = test_kernels(set)); set++)
        for (size_t n = 8; n <= MAX; n++) {
            P[n] = 77;
            run->extrapolate(n, TERMS, weight, from, P);
            assert_true(P[n] == 77);
            for (size_t i = 0; i < n; i++)
                CHECK_NEAR(P[i], plain[i], 1e-14);
        }
}

/* The same of what moves by a part of a mesh. */
TEST(convected_in_pressurized_nodes)
{
    enum { MAX = 41 };
    double past[3][MAX + 3], P[MAX + 1], plain[MAX];
    const double *const from[] = {past[0], past[1], past[2]};
    const double c[] = {-0.0455, 0.3315, 0.7735, -0.0595};
    const ovr_kernels *run;
    uint64_t seed = 6;
    for (size_t k = 0; k < 3; k++)
        for (size_t i = 0; i < MAX + 3; i++)
            past[k][i] = fmax(test_random(&seed, -0.5, 1), 0);
    test_kernels(0)->carry(MAX, c, from, plain);
    for (int set = 0; (run = test_kernels(set)); set++)
        for (size_t n = 8; n <= MAX; n++) {
            P[n] = 77;
            run->carry(n, c, from, P);
            assert_true(P[n] == 77);
            for (size_t i = 0; i < n; i++)
                CHECK_NEAR(P[i], plain[i], 1e-14);
        }
}

/* A node that is dry; halfway between nodes, 1 + 4 - 2; a cubic that would
 * leave its nodes' range; a sum that would leave that of what it is made of by
 * more than 0.1 times 2 and 0.02. */
TEST(plain_carry_by_hand)
{
    const double half[] = {-0.0625, 0.5625, 0.5625, -0.0625};
    const double next[] = {1, 0, 0, 0};
    const double *const from[] = {(double[]){0, 1}, (double[]){9, 3, 3, 5, 5},
                                  (double[]){9, 2, 2, 2, 2}};
    const double *const far[] = {(double[]){1}, (double[]){3, 0, 0, 0},
                                 (double[]){9, 0, 0, 0}};
    const double *const peak[] = {(double[]){4}, (double[]){0, 4, 4, 0},
                                  (double[]){0, 0, 0, 0}};
    double P[2];
    test_kernels(0)->carry(2, half, from, P);
    assert_true(P[0] == 0);
    CHECK_NEAR(P[1], 1 + 4 - 2, 1e-14);
    test_kernels(0)->carry(1, next, far, P);
    CHECK_NEAR(P[0], 1 - 0.22, 1e-14);
    test_kernels(0)->carry(1, half, peak, P);
    CHECK_NEAR(P[0], 4 + 0.02, 1e-14);
}

/* A node that stays dry, one that falls dry, one that stays wet. */
TEST(plain_sum_by_hand)
{
    const double *const from[] = {(double[]){0, 1, 3}, (double[]){5, 4, 2}};
    double P[3];
    test_kernels(0)->extrapolate(3, 2, (double[]){2, -1}, from, P);
    assert_memory_equal(P, ((double[]){0, 0, 4}), sizeof P);
}

/* ------------------------------------------------- what it is exact for */

/* Wet everywhere: what stands and what moves, both growing linearly, the first
 * only, none; or what stands alone, as a parabola. */
static double speed = 1;

static double bump(double X, double T)
{
    double x = X - speed * T;
    return exp(-4 * x * x);
}

static double moving(double X, double T)
{
    return 2 + (0.1 + 0.02 * T) * sin(3 * X) + (0.2 - 0.03 * T) * bump(X, T);
}

static double carrying(double X, double T)
{
    return 2 + (0.1 + 0.02 * T) * sin(3 * X) + 0.2 * bump(X, T);
}

static double constant(double X, double T)
{
    return 2 + 0.1 * sin(3 * X) + 0.2 * bump(X, T);
}

static double each_moving(double X, double T)
{
    return 2 + 0.1 * sin(3 * (X - T)) + 0.2 * bump(X, T);
}

static double standing(double X, double T)
{
    return 2 + (0.1 + 0.02 * T - 0.1 * T * T) * sin(3 * X);
}

/* What is told of the features' speed; the formula that was the nearest then,
 * in the order of guess.c. */
static double told;
static size_t nearest;
static double H0 = 1; /* that it makes of k^2, k steps ago */

/* Returns the largest error of the guess for a step of the given number of D
 * after equal steps, except near the ends, and whether the guess is reported as
 * close. */
static double error_of(double (*P)(double, double), double meshes, bool *close)
{
    enum { MARGIN = 10 };
    ovr_error err;
    ovr_options o = test_options();
    o.level = 6;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double dT = meshes * sim->finest->grid.D, worst = 0;
    size_t n = sim->finest->grid.n;
    ovr_simulation_moving(sim, told);
    sim->past.guess_error[nearest] = 1;
    sim->past.steps = 3;
    sim->past.dT = dT;
    for (int k = 0; k < 4; k++) {
        sim->past.T[k] = -k * dT;
        sim->past.H0[k] = pow(-k, 2);
        for (size_t i = 0; i < n; i++)
            sim->past.P[k][i] = P(sim->now.X[i], -k * dT);
    }
    *close = ovr_guess(sim, dT, true);
    double *guess = ovr_work_take(sim);
    ovr_nodes_read(sim, sim->finest, sim->finest->f.P, guess);
    for (size_t i = MARGIN; i < n - MARGIN; i++)
        worst = fmax(worst, fabs(guess[i] - P(sim->now.X[i], dT)));
    ovr_work_give(sim, guess);
    CHECK_NEAR(sim->grids.H0, H0, 1e-12);
    ovr_simulation_free(sim);
    return worst;
}

TEST(exact_for_what_moves_by_a_mesh_a_step)
{
    bool close;
    told = NAN;
    assert_true(error_of(moving, 1, &close) < 1e-13 && close);
    assert_true(error_of(standing, 0.5, &close) < 1e-13 && !close);
    assert_true(error_of(moving, 0.5, &close) > 1e-9);
}

TEST(exact_for_the_given_sliding)
{
    enum { BY_STEPS, BY_TWO, TWO_TERMS, TWO_BY_TWO, EACH_MOVES = 7 };
    bool close;
    speed = told = 0.5;
    nearest = BY_STEPS;
    assert_true(error_of(moving, 2, &close) < 1e-13 && !close);
    nearest = BY_TWO;
    assert_true(error_of(carrying, 1, &close) < 1e-13 && !close);
    H0 = -1;
    nearest = TWO_TERMS;
    assert_true(error_of(constant, 2, &close) < 1e-13 && !close);
    /* a crest between nodes is cut: D^2/8 of a curvature of 1.6 */
    assert_true(error_of(constant, 1.4, &close) < 1e-4);
    nearest = TWO_BY_TWO;
    assert_true(error_of(constant, 1, &close) < 1e-13);
    nearest = EACH_MOVES;
    assert_true(error_of(each_moving, 2, &close) < 1e-13 && !close);
    assert_true(error_of(each_moving, 1, &close) < 1e-4);
    nearest = TWO_BY_TWO;
    speed = told = -0.5; /* against the others */
    assert_true(error_of(constant, 1, &close) < 1e-13);
    speed = 1, H0 = 1, nearest = 0;
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
    ovr_options o = test_options();
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
TEST(few_cycles_and_no_loss)
{
    series quick = roll(0), exact = roll(1e-9);
    double worst = 0;
    for (int k = 0; k < STEPS; k++) {
        worst = fmax(worst, fabs(quick.H_min[k] / exact.H_min[k] - 1));
        worst = fmax(worst, fabs(quick.H_cen[k] / exact.H_cen[k] - 1));
    }
    print_message("%.2f cycles a step, film off by %.1e\n",
                  (double)quick.cycles / STEPS, worst);
    assert_true(2 * quick.cycles < 3 * STEPS);
    assert_true(worst < 2e-5);
}
