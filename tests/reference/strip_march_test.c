/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Transient strips: the line contact if nothing varies across, a moving round
 * dent of another program, mirror image and shift, steps of fractions of D,
 * random films. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/simulation.h"
#include "strip/march.h"
#include "support/contact.h"
#include "support/strip.h"
#include "support/strip_cases.h"
#include "support/test.h"

enum { LEVEL = 5, N = (7 << LEVEL) + 1 };

/* Transverse grooves of a simulation of the line contact. */
static void heights(void *strip, double T, size_t n, const double *X, double *S)
{
    const test_strip *s = strip;
    const test_bump *b = &s->bump[0];
    for (size_t i = 0; i < n; i++) {
        double x = (X[i] - b->x - b->u * T) / b->width;
        S[i] = b->A * exp(-x * x);
    }
}

static ovr_simulation *line_contact(double tolerance, test_strip *s,
                                    ovr_scheme scheme)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.faces = OVR_FACES_GAP;
    o.level = LEVEL;
    o.scheme = scheme;
    o.tolerance = tolerance;
    o.mlmi_order = 12;
    o.mlmi_range = 24;
    ovr_simulation *line = test_simulation(s->M, s->L, &o);
    ovr_simulation_surface(line, heights, s);
    CHECK_OK(ovr_simulation_steady(line, &err), &err);
    return line;
}

/* Largest distance of P and H over 30 steps in which a groove passes. */
static double groove_apart(bool logarithmic, bool characteristic)
{
    const double tolerance = 1e-9;
    ovr_error err = {0};
    ovr_strip_shape shape = test_strip_shape(N, 56);
    shape.coarsest = 29;
    test_strip *s = test_strip_make(20, 10, shape, NULL);
    s->bump[s->bumps++] = (test_bump){
        .A = -0.05, .width = 0.25, .x = -1, .u = 1.25};
    s->strip.logarithmic = logarithmic;
    test_strip_solve(s, tolerance);
    ovr_simulation *line = line_contact(
        tolerance, s, characteristic ? OVR_CHARACTERISTIC : OVR_UPSTREAM2);
    ovr_strip_march march;
    test_strip_march(s, &march, tolerance);
    march.characteristic = characteristic;
    double apart = 0, D = test_strip_finest(s)->grid.D;
    for (int step = 1; step <= 30; step++) {
        CHECK_OK(ovr_simulation_step(line, D, &err), &err);
        const ovr_state *now = ovr_simulation_state(line);
        assert_true(ovr_strip_march_attempt(&march, now->T).solved);
        ovr_strip_march_accept(&march);
        for (size_t i = 0; i < N; i++)
            for (size_t j = 0; j < 56; j += 5) {
                const ovr_strip_fields *f = &test_strip_finest(s)->f;
                double H = test_strip_at(s, f->H, i, j);
                apart = fmax(apart, fabs(H - now->H[i]));
            }
    }
    ovr_simulation_free(line);
    test_strip_free(s);
    return apart;
}

/* The mean of phi between nodes of the line contact is one or the other. */
TEST(moving_groove_is_the_line_contact)
{
    for (int characteristic = 0; characteristic < 2; characteristic++) {
        double arithmetic = groove_apart(false, characteristic);
        double logarithmic = groove_apart(true, characteristic);
        CHECK_NEAR(fmin(arithmetic, logarithmic), 0, 1e-8);
    }
}

static const test_bump dent = {
    .A = -0.08, .width = 0.3, .x = -2.5, .y = 1, .u = 1, .round = true};

/* The film under the dent when it is at X = 0, and extremes until it leaves:
 * values of another program to five digits, which begins with another step. */
TEST(moving_dent_agrees_with_another_program)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 32), NULL);
    s->bump[s->bumps++] = dent;
    test_strip_solve(s, 1e-6);
    ovr_strip_march march;
    test_strip_march(s, &march, 1e-5);
    march.characteristic = true;
    march.carried = 1;
    const ovr_strip_level *level = test_strip_finest(s);
    double D = level->grid.D, H_min = 1, P_max = 0, under[2] = {0};
    for (int step = 1; step * D < 4.1; step++) {
        assert_true(ovr_strip_march_attempt(&march, step * D).solved);
        ovr_strip_march_accept(&march);
        H_min = fmin(H_min, test_strip_smallest(s, level->f.H));
        P_max = fmax(P_max, test_strip_largest(s, level->f.P));
        double x = (dent.x + step * D + 4) / D;
        if (fabs(dent.x + step * D) < D) {
            size_t i = (size_t)x;
            double u = x - (double)i, H[2];
            for (size_t k = 0; k < 2; k++)
                H[k] = test_strip_at(s, level->f.H, i + k, 16);
            under[dent.x + step * D > 0] = H[0] + u * (H[1] - H[0]);
        }
    }
    CHECK_NEAR(H_min, 0.06654, 3e-5);
    CHECK_NEAR(P_max, 1.0195, 3e-4);
    CHECK_NEAR(0.5 * (under[0] + under[1]), 0.11857, 5e-4);
    test_strip_free(s);
}

/* The film after steps of a number of mesh sizes. */
static test_strip *after(double meshes, double y, double sign)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 28), NULL);
    s->bump[s->bumps] = dent;
    s->bump[s->bumps].x = -1.4;
    s->bump[s->bumps].u = 1.3;
    s->bump[s->bumps++].y = sign * 0.6 + y;
    s->strip.logarithmic = true;
    test_strip_solve(s, 1e-9);
    ovr_strip_march march;
    test_strip_march(s, &march, 1e-8);
    march.characteristic = true;
    double D = test_strip_finest(s)->grid.D;
    int steps = (int)lround(16 / meshes);
    for (int step = 1; step <= steps; step++) {
        assert_true(ovr_strip_march_attempt(&march, step * meshes * D).solved);
        ovr_strip_march_accept(&march);
    }
    return s;
}

static double apart(const test_strip *a, const test_strip *b, bool mirrored,
                    size_t shift)
{
    double most = 0;
    for (size_t i = 0; i < 129; i++)
        for (size_t j = 0; j < 28; j++) {
            size_t k = mirrored ? 56 - j : j + shift;
            double H = test_strip_at(a, test_strip_finest(a)->f.H, i, j);
            most = fmax(
                most,
                fabs(H - test_strip_at(b, test_strip_finest(b)->f.H, i, k)));
        }
    return most;
}

TEST(steps_are_symmetric_and_of_second_order)
{
    test_strip *one = after(1, 0, 1), *shifted = after(1, 6. / 28, 1);
    test_strip *mirrored = after(1, 0, -1);
    CHECK_NEAR(apart(one, shifted, false, 3), 0, 1e-8);
    CHECK_NEAR(apart(one, mirrored, true, 0), 0, 1e-8);
    test_strip *half = after(0.5, 0, 1), *quarter = after(0.25, 0, 1);
    double ratio = apart(one, half, false, 0) / apart(half, quarter, false, 0);
    assert_true(ratio > 2.8);
    test_strip_free(one);
    test_strip_free(shifted);
    test_strip_free(mirrored);
    test_strip_free(half);
    test_strip_free(quarter);
}

/* A step that is taken back leaves no trace. */
TEST(step_back_restores_the_film)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(129, 28), NULL);
    s->bump[s->bumps++] = dent;
    test_strip_solve(s, 1e-9);
    ovr_strip_march march;
    test_strip_march(s, &march, 1e-6);
    march.characteristic = true;
    const ovr_strip_level *level = test_strip_finest(s);
    double D = level->grid.D;
    ovr_strip_march_attempt(&march, D);
    ovr_strip_march_accept(&march);
    size_t bytes = ovr_strip_size(&level->grid) * sizeof(double);
    double *P = malloc(bytes), *H = malloc(bytes);
    assert_true(P && H);
    memcpy(P, level->f.P, bytes);
    memcpy(H, level->f.H, bytes);
    ovr_strip_march_attempt(&march, 3 * D);
    ovr_strip_march_back(&march);
    for (size_t i = 0; i < 129; i++) {
        size_t row = ovr_strip_row(&level->grid, i);
        assert_memory_equal(P + row, level->f.P + row, 28 * sizeof *P);
        assert_memory_equal(H + row, level->f.H + row, 28 * sizeof *H);
    }
    free(P);
    free(H);
    test_strip_free(s);
}

/* A wave of half the film, which has a spike at each trough.  Without secants
 * it takes 19 cycles a step and 47 retries. */
TEST(rolling_wave_needs_no_retries)
{
    strip_survey found = {0};
    strip_survey_add(&found, 3, 257);
    assert_int_equal(found.steps, 100);
    assert_int_equal(found.retries, 0);
    assert_true(found.cycles < 8 * found.steps);
}

/* Pockets of a rough sliding film open and close near the outlet.  Without
 * spots.c cycles stall there, 22 steps are tried again and the run ends at
 * T = 0.77. */
TEST(sliding_roughness_needs_no_retries)
{
    strip_survey found = {0};
    strip_survey_add(&found, 7, 257);
    assert_int_equal(found.steps, 100);
    assert_int_equal(found.retries, 0);
    assert_int_equal(found.flagged, 0);
    assert_true(found.cycles < 15 * found.steps);
}

/* A tenth of the survey of tests/verify. */
TEST(random_films_are_solved)
{
    strip_survey found = {0};
    for (unsigned seed = 1; seed <= 6; seed++)
        strip_survey_add(&found, seed, 129);
    strip_survey_check(&found);
}
