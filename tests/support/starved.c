/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/starved.h"

#include <math.h>

#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

static ovr_simulation *make(double M, double L, int level, double tolerance,
                            ovr_scheme scheme, int order)
{
    ovr_options o = test_options();
    o.scheme = scheme;
    o.order = order;
    o.level = level;
    o.tolerance = tolerance;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    return test_simulation(M, L, &o);
}

test_flooded test_flood(double M, double L, int level)
{
    ovr_error err = {0};
    ovr_simulation *sim = make(M, L, level, 0, OVR_UPSTREAM2, 2);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *o = ovr_simulation_observation(sim);
    test_flooded f = {o->H_cen, o->outflow};
    ovr_simulation_free(sim);
    return f;
}

static double constant(void *data, double T)
{
    (void)T;
    return *(double *)data;
}

ovr_status test_starve(double M, double L, int level, double share,
                       int *strategies, ovr_error *err)
{
    double q = share * test_flood(M, L, level).flow;
    ovr_simulation *sim = make(M, L, level, 0, OVR_UPSTREAM2, 2);
    ovr_simulation_supply(sim, constant, &q, 0);
    ovr_status status = ovr_simulation_steady(sim, err);
    *strategies = 1 + ovr_simulation_observation(sim)->retries;
    if (!status)
        CHECK_NEAR(ovr_simulation_observation(sim)->outflow / q, 1, 1e-6);
    ovr_simulation_free(sim);
    return status;
}

/* --------------------------------------------------------------- random runs
 */

enum { FEATURES = 3 };

typedef struct scene {
    test_feature feature[FEATURES];
    double q[2];         /* supply at the start and at the end */
    double wave, period; /* amplitude and period of its oscillation */
} scene;

static double supply(void *data, double T)
{
    const scene *s = data;
    double y = fmin(1, fmax(0, T / 2));
    double ramp = y * y * y * (10 + y * (6 * y - 15));
    double q = s->q[0] + (s->q[1] - s->q[0]) * ramp;
    double pi = acos(-1.0);
    return q * (1 + s->wave * ramp * sin(2 * pi * T / s->period));
}

static void heights(void *data, double T, size_t n, const double *X, double *S)
{
    enum { MAX = 4096 };
    const scene *s = data;
    double one[MAX];
    assert_true(n <= MAX);
    for (size_t i = 0; i < n; i++)
        S[i] = 0;
    for (int k = 0; k < FEATURES; k++) {
        test_feature f = s->feature[k];
        test_feature_heights(&f, T, n, X, one);
        for (size_t i = 0; i < n; i++)
            S[i] += one[i];
    }
}

static double pick(uint64_t *seed, double from, double to)
{
    return test_random(seed, from, to);
}

/* Draws a supply, a dent, a bump and waves that grow from zero. */
static void make_scene(scene *s, uint64_t *seed, test_flooded f, double u)
{
    double start = pick(seed, 0.3, 3), end = pick(seed, 0.3, 3);
    bool flooded = pick(seed, 0, 1) < 0.2, ramp = pick(seed, 0, 1) < 0.5;
    s->q[0] = f.flow * (flooded ? 3 : start);
    s->q[1] = ramp ? f.flow * end : s->q[0];
    s->wave = pick(seed, 0, 1) < 0.3 ? pick(seed, 0, 0.8) : 0;
    s->period = pick(seed, 0.5, 3);
    double minimum = fmin(fmin(s->q[0], s->q[1]) / f.flow, 1);
    s->feature[0] = (test_feature){'l',
                                   -pick(seed, 0, 1.5) * f.film,
                                   pick(seed, 0.3, 1),
                                   pick(seed, -3, -1.2),
                                   u,
                                   0};
    s->feature[1] = (test_feature){'l',
                                   pick(seed, 0, 0.7) * f.film * minimum,
                                   pick(seed, 0.3, 1),
                                   pick(seed, -4, -2),
                                   u,
                                   0};
    bool waves = pick(seed, 0, 1) < 0.3;
    s->feature[2] = (test_feature){'w',
                                   waves ? pick(seed, 0, 0.5) * f.film * minimum
                                         : 0,
                                   pick(seed, 0.3, 1),
                                   0,
                                   u,
                                   1};
}

static ovr_history *sine(uint64_t *seed, double maximum)
{
    ovr_history_form form = ovr_history_form_default();
    bool varies = pick(seed, 0, 1) < 0.3;
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = pick(seed, 0, maximum);
    form.period = pick(seed, 0.5, 3);
    return varies ? ovr_history_create(&form, NULL, NULL) : NULL;
}

test_starved_run test_starved(uint64_t seed, int level, ovr_scheme scheme,
                              int order)
{
    uint64_t random = seed;
    test_starved_run run = {.M = 5 * pow(40, pick(&random, 0, 1)),
                            .L = pick(&random, 2.5, 14)};
    double u = pick(&random, 0, 2);
    scene s;
    make_scene(&s, &random, test_flood(run.M, run.L, level), u);
    ovr_history *load = sine(&random, 0.9), *speed = sine(&random, 0.95);
    ovr_simulation *sim = make(run.M, run.L, level, 1e-5, scheme, order);
    ovr_simulation_supply(sim, supply, &s, 0.1);
    ovr_simulation_histories(sim, load, speed);
    ovr_simulation_surface(sim, heights, &s);
    ovr_simulation_moving(sim, u);
    ovr_march march = {.end = 4};
    run.status = ovr_simulation_steady(sim, &run.err);
    if (!run.status)
        run.status = ovr_simulation_march(sim, &march, &run.err);
    const ovr_statistics *t = ovr_simulation_statistics(sim);
    run.retries = t->retries;
    run.substeps = t->substeps;
    run.marked = t->marked;
    run.cycles = (double)t->cycles / fmax(1, (double)t->steps);
    ovr_simulation_free(sim);
    ovr_history_free(load);
    ovr_history_free(speed);
    return run;
}
