/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Extremes of curves: positions within the range of validity of a parabola,
 * maxima above their surroundings compared with their full definition, and runs
 * that an earlier version misread. */
#include "support/test.h"

#include <math.h>

#include "overroll/overroll.h"
#include "simulation/observe.h"

enum { N = 400 };

/* A parabola's own vertex is found; a node far from it, or a value changed by
 * more than a twentieth, is left as it is. */
TEST(vertices_are_bounded)
{
    double X[] = {0.3, 1, 2}, v[3], value;
    for (int k = 0; k < 3; k++)
        v[k] = 2 + 0.3 * (X[k] - 1.2) * (X[k] - 1.2);
    CHECK_NEAR(ovr_vertex(X, v, 1, &value), 1.2, 1e-12);
    CHECK_NEAR(value, 2, 1e-12);
    X[0] = 0;
    v[0] = 1, v[1] = 0.1, v[2] = 0.2; /* -0.0113 by the parabola */
    CHECK_NEAR(ovr_vertex(X, v, 1, &value), 1, 0);
    CHECK_NEAR(value, 0.1, 0);
    v[0] = v[1] = v[2] = 3;
    CHECK_NEAR(ovr_vertex(X, v, 1, &value), 1, 0);
    CHECK_NEAR(value, 3, 0);
}

/* The definition, the long way: maxima in order, each against the lowest
 * value between it and the one before. */
static int by_definition(const double *P, size_t *last)
{
    size_t before = 0;
    int count = 0;
    for (size_t i = 1; i + 1 < N; i++) {
        double low = INFINITY;
        if (!(P[i] > P[i - 1] && P[i] >= P[i + 1]))
            continue;
        for (size_t j = before; j < i; j++)
            low = fmin(low, P[j]);
        if (P[i] - low > 1e-3) {
            count++;
            *last = before = i;
        }
    }
    return count;
}

TEST(maxima_stand_out)
{
    uint64_t seed = 31;
    for (int run = 0; run < 200; run++) {
        double clean[N], noisy[N];
        size_t a = 0, b = 0, c = 0;
        double waves = test_random(&seed, 0, 30);
        double height = test_random(&seed, 0.01, 0.3);
        for (size_t i = 0; i < N; i++) {
            double x = 2.0 * (double)i / (N - 1) - 1;
            clean[i] = sqrt(1 - x * x) * (1 + height * sin(waves * x));
            noisy[i] = clean[i] + test_random(&seed, -1e-7, 1e-7);
        }
        assert_int_equal(ovr_prominent_maxima(N, clean, &a),
                         by_definition(clean, &b));
        assert_int_equal(a, b);
        /* noise changes neither the number nor, by more than it, the value */
        assert_int_equal(ovr_prominent_maxima(N, noisy, &c),
                         ovr_prominent_maxima(N, clean, &a));
        CHECK_NEAR(clean[c], clean[a], 4e-7);
    }
}

TEST(noise_is_no_maximum)
{
    uint64_t seed = 32;
    double P[N];
    size_t last = 0;
    for (size_t i = 0; i < N; i++) {
        double x = 2.0 * (double)i / (N - 1) - 1;
        P[i] = sqrt(1 - x * x) + test_random(&seed, -2e-4, 2e-4);
    }
    assert_int_equal(ovr_prominent_maxima(N, P, &last), 1);
    P[N / 4] += 0.01, P[3 * N / 4] += 0.01;
    assert_true(ovr_prominent_maxima(N, P, &last) >= 2);
    assert_int_equal(last, 3 * N / 4);
}

static ovr_observation solved(double M, double L, int level, ovr_scheme scheme)
{
    ovr_error err = {0};
    char text[200];
    ovr_observation o;
    snprintf(text, sizeof text,
             "[contact]\nM = %g\nL = %g\n[domain]\ninlet = -4\nlevel = %d\n"
             "[time]\nscheme = %s\n",
             M, L, level, scheme == OVR_UPSTREAM1 ? "upstream1" : "upstream2");
    ovr_case *c = ovr_case_read_text(text, "t", NULL, NULL, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_simulation *sim = s ? ovr_setup_simulation(s, NULL, &err) : NULL;
    if (!sim || ovr_simulation_steady(sim, &err))
        fail_msg("%s", err.message);
    o = *ovr_simulation_observation(sim);
    ovr_simulation_free(sim);
    ovr_setup_free(s);
    ovr_case_free(c);
    return o;
}

/* The grid is too coarse for the constriction: the parabola gave -0.0019. */
TEST(no_film_is_negative)
{
    ovr_observation o = solved(100, 5, 3, OVR_UPSTREAM1);
    assert_true(o.H_min > 0);
    CHECK_CLOSE(o.H_min_located, o.H_min, 0.05);
    CHECK_CLOSE(o.P_max_located, o.P_max, 0.05);
}

/* Without pressure spike: 0.1.0 gave one of 1e-7. */
TEST(a_spike_needs_prominence)
{
    ovr_observation o = solved(5, 0, 7, OVR_UPSTREAM2);
    assert_true(isnan(o.P_spike) && isnan(o.X_spike_located));
    assert_int_equal(o.maxima, 1);
    o = solved(20, 10, 8, OVR_UPSTREAM2);
    assert_int_equal(o.maxima, 2);
    assert_true(o.P_spike > 0.3 && o.X_spike > 0.5);
}

/* Minimum film thickness and gap in the cavity of one step, by definition. */
typedef struct gaps {
    int cavity, steps;
    double largest_X; /* of the film's end */
} gaps;

static ovr_status compare_gaps(void *data, const ovr_simulation *sim,
                               ovr_error *err)
{
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    double film = INFINITY, cavity = INFINITY;
    gaps *seen = data;
    (void)err;
    for (size_t i = 1; i + 1 < s->n; i++) {
        bool bears = s->P[i - 1] + s->P[i] + s->P[i + 1] > 0;
        double *low = bears ? &film : &cavity;
        *low = fmin(*low, s->H[i]);
    }
    CHECK_NEAR(o->H_min, film, 0);
    assert_true(isnan(o->H_min_cavity) == !(cavity < film));
    if (cavity < film) {
        CHECK_CLOSE(o->H_min_cavity, cavity, 0.05);
        assert_true(o->X_min_cavity > 1);
        seen->cavity++;
    }
    seen->steps++;
    seen->largest_X = fmax(seen->largest_X, o->X_cavitation);
    return OVR_OK;
}

/* A ridge leaves the contact: in the cavity the surfaces are closer to each
 * other than in the film for some steps, and the film ends inside the domain.
 */
TEST(gaps_of_the_cavity_are_no_film_thickness)
{
    static const char *const text =
        "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 6\n[time]\nend = 4\n"
        "[feature f]\nshape = ridge\nheight = 0.3\nwidth = 0.6\n"
        "start = -2\ngrow = 0.5\n";
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "t", NULL, NULL, &err);
    ovr_setup *s = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_simulation *sim = s ? ovr_setup_simulation(s, NULL, &err) : NULL;
    gaps seen = {0};
    ovr_observer observer = {compare_gaps, NULL, &seen};
    if (!sim || ovr_simulation_steady(sim, &err))
        fail_msg("%s", err.message);
    ovr_march march = *s->march;
    march.observers = &observer;
    march.count = 1;
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    assert_true(seen.cavity > 3 && seen.steps > seen.cavity);
    assert_true(s->options->outlet > 1.5);
    assert_true(seen.largest_X < s->options->outlet - 2 * s->mesh);
    ovr_simulation_free(sim);
    ovr_setup_free(s);
    ovr_case_free(c);
}
