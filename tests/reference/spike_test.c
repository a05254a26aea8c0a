/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches around the pressure spike: sample of tests/verify/spike_test.c. */
#include <math.h>

#include "support/contact.h"
#include "support/spike.h"
#include "support/test.h"

TEST(as_on_a_uniform_grid)
{
    test_spike_and_uniform(14);
}

TEST(a_few_contacts)
{
    test_spike_survey(16, 4);
}

/* A simulation that is solved again gives the same bits and takes no steps. */
TEST(again_the_same)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.refine = OVR_REFINE_SPIKE;
    o.refine_level = 12;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_observation first = *ovr_simulation_observation(sim);
    size_t n = ovr_simulation_state(sim)->n;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *second = ovr_simulation_observation(sim);
    const ovr_state *now = ovr_simulation_state(sim);
    assert_true(first.P_spike == second->P_spike);
    assert_true(first.H_min == second->H_min);
    assert_int_equal(n, now->n);
    double length = 0;
    for (size_t i = 0; i < n; i++) {
        length += now->weights[i];
        assert_true(i == 0 || now->X[i] > now->X[i - 1]);
    }
    CHECK_NEAR(length, 5.5, 1e-12);
    assert_int_equal(ovr_simulation_step(sim, 0.01, &err), OVR_BAD_INPUT);
    ovr_simulation_free(sim);
}

/* A stationary dent in the contact, resolved by the patches. */
TEST(standing_dent)
{
    test_feature dent = {.kind = 'l', .A = -0.02, .width = 0.1, .start = 0.85};
    ovr_error err = {0};
    double H[2], P[2];
    for (int k = 0; k < 2; k++) {
        ovr_options o = test_options();
        o.level = k ? 9 : 12;
        o.refine = k ? OVR_REFINE_SPIKE : OVR_REFINE_NONE;
        o.refine_level = k ? 13 : 0;
        ovr_simulation *sim = test_simulation(20, 10, &o);
        ovr_simulation_surface(sim, test_feature_heights, &dent);
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        H[k] = ovr_simulation_observation(sim)->H_min_located;
        P[k] = ovr_simulation_observation(sim)->P_max;
        ovr_simulation_free(sim);
    }
    /* second order at level 12: 4e-6 of the film, more of sharp pressures */
    CHECK_CLOSE(H[1], H[0], 2e-4);
    CHECK_CLOSE(P[1], P[0], 5e-3);
}
