/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Mass-conserving cavitation compared with an independent solution, with the
 * Reynolds equation for flooded contacts, and with its own mass balance. */
#include <math.h>
#include <string.h>

#include "cavitation_truth.h"
#include "contact/contact.h"
#include "physics/supply/supply.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

static double constant(void *data, double T)
{
    (void)T;
    return *(double *)data;
}

static ovr_simulation *made(int level, double tolerance, double *supply)
{
    ovr_options o = test_options();
    o.level = level;
    o.cavitation = OVR_CAVITATION_CONSERVING;
    o.tolerance = tolerance;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    if (*supply > 0)
        ovr_simulation_supply(sim, constant, supply, 0.1);
    return sim;
}

/* ------------------------------------------------------------------- steady */

static void node_is(const ovr_state *s, const cavity_node *truth)
{
    CHECK_NEAR(s->P[truth->i], truth->P, 1e-7);
    CHECK_NEAR(s->H[truth->i], truth->H, 1e-7);
    CHECK_NEAR(s->q[truth->i], truth->q, 1e-7);
}

TEST(steady_contacts)
{
    for (size_t k = 0; k < sizeof cavity_steadies / sizeof *cavity_steadies;
         k++) {
        const cavity_steady *truth = &cavity_steadies[k];
        double supply = truth->supply;
        ovr_error err = {0};
        ovr_simulation *sim = made(truth->level, 1e-9, &supply);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        const ovr_observation *o = ovr_simulation_observation(sim);
        CHECK_NEAR(o->H0, truth->H0, 1e-7);
        CHECK_NEAR(o->H_cen, truth->H_cen, 1e-7);
        CHECK_NEAR(o->H_min, truth->H_min, 1e-7);
        CHECK_NEAR(o->P_cen, truth->P_cen, 1e-7);
        CHECK_NEAR(o->outflow, truth->q_out, 1e-9);
        if (supply > 0)
            CHECK_NEAR(o->meniscus, truth->meniscus, 1e-7);
        else
            assert_true(isnan(o->meniscus));
        for (int i = 0; i < CAVITY_NODES; i++)
            node_is(ovr_simulation_state(sim), &truth->node[i]);
        ovr_simulation_free(sim);
    }
}

/* What is flooded has the pressure of the Reynolds equation; what arrives
 * beyond what it takes makes no difference. */
TEST(flooded_is_reynolds)
{
    for (int level = 5; level < 7; level++) {
        double supply[] = {0, 0.3};
        ovr_error err = {0};
        ovr_options o = test_options();
        o.level = level;
        o.tolerance = 3e-11; /* some rounding above what can be reached */
        ovr_simulation *sim = test_simulation(20, 10, &o);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        const ovr_state *expected = ovr_simulation_state(sim);
        for (int k = 0; k < 2; k++) {
            ovr_simulation *other = made(level, 3e-11, &supply[k]);
            CHECK_OK(ovr_simulation_steady(other, &err), &err);
            const ovr_state *s = ovr_simulation_state(other);
            for (size_t i = 0; i < s->n; i++)
                CHECK_NEAR(s->P[i], expected->P[i], 1e-11);
            ovr_simulation_free(other);
        }
        ovr_simulation_free(sim);
    }
}

/* ------------------------------------------------------------------- in time
 */

static void time_is(const ovr_observation *o, const cavity_time *truth)
{
    CHECK_NEAR(o->H_min, truth->H_min, 1e-7);
    CHECK_NEAR(o->H_cen, truth->H_cen, 1e-7);
    CHECK_NEAR(o->H0, truth->H0, 1e-7);
    CHECK_NEAR(o->meniscus, truth->meniscus, 1e-7);
}

static void follow(const cavity_run *truth)
{
    double supply = 0.05041919727171857;
    test_feature dent = {'l', -0.1, 0.5, -4.6, truth->speed, 0};
    ovr_error err = {0};
    ovr_simulation *sim = made(truth->level, 1e-9, &supply);
    const ovr_state *s = ovr_simulation_state(sim);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    ovr_simulation_moving(sim, truth->speed);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (size_t k = 0; k < truth->count; k++) {
        while (s->T < truth->at[k].T - 1e-9)
            CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        time_is(ovr_simulation_observation(sim), &truth->at[k]);
    }
    ovr_simulation_free(sim);
}

TEST(starved_dents)
{
    for (size_t k = 0; k < sizeof cavity_runs / sizeof *cavity_runs; k++)
        follow(&cavity_runs[k]);
}

/* -------------------------------------------------------------- conservation
 */

/* The content that the time derivative stores. */
static double stored(const ovr_state *s, const double *before)
{
    double sum = 0;
    for (size_t i = 1; i + 1 < s->n; i++) {
        double A = 1.5 * s->q[i] - 0.5 * before[i];
        sum += s->P[i] > 0 ? A : fmax(A, 0.5 * s->q[i]);
    }
    return sum * s->D;
}

/* Over steps of equal length inflow minus outflow equals the stored change
 * except for the residuals, with an oscillating supply and an inlet that
 * starves and floods again. */
static double waving(void *data, double T)
{
    (void)data;
    return 0.08 + 0.06 * cos(3 * T);
}

TEST(oil_is_conserved)
{
    enum { STEPS = 300, N = 7 * 64 + 1 };
    double supply = 1, before[N], total, first, out = 0, left = 1e-12;
    int closed = 0, open = 0;
    ovr_error err = {0};
    ovr_simulation *sim = made(6, 1e-9, &supply);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    ovr_simulation_supply(sim, waving, NULL, 0.01);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    first = stored(s, s->q) + o->oil_reservoir;
    for (int k = 0; k < STEPS; k++) {
        double arrived = waving(NULL, s->T + 0.5 * s->D);
        for (size_t i = 0; i < N; i++)
            before[i] = s->q[i];
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        out += s->D * (arrived - o->outflow);
        total = stored(s, before) + o->oil_reservoir;
        left += s->D * o->residual * o->H_cen;
        CHECK_NEAR(total - first, out, left);
        open += isnan(o->meniscus);
        closed += o->inflow == arrived;
    }
    assert_true(open > 10 && closed > 10);
    ovr_simulation_free(sim);
}

/* What was stored between two states by a step of dT after dT_old: A - B of
 * multigrid/content.h, by the contents of three times. */
typedef struct times {
    double q[3][7 * 64 + 1], P[2][7 * 64 + 1], dT, dT_old;
} times;

static double gained(const times *t, size_t n, double D)
{
    double s = t->dT_old > 0 ? t->dT / t->dT_old : 1, sum = 0;
    double kappa = s / (1 + s), b2 = s * s / (1 + s);
    for (size_t i = 1; i + 1 < n; i++) {
        double now = t->q[0][i], before = t->q[1][i];
        double A = (1 + kappa) * now - kappa * before;
        double B = (1 + b2) * before - b2 * t->q[2][i];
        A = t->P[0][i] > 0 ? A : fmax(A, 0.5 * now);
        B = t->P[1][i] > 0 ? B : fmax(B, 0.5 * before);
        sum += A - B;
    }
    return D * sum;
}

static void take_over(times *t, const ovr_state *s, double dT)
{
    size_t bytes = s->n * sizeof(double);
    memcpy(t->q[2], t->q[1], bytes);
    memcpy(t->q[1], t->q[0], bytes);
    memcpy(t->P[1], t->P[0], bytes);
    memcpy(t->q[0], s->q, bytes);
    memcpy(t->P[0], s->P, bytes);
    t->dT_old = t->dT;
    t->dT = dT;
}

/* The mass defect of a step is its algebraic residual, whatever its length, and
 * while the entrainment stops: content never falls below nothing. */
TEST(steps_of_any_length)
{
    enum { STEPS = 200 };
    static times t;
    uint64_t seed = 7;
    double supply = 1, slowest = 1;
    ovr_history_form form = ovr_history_form_default();
    test_feature dent = {'l', -0.1, 0.5, -2, 1, 0};
    ovr_error err = {0};
    ovr_simulation *sim = made(6, 1e-7, &supply);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = 1;
    form.period = 2.5;
    ovr_history *speed = ovr_history_create(&form, NULL, &err);
    ovr_simulation_histories(sim, NULL, speed);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    ovr_simulation_supply(sim, waving, NULL, 0.01);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    t = (times){0};
    for (int k = 0; k < 3; k++)
        take_over(&t, s, 0);
    for (int k = 0; k < STEPS; k++) {
        double dT = s->D * test_random(&seed, 0.4, 2.5), flow;
        CHECK_OK(ovr_simulation_step(sim, dT, &err), &err);
        assert_int_equal(ovr_simulation_statistics(sim)->substeps, 0);
        take_over(&t, s, dT);
        flow = dT * (o->inflow - o->outflow);
        CHECK_NEAR(flow - gained(&t, s->n, s->D),
                   dT * o->mass_defect * o->H_cen, 1e-13);
        CHECK_NEAR(o->mass_defect, 0, 1e-7);
        slowest = fmin(slowest, o->speed_ratio);
        for (size_t i = 0; i < s->n; i++)
            assert_true(s->q[i] >= 0 && s->P[i] >= 0);
    }
    assert_true(slowest < 0.01);
    ovr_simulation_free(sim);
    ovr_history_free(speed);
}
