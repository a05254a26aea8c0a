/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Oil conserved, against an independent solution, against the Reynolds
 * equation where the contact is flooded, and against its own identity. */
#include <math.h>

#include "cavitation_truth.h"
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

static void steady_contacts(void **state)
{
    (void)state;
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
static void flooded_is_reynolds(void **state)
{
    (void)state;
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

static void starved_dents(void **state)
{
    (void)state;
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

/* Over steps of equal length what flows in less what flows out is what is
 * stored, but for the residuals: with a supply that comes and goes, from a
 * flooded inlet that runs dry to one that fills again. */
static double waving(void *data, double T)
{
    (void)data;
    return 0.08 + 0.06 * cos(3 * T);
}

static void oil_is_conserved(void **state)
{
    enum { STEPS = 300, N = 7 * 64 + 1 };
    double supply = 1, before[N], total, first, out = 0, left = 1e-12;
    int closed = 0, open = 0;
    ovr_error err = {0};
    ovr_simulation *sim = made(6, 1e-9, &supply);
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    (void)state;
    ovr_simulation_supply(sim, waving, NULL, 0.01);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    first = stored(s, s->q) + o->oil_waiting;
    for (int k = 0; k < STEPS; k++) {
        double arrived = waving(NULL, s->T + 0.5 * s->D);
        for (size_t i = 0; i < N; i++)
            before[i] = s->q[i];
        CHECK_OK(ovr_simulation_step(sim, s->D, &err), &err);
        out += s->D * (arrived - o->outflow);
        total = stored(s, before) + o->oil_waiting;
        left += s->D * o->residual * o->H_cen;
        CHECK_NEAR(total - first, out, left);
        open += isnan(o->meniscus);
        closed += o->inflow == arrived;
    }
    assert_true(open > 10 && closed > 10);
    ovr_simulation_free(sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steady_contacts),
        cmocka_unit_test(flooded_is_reynolds),
        cmocka_unit_test(starved_dents),
        cmocka_unit_test(oil_is_conserved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
