/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat with opposite sliding: each surface enters cold at its own end. */
#include <math.h>

#include "physics/heat/heated.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

static ovr_simulation *solved(double M, double L, double S, int level)
{
    test_hot hot = test_hot_make(M, L, S, 5e6, NULL);
    ovr_error err = {0};
    ovr_simulation *sim = test_hot_simulation(&hot, level);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

/* The steady contact stays as it is in time, where each surface goes its own
 * way from step to step and nothing is marched along x. */
static void stays(double M, double L, double S)
{
    ovr_simulation *sim = solved(M, L, S, 5);
    ovr_error err = {0};
    const ovr_observation first = *ovr_simulation_observation(sim);
    const ovr_observation *o = ovr_simulation_observation(sim);
    double D = ovr_simulation_state(sim)->D;
    while (o->T < 8) /* both cross the domain */
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
    print_message(
        "M %g L %g S %g: mu %.1e, film %.1e, T %.1e %.1e %.1e off, "
        "energy %.1e\n",
        M, L, S, o->mu_slide / first.mu_slide - 1, o->H_cen / first.H_cen - 1,
        o->T_max_rise / first.T_max_rise - 1,
        o->T_1_max_rise / first.T_1_max_rise - 1,
        o->T_2_max_rise / first.T_2_max_rise - 1, first.energy_defect);
    CHECK_CLOSE(o->mu_slide, first.mu_slide, 2e-4);
    CHECK_CLOSE(o->H_cen, first.H_cen, 2e-4);
    CHECK_CLOSE(o->T_max_rise, first.T_max_rise, 1e-3);
    CHECK_CLOSE(o->T_1_max_rise, first.T_1_max_rise, 1e-3);
    CHECK_CLOSE(o->T_2_max_rise, first.T_2_max_rise, 1e-3);
    CHECK_NEAR(first.energy_defect, 0, 4e-3); /* level 5 */
    ovr_simulation_free(sim);
}

TEST(steady_contacts_stay)
{
    stays(12, 8, 3);
    stays(20, 10, 2.5);
}

/* The two surfaces swapped mirror everything. */
TEST(surfaces_swapped)
{
    ovr_simulation *sim = solved(12, 8, 4, 5), *swapped = solved(12, 8, -4, 5);
    const ovr_observation *a = ovr_simulation_observation(sim);
    const ovr_observation *b = ovr_simulation_observation(swapped);
    CHECK_CLOSE(b->H_cen, a->H_cen, 1e-9);
    CHECK_CLOSE(b->F_slide, -a->F_slide, 1e-8);
    CHECK_CLOSE(b->F_1, a->F_2, 1e-8);
    CHECK_CLOSE(b->T_1_max_rise, a->T_2_max_rise, 1e-7);
    CHECK_CLOSE(b->T_2_max_rise, a->T_1_max_rise, 1e-7);
    CHECK_CLOSE(b->heat_flow_2, a->heat_flow_1, 1e-7);
    ovr_simulation_free(sim);
    ovr_simulation_free(swapped);
}

/* Outside the contact each surface is colder at its inlet, where hot lubricant
 * and conduction from the contact have heated it. */
TEST(each_surface_enters_colder)
{
    ovr_simulation *sim = solved(12, 8, 4, 5);
    const ovr_heated *h = sim->heated;
    size_t n = sim->now.n, in = 0, out;
    while (sim->now.X[in] < -1.2)
        in++;
    out = in;
    while (out + 1 < n && sim->now.X[out] < 1.2)
        out++;
    int last = h->cross_film.n - 1;
    print_message("at the inlet %.3f and %.3f K, at the outlet %.3f and %.3f "
                  "K\n",
                  h->T[0][in], h->T[last][in], h->T[0][out], h->T[last][out]);
    assert_true(h->T[0][in] < 0.6 * h->T[last][in]);
    assert_true(h->T[last][out] < 0.7 * h->T[0][out]);
    ovr_simulation_free(sim);
}
