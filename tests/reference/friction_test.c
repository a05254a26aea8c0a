/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction against brute-force solutions and identities. */
#include "reference/rheology_truth.h"

#include "support/contact.h"
#include "support/test.h"

static ovr_observation solved(double M, double L, int level, double S)
{
    test_contact c = test_contact_make(M, L);
    ovr_options o = test_options();
    ovr_error err = {0};
    o.level = level;
    c.contact.u1_ratio = 1 + S / 2;
    c.contact.u2_ratio = 1 - S / 2;
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_observation seen = *ovr_simulation_observation(sim);
    ovr_simulation_free(sim);
    return seen;
}

static void newtonian_truth_is_met(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof truth_frictions / sizeof *truth_frictions;
         k++) {
        const truth_friction *t = &truth_frictions[k];
        if (isfinite(t->Sigma0))
            continue;
        ovr_observation o = solved(t->M, t->L, t->level, t->S);
        CHECK_CLOSE(o.H_cen, t->H_cen, 1e-6);
        CHECK_CLOSE(o.F_slide, t->F_slide, 1e-6);
        CHECK_CLOSE(o.F_roll, t->F_roll, 1e-6);
        CHECK_CLOSE(o.F_1 + o.F_2, -2 * t->F_roll, 1e-6);
    }
}

/* 2 F_roll = int (eps/rho) P_X^2 dX, which is what the surfaces put in and what
 * the film dissipates, to second order where there is no spike. */
static void steady_power_is_dissipated(void **state)
{
    double off[3];
    (void)state;
    for (int k = 0; k < 3; k++) {
        ovr_observation o = solved(5, 5, 6 + k, 0);
        CHECK_NEAR(o.power_in, 2 * o.F_roll, 1e-14);
        off[k] = fabs(o.power_dissipated / o.power_in - 1);
    }
    assert_true(off[0] < 2e-4);
    assert_true(off[1] < off[0] / 3 && off[2] < off[1] / 3);
    ovr_observation o = solved(20, 10, 8, 1.5);
    CHECK_CLOSE(o.power_in, o.power_dissipated, 1e-6);
    CHECK_CLOSE(o.power_in, -(o.F_1 * 1.75 + o.F_2 * 0.25), 1e-10);
}

/* Where nothing is steep; the sliding part of a Newtonian film goes with the
 * viscosity at the spike, which grows with every level. */
static void rolling_friction_is_of_second_order(void **state)
{
    double F[3];
    (void)state;
    for (int k = 0; k < 3; k++)
        F[k] = solved(5, 5, 6 + k, 0).F_roll;
    double ratio = (F[1] - F[0]) / (F[2] - F[1]);
    print_message("    differences of F_roll fall by %.2f\n", ratio);
    assert_true(ratio > 3 && ratio < 5.5);
}

/* Surfaces exchanged: forces exchanged; no sliding: only the rolling part. */
static void signs_follow_the_surfaces(void **state)
{
    ovr_observation a = solved(10, 5, 5, 0.4), b = solved(10, 5, 5, -0.4);
    ovr_observation none = solved(10, 5, 5, 0);
    (void)state;
    assert_true(a.F_1 < 0 && a.F_2 > 0 && a.F_roll > 0);
    assert_true(a.F_slide == -b.F_slide && a.F_1 == b.F_2);
    assert_true(none.F_slide == 0 && none.F_1 == -none.F_roll &&
                none.F_2 == -none.F_roll);
}

/* mu = kappa F over the load, with kappa = 4 alphabar/G. */
static void coefficients_need_the_ratio(void **state)
{
    ovr_conditions given = ovr_conditions_unknown();
    ovr_contact contact;
    ovr_error err = {0};
    (void)state;
    assert_true(isnan(solved(5, 5, 4, 0.4).mu_1));
    given.M = 20;
    given.L = 10;
    given.G = 4000;
    CHECK_OK(ovr_contact_resolve(&given, &contact, &err), &err);
    CHECK_CLOSE(contact.kappa, 4 * contact.alphabar / 4000, 1e-15);
    given.alpha = 20e-9;
    CHECK_OK(ovr_contact_resolve(&given, &contact, &err), &err);
    CHECK_CLOSE(contact.modulus, 2e11, 1e-12);
    CHECK_CLOSE(contact.kappa, 4 * contact.ph / 2e11, 1e-12);
    given.modulus = 2e11;
    CHECK_STATUS(ovr_contact_resolve(&given, &contact, &err), OVR_BAD_INPUT,
                 &err);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(newtonian_truth_is_met),
        cmocka_unit_test(steady_power_is_dissipated),
        cmocka_unit_test(rolling_friction_is_of_second_order),
        cmocka_unit_test(signs_follow_the_surfaces),
        cmocka_unit_test(coefficients_need_the_ratio)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
