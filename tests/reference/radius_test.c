/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time-dependent radius: instantaneous and slow changes, and balances. */
#include "simulation/simulation.h"

#include <math.h>
#include <string.h>

#include "contact/contact.h"
#include "support/contact.h"
#include "support/test.h"

static ovr_history *history(ovr_history_kind kind, double size, double period)
{
    ovr_error err = {0};
    ovr_history_form form = ovr_history_form_default();
    form.kind = kind;
    form.from = form.to = size;
    form.amplitude = size;
    form.period = period;
    ovr_history *made = ovr_history_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static ovr_options options(int level, ovr_scheme scheme)
{
    ovr_options o = test_options();
    o.level = level;
    o.scheme = scheme;
    return o;
}

static void steady(ovr_simulation *sim)
{
    ovr_error err = {0};
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
}

/* On the domain over s. */
static ovr_simulation *its_own(double M, double L, ovr_options o, double s)
{
    o.inlet /= s;
    o.outlet /= s;
    return test_simulation(M, L, &o);
}

static void same(const ovr_simulation *a, const ovr_simulation *b, double Cw,
                 double r)
{
    const ovr_observation *u = ovr_simulation_observation(a);
    const ovr_observation *v = ovr_simulation_observation(b);
    double s = sqrt(Cw * r), p = sqrt(Cw / r);
    CHECK_CLOSE(u->H_cen, Cw * v->H_cen, 1e-7);
    CHECK_CLOSE(u->H_min, Cw * v->H_min, 1e-7);
    CHECK_CLOSE(u->P_max, p * v->P_max, 1e-7);
    CHECK_CLOSE(u->X_cavitation, s * v->X_cavitation, 1e-12);
    CHECK_CLOSE(u->radius_ratio, r, 1e-15);
}

/* The contact of load Cw, speed Cu, curvature c in the nominal units is that
 * of M', L' in its own: X = s X', P = sqrt(Cw c) P', H = Cw H', s =
 * sqrt(Cw/c); so are its discrete equations, mesh by mesh. */
TEST(at_an_instant_it_is_another_contact)
{
    static const double all[][5] = {{20, 10, 1.4, 1, 1},
                                    {20, 10, 0.6, 1.5, 0.7},
                                    {50, 5, 1.5, 0.7, 1.4},
                                    {100, 12, 0.7, 1.2, 0.8}};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        double M = all[k][0], L = all[k][1], r = all[k][2];
        double Cw = all[k][3], Cu = all[k][4];
        ovr_history *of[3];
        for (int i = 0; i < 3; i++)
            of[i] = history(OVR_HISTORY_STEP, all[k][2 + i], 1);
        ovr_options o = options(7, OVR_UPSTREAM2);
        o.tolerance = 1e-9;
        ovr_simulation *a = test_simulation(M, L, &o);
        ovr_simulation *b = its_own(M * Cw / sqrt(Cu * r),
                                    L * pow(Cu / r, 0.25), o, sqrt(Cw * r));
        ovr_simulation_histories(a, of[1], of[2]);
        ovr_simulation_radius(a, of[0], NULL, true);
        steady(a);
        steady(b);
        same(a, b, Cw, r);
        ovr_simulation_free(a);
        ovr_simulation_free(b);
        for (int i = 0; i < 3; i++)
            ovr_history_free(of[i]);
    }
}

/* A radius that is 1 changes no bit. */
TEST(a_radius_of_one_is_none)
{
    static const ovr_scheme schemes[] = {OVR_UPSTREAM1, OVR_UPSTREAM2,
                                         OVR_CHARACTERISTIC};
    ovr_history *one = history(OVR_HISTORY_STEP, 1, 1);
    test_feature dent = {'l', -0.1, 0.5, -1.5, 1, 0};
    ovr_error err = {0};
    for (size_t k = 0; k < 3; k++) {
        ovr_options o = options(6, schemes[k]);
        ovr_simulation *sim[2];
        for (int i = 0; i < 2; i++) {
            sim[i] = test_simulation(20, 10, &o);
            ovr_simulation_surface(sim[i], test_feature_heights, &dent);
            if (i)
                ovr_simulation_radius(sim[i], one, NULL, true);
            steady(sim[i]);
            for (int step = 0; step < 20; step++)
                CHECK_OK(ovr_simulation_step(sim[i], 5.5 / 448, &err), &err);
        }
        const ovr_state *a = ovr_simulation_state(sim[0]);
        const ovr_state *b = ovr_simulation_state(sim[1]);
        assert_memory_equal(a->P, b->P, a->n * sizeof *a->P);
        assert_memory_equal(a->H, b->H, a->n * sizeof *a->H);
        ovr_simulation_free(sim[0]);
        ovr_simulation_free(sim[1]);
    }
    ovr_history_free(one);
}

/* H_cen and H_min at an eighth of the period over those of the steady contact
 * with the radius of then, less 1. */
static void lag(double period, bool convected, ovr_scheme scheme, int level,
                double off[2])
{
    const double amplitude = 0.3, D = 5.5 / (7 << level);
    ovr_error err = {0};
    ovr_options o = options(level, scheme);
    double r = 1 + amplitude * sin(acos(-1) / 4), end = period / 8;
    ovr_history *swing = history(OVR_HISTORY_SINE, amplitude, period);
    ovr_history *then = history(OVR_HISTORY_STEP, r, 1);
    ovr_simulation *still = test_simulation(20, 10, &o);
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_march march = {0};
    march.end = end;
    march.dT = end / 200;
    ovr_simulation_radius(sim, swing, NULL, convected);
    ovr_simulation_radius(still, then, NULL, convected);
    steady(sim);
    steady(still);
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    const ovr_observation *u = ovr_simulation_observation(sim);
    const ovr_observation *v = ovr_simulation_observation(still);
    off[0] = u->H_cen / v->H_cen - 1;
    off[1] = u->H_min_located / v->H_min_located - 1;
    CHECK_NEAR(u->load_error, 0, 1e-4);
    if (scheme != OVR_UPSTREAM1) /* of first order at the inlet */
        CHECK_NEAR(u->mass_balance, 0, 20 * D * D + 8 * march.dT * march.dT);
    CHECK_NEAR(ovr_simulation_state(sim)->D, D, 1e-12);
    assert_int_equal(ovr_simulation_statistics(sim)->marked, 0);
    ovr_simulation_free(sim);
    ovr_simulation_free(still);
    ovr_history_free(swing);
    ovr_history_free(then);
}

/* The film is off to first order in the rate, other where the curvature is
 * convected than where it is imposed. */
TEST(a_slow_change_follows_the_steady_contact)
{
    double imposed[2][2], convected[2][2];
    for (int k = 0; k < 2; k++) {
        int period = k ? 512 : 256;
        lag(period, false, OVR_UPSTREAM2, 6, imposed[k]);
        lag(period, true, OVR_UPSTREAM2, 6, convected[k]);
        print_message("    period %3d: H_cen, H_min off by %.2e %.2e, where "
                      "it convected %.2e %.2e\n",
                      period, imposed[k][0], imposed[k][1], convected[k][0],
                      convected[k][1]);
    }
    CHECK_CLOSE(imposed[0][0] / imposed[1][0], 2, 0.1);
    CHECK_CLOSE(imposed[0][1] / imposed[1][1], 2, 0.1);
    CHECK_CLOSE(convected[0][1] / convected[1][1], 2, 0.1);
    CHECK_CLOSE(convected[0][0] / convected[1][0], 2, 0.1);
}

/* The three schemes follow it alike, to their errors. */
TEST(all_schemes_follow)
{
    double of[3][2];
    for (int k = 0; k < 3; k++)
        lag(32, true, (ovr_scheme)k, 7, of[k]);
    print_message("    H_min off by %.3e %.3e %.3e\n", of[0][1], of[1][1],
                  of[2][1]);
    CHECK_NEAR(of[0][1], of[1][1], 0.1 * fabs(of[1][1]));
    CHECK_NEAR(of[2][1], of[1][1], 0.1 * fabs(of[1][1]));
}

/* A radius that is none, and a curvature that would close the gap. */
TEST(impossible_values_are_rejected)
{
    ovr_error err = {0};
    ovr_options o = options(5, OVR_UPSTREAM2);
    ovr_history *none = history(OVR_HISTORY_STEP, -1, 1);
    ovr_history *fast = history(OVR_HISTORY_SINE, 0.9, 3);
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_radius(sim, none, NULL, false);
    CHECK_STATUS(ovr_simulation_steady(sim, &err), OVR_BAD_INPUT, &err);
    assert_non_null(strstr(err.message, "radius ratio -1"));
    ovr_simulation_radius(sim, fast, NULL, true);
    CHECK_STATUS(ovr_simulation_steady(sim, &err), OVR_BAD_INPUT, &err);
    assert_non_null(strstr(err.message, "too fast"));
    ovr_simulation_radius(sim, fast, NULL, false);
    steady(sim);
    CHECK_OK(ovr_simulation_step(sim, 0.01, &err), &err);
    ovr_simulation_free(sim);
    ovr_history_free(none);
    ovr_history_free(fast);
}
