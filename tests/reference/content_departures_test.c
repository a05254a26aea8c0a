/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation along the characteristic: the content is
 * transported exactly, and inflow minus outflow equals the stored change in
 * steps of any length while the inlet closes and opens and the surfaces stop.
 * Film thicknesses agree with the limit of the upstream scheme. */
#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "simulation/internal.h"
#include "support/contact.h"
#include "support/test.h"

enum { LEVEL = 6, N = 7 * 64 + 1 };

static double constant(void *data, double T)
{
    (void)T;
    return *(double *)data;
}

static double waving(void *data, double T)
{
    (void)data;
    return 0.08 + 0.06 * cos(3 * T);
}

static ovr_simulation *made(ovr_scheme scheme, int level, double tolerance)
{
    ovr_options o = test_options();
    o.level = level;
    o.scheme = scheme;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    o.tolerance = tolerance;
    return test_simulation(20, 10, &o);
}

/* -------------------------------------------------------------- conservation
 */

/* By the contents of two times at the nodes: what BDF2 stores, and what its
 * limit adds where it is dry, along characteristics from node to node. */
static double stored(const ovr_state *s, const double *before, double arrived)
{
    double sum = 0;
    for (size_t i = 1; i + 1 < s->n; i++) {
        double departure = i > 1 ? before[i - 1] : arrived;
        double A = 1.5 * s->q[i] - 0.5 * departure;
        sum += 1.5 * s->q[i] - 0.5 * before[i];
        sum += s->P[i] > 0 ? 0 : fmax(0, 0.5 * s->q[i] - A);
    }
    return sum * s->D;
}

/* A constant supply that never floods the contact: all supplied lubricant is
 * inside or has left. */
static double starving(void *data, double T)
{
    (void)data;
    return 0.03 + 0.01 * cos(3 * T);
}

TEST(supply_stays_or_leaves)
{
    enum { STEPS = 300 };
    double before[N], first, out = 0, left = 1e-12, last = starving(NULL, 0);
    ovr_error err = {0};
    ovr_simulation *sim = made(OVR_CHARACTERISTIC, LEVEL, 1e-9);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    test_feature dent = {'l', -0.05, 0.5, -4.6, 1, 0};
    ovr_simulation_supply(sim, starving, NULL, 0);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    ovr_simulation_moving(sim, 1);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    first = stored(s, s->q, starving(NULL, 0));
    for (int k = 0; k < STEPS; k++) {
        double arrived = starving(NULL, s->T);
        double flow = 1.5 * arrived - 0.5 * last;
        last = arrived;
        memcpy(before, s->q, sizeof before);
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        out += s->D * (flow - o->outflow);
        left += s->D * o->residual * o->H_cen;
        CHECK_NEAR(o->inflow, flow, 1e-15);
        CHECK_NEAR(stored(s, before, arrived) - first, out, left);
    }
    ovr_simulation_free(sim);
}

/* Change of content by a step of dT after dT_old, from the contents of three
 * times, and the lubricant added by the limits of content_departures.c at
 * cavitated nodes. */
typedef struct times {
    double q[3][N], came[2][N], P[2][N], dT, dT_old;
} times;

static double limited(const times *t, int ago, size_t i, double weight)
{
    double q = t->q[ago][i], A = (1 + weight) * q - weight * t->came[ago][i];
    return t->P[ago][i] > 0 ? 0 : fmax(0, 0.5 * q - A);
}

static double gained(const times *t, double D)
{
    double s = t->dT_old > 0 ? t->dT / t->dT_old : 1, sum = 0;
    double kappa = s / (1 + s), b2 = s * s / (1 + s);
    for (size_t i = 1; i + 1 < N; i++) {
        double now = t->q[0][i], before = t->q[1][i];
        sum += (1 + kappa) * now - kappa * before + limited(t, 0, i, kappa);
        sum -= (1 + b2) * before - b2 * t->q[2][i] + limited(t, 1, i, b2);
    }
    return D * sum;
}

static void take_over(times *t, const ovr_simulation *sim, double dT)
{
    const ovr_state *s = &sim->state;
    memcpy(t->q[2], t->q[1], sizeof t->q[0]);
    memcpy(t->q[1], t->q[0], sizeof t->q[0]);
    memcpy(t->P[1], t->P[0], sizeof t->P[0]);
    memcpy(t->came[1], t->came[0], sizeof t->came[0]);
    memcpy(t->q[0], s->q, sizeof t->q[0]);
    memcpy(t->P[0], s->P, sizeof t->P[0]);
    memcpy(t->came[0], sim->arrival.carriage.came, sizeof t->came[0]);
    t->dT_old = t->dT;
    t->dT = dT;
}

/* The mass defect of a step is its algebraic residual for any length and any
 * departure points while the entrainment stops, with the inlet closed and open,
 * except in steps with a reversal. The content is never negative. */
TEST(steps_of_any_length)
{
    enum { STEPS = 300 };
    static times t;
    uint64_t seed = 7;
    int closed = 0, open = 0, turns = 0;
    double slowest = 1;
    ovr_history_form form = ovr_history_form_default();
    test_feature dent = {'l', -0.1, 0.5, -2, 1, 0};
    ovr_error err = {0};
    ovr_simulation *sim = made(OVR_CHARACTERISTIC, LEVEL, 1e-7);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = 1;
    form.period = 2.5;
    ovr_history *speed = ovr_history_create(&form, NULL, &err);
    ovr_simulation_histories(sim, NULL, speed);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    ovr_simulation_supply(sim, waving, NULL, 0.03);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    t = (times){0};
    for (int k = 0; k < 3; k++)
        take_over(&t, sim, 0);
    for (int k = 0; k < STEPS; k++) {
        double dT = s->D * test_random(&seed, 0.4, 2.5), flow;
        bool was = sim->arrival.carriage.closed;
        CHECK_OK(ovr_simulation_step(sim, dT, &err), &err);
        assert_int_equal(ovr_simulation_statistics(sim)->substeps, 0);
        take_over(&t, sim, dT);
        flow = dT * (o->inflow - o->outflow);
        turns += was != sim->arrival.carriage.closed;
        if (k > 0 && was == sim->arrival.carriage.closed)
            CHECK_NEAR(flow - gained(&t, s->D), dT * o->mass_defect * o->H_cen,
                       1e-12);
        CHECK_NEAR(o->mass_defect, 0, 1e-7);
        slowest = fmin(slowest, o->speed_ratio);
        open += isnan(o->meniscus);
        closed += !isnan(o->meniscus);
        for (size_t i = 0; i < s->n; i++)
            assert_true(s->q[i] >= 0 && s->P[i] >= 0);
    }
    assert_true(slowest < 0.01);
    print_message("open %d, closed %d, turns %d\n", open, closed, turns);
    assert_true(open > 10 && closed > 10 && turns < 9);
    ovr_simulation_free(sim);
    ovr_history_free(speed);
}

/* Supply and reservoir together are the inflow, except for the change of the
 * supply over D/2 each time that the inlet opens or closes. */
static double in_waves(void *data, double T)
{
    (void)data;
    return 0.1 + 0.08 * cos(0.8 * T);
}

TEST(reservoir_oil_is_counted)
{
    enum { STEPS = 1000 };
    double came = 0, taken = 0;
    int changes = 0;
    bool closed = false;
    ovr_error err = {0};
    ovr_simulation *sim = made(OVR_CHARACTERISTIC, 5, 1e-7);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    ovr_simulation_supply(sim, in_waves, NULL, 0.01);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (int k = 0; k < STEPS; k++) {
        came += s->D * in_waves(NULL, s->T);
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        taken += s->D * o->inflow;
        CHECK_NEAR(o->oil_reservoir, 0.01 + came - taken,
                   0.08 * s->D * (1 + changes));
        changes += closed == isnan(o->meniscus);
        closed = !isnan(o->meniscus);
    }
    print_message("opened or closed %d times\n", changes);
    assert_true(changes >= 3);
    ovr_simulation_free(sim);
}

/* ------------------------------------------------------------------ exactly */

/* Upstream of the film, at P = 0, a supply is convected without change, in
 * steps of one and several D. */
TEST(carried_exactly)
{
    for (int meshes = 1; meshes < 4; meshes++) {
        ovr_error err = {0};
        ovr_simulation *sim = made(OVR_CHARACTERISTIC, LEVEL, 0);
        const ovr_state *s = ovr_simulation_state(sim);
        ovr_simulation_supply(sim, starving, NULL, 0);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        while (s->T < 2)
            CHECK_OK(ovr_simulation_step(sim, meshes * s->D, &err), &err);
        for (size_t i = 0; s->X[i] < s->X[0] + 1.5; i++) {
            double way = s->X[i] - s->X[0];
            CHECK_NEAR(s->q[i], starving(NULL, s->T - way), 1e-12);
        }
        ovr_simulation_free(sim);
    }
}

/* Between nodes beyond first order: the mean error of a carried wave falls to
 * less than a third from one level to the next finer. */
static double carried_error(int level)
{
    const double share = 0.37;
    double sum = 0;
    ovr_error err = {0};
    ovr_simulation *sim = made(OVR_CHARACTERISTIC, level, 0);
    const ovr_state *s = ovr_simulation_state(sim);
    ovr_simulation_supply(sim, starving, NULL, 0);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    while (s->T < 2)
        CHECK_OK(ovr_simulation_step(sim, share * s->D, &err), &err);
    for (size_t i = 0; s->X[i] < s->X[0] + 1.5; i++) {
        double way = s->X[i] - s->X[0];
        sum += s->D * fabs(s->q[i] - starving(NULL, s->T - way));
    }
    ovr_simulation_free(sim);
    return sum;
}

TEST(carried_between_nodes)
{
    double coarse = carried_error(5), fine = carried_error(6);
    print_message("carried wave: %.2g, %.2g of 0.01\n", coarse, fine);
    assert_true(fine < coarse / 3);
    assert_true(fine < 1e-4);
}

/* ------------------------------------------------------------------- its limit
 */

/* The rms error of H_cen and H_min of a starved dent against those of a finer
 * run. */
typedef struct series {
    int count;
    double T[2048], H_cen[2048], H_min[2048];
} series;

static void follow(ovr_scheme scheme, int level, series *to)
{
    double supply = 0.05041919727171857;
    test_feature dent = {'l', -0.1, 0.5, -4.6, 1, 0};
    ovr_error err = {0};
    ovr_simulation *sim = made(scheme, level, 0);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    ovr_simulation_supply(sim, constant, &supply, 0);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    ovr_simulation_moving(sim, 1);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    *to = (series){0};
    while (s->T < 6) {
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        to->T[to->count] = s->T;
        to->H_cen[to->count] = o->H_cen;
        to->H_min[to->count++] = o->H_min;
    }
    ovr_simulation_free(sim);
}

typedef struct errors {
    double H_cen, H_min;
} errors;

/* Every step of the coarse one is one of the finer's, whose step is a `share`.
 */
static errors against(const series *coarse, const series *fine, int share)
{
    errors e = {0};
    int count = coarse->count;
    while (count * share > fine->count)
        count--;
    for (int k = 0; k < count; k++) {
        int j = (k + 1) * share - 1;
        CHECK_NEAR(fine->T[j], coarse->T[k], 1e-9);
        e.H_cen += pow(coarse->H_cen[k] / fine->H_cen[j] - 1, 2);
        e.H_min += pow(coarse->H_min[k] / fine->H_min[j] - 1, 2);
    }
    e.H_cen = sqrt(e.H_cen / count);
    e.H_min = sqrt(e.H_min / count);
    return e;
}

/* Both schemes go to one limit, and this one is nearer to it by far. */
TEST(a_starved_dent)
{
    static series fine, along, upstream, finer;
    follow(OVR_CHARACTERISTIC, 8, &fine);
    follow(OVR_CHARACTERISTIC, 6, &along);
    follow(OVR_UPSTREAM2, 6, &upstream);
    follow(OVR_UPSTREAM2, 7, &finer);
    errors e = against(&along, &fine, 4), u = against(&upstream, &fine, 4);
    errors v = against(&finer, &fine, 2);
    print_message("characteristic %g %g, upstream2 %g %g, level 7 %g %g\n",
                  e.H_cen, e.H_min, u.H_cen, u.H_min, v.H_cen, v.H_min);
    assert_true(e.H_cen < u.H_cen / 5 && e.H_min < u.H_min / 3);
    assert_true(v.H_cen < u.H_cen / 2 && v.H_min < u.H_min / 2);
}

/* -------------------------------------------------------- steady in any step
 */

/* Largest relative change of the film thickness and pressure of a smooth
 * contact in 20 steps. */
static double moved(double M, double L, double dT)
{
    ovr_options o = test_options();
    ovr_error err = {0};
    o.level = LEVEL;
    o.scheme = OVR_CHARACTERISTIC;
    o.order = 4;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    o.tolerance = 1e-8;
    ovr_simulation *sim = test_simulation(M, L, &o);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    double most = 0;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation first = *seen;
    for (int k = 0; k < 20; k++) {
        CHECK_OK(ovr_simulation_step(sim, dT, &err), &err);
        most = fmax(most, fabs(seen->H_cen / first.H_cen - 1));
        most = fmax(most, fabs(seen->H_min / first.H_min - 1));
        most = fmax(most, fabs(seen->P_max / first.P_max - 1));
    }
    assert_int_equal(ovr_simulation_order(sim), 4);
    ovr_simulation_free(sim);
    return most;
}

TEST(flooded_films_stay_steady_in_long_steps)
{
    static const double contacts[][2] = {{20, 10}, {200, 13}};
    for (size_t k = 0; k < 2; k++) {
        double D = 7. / (7 << LEVEL);
        for (int steps = 1; steps <= 4; steps *= 2) {
            double most = moved(contacts[k][0], contacts[k][1],
                                (steps == 1 ? 0.8 : steps) * D);
            print_message("    M = %g, %d D: %.1e\n", contacts[k][0], steps,
                          most);
            assert_true(most < 2e-4);
        }
    }
}
