/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shear-thinning contacts: 144 steady Eyring films and 200 random runs. */
#include <stdlib.h>

#include "contact/contact.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"
#include "support/thinning.h"

static ovr_simulation *eyring(double M, double L, double S, double tau0,
                              int level)
{
    ovr_conditions given = ovr_conditions_default();
    test_contact c = test_contact_make(M, L);
    ovr_flow_form form = ovr_flow_form_default();
    ovr_options o = test_options();
    ovr_error err = {0};
    given.M = M, given.L = L;
    given.alpha = 17e-9, given.modulus = 226e9;
    given.slide_to_roll = S;
    CHECK_OK(ovr_contact_resolve(&given, &c.contact, &err), &err);
    form.rheology = OVR_EYRING;
    form.stress = tau0;
    CHECK_OK(ovr_lubricant_flow(&c.contact, &form, &c.lubricant, &err), &err);
    o.level = level;
    ovr_simulation *sim = ovr_simulation_create(&c.contact, &c.lubricant, &o,
                                                NULL, &err);
    assert_non_null(sim);
    return sim;
}

TEST(steady_contacts_converge)
{
    static const double contact[][2] = {{5, 5},   {20, 10}, {20, 2.5},
                                        {50, 14}, {100, 5}, {200, 14}};
    static const double tau0[] = {2e6, 5e6, 15e6}, S[] = {0, 0.1, 0.5, 2};
    int ways = 0, cycles = 0;
    for (int k = 0; k < 144; k++) {
        const double *c = contact[k / 24];
        ovr_simulation *sim = eyring(c[0], c[1], S[k % 4], tau0[k / 4 % 3],
                                     k / 12 % 2 ? 10 : 8);
        ovr_error err = {0};
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        ways += *ovr_simulation_strategy(sim) != '\0';
        cycles += ovr_simulation_observation(sim)->cycles;
        ovr_simulation_free(sim);
    }
    print_message("    144 contacts, %d by another way, %.1f cycles each\n",
                  ways, cycles / 144.);
}

TEST(random_runs_go_through)
{
    const char *told = getenv("OVERROLL_RUNS");
    test_thinning_survey(20261122, told ? atoi(told) : 200, 7);
}
