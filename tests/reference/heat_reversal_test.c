/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat with a reversing entrainment speed: the surfaces return with the heat
 * that they have absorbed. */
#include <math.h>

#include "contact/contact.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

static ovr_history *ramp(double from, double to, double duration)
{
    ovr_history_form f = ovr_history_form_default();
    ovr_error err = {0};
    f.kind = OVR_HISTORY_RAMP;
    f.from = from;
    f.to = to;
    f.duration = duration;
    ovr_history *made = ovr_history_create(&f, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static ovr_simulation *begin(double slide, int level, ovr_history *speed)
{
    test_hot hot = test_hot_make(20, 10, slide, 5e6, NULL);
    ovr_options o = test_options();
    ovr_error err = {0};
    o.level = level;
    o.outlet = 4;
    o.tolerance = 1e-9;
    ovr_simulation *sim = test_hot_made(&hot, &o);
    ovr_simulation_histories(sim, NULL, speed);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

static void step(ovr_simulation *sim)
{
    ovr_error err = {0};
    double D = ovr_simulation_state(sim)->D;
    CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
}

static void check_mirror(const ovr_observation *a, const ovr_observation *b)
{
    CHECK_CLOSE(b->H_cen, a->H_cen, 1e-7);
    CHECK_CLOSE(b->H_min, a->H_min, 1e-7);
    CHECK_CLOSE(b->T_max_rise, a->T_max_rise, 1e-6);
    CHECK_CLOSE(b->T_1_max_rise, a->T_1_max_rise, 1e-6);
    CHECK_CLOSE(b->T_2_max_rise, a->T_2_max_rise, 1e-6);
    CHECK_CLOSE(b->heat_flow_1, a->heat_flow_1, 1e-6);
    CHECK_CLOSE(b->heat_flow_2, a->heat_flow_2, 1e-6);
    CHECK_CLOSE(b->F_slide, -a->F_slide, 1e-6);
    CHECK_NEAR(b->X_T_film_max, -a->X_T_film_max, 1e-9);
    CHECK_NEAR(b->mass_balance, a->mass_balance, 1e-6);
    CHECK_NEAR(b->energy_defect, a->energy_defect, 1e-4);
}

/* The same the other way round. */
TEST(mirror_runs_agree)
{
    ovr_history *there = ramp(1, -1, 1.2), *back = ramp(-1, 1, 1.2);
    ovr_simulation *one = begin(0.5, 6, there), *two = begin(0.5, 6, back);
    const ovr_observation *a = ovr_simulation_observation(one);
    const ovr_observation *b = ovr_simulation_observation(two);
    check_mirror(a, b);
    while (a->T < 2) {
        step(one);
        step(two);
        check_mirror(a, b);
    }
    print_message("T = %g: film %.3g, rises %.3g %.3g %.3g\n", a->T, a->H_cen,
                  a->T_max_rise, a->T_1_max_rise, a->T_2_max_rise);
    ovr_simulation_free(one);
    ovr_simulation_free(two);
    ovr_history_free(there);
    ovr_history_free(back);
}

/* Long after the turn it is the start's mirror image, which was marched. */
TEST(comes_to_rest_as_it_began)
{
    ovr_history *there = ramp(1, -1, 1);
    ovr_simulation *sim = begin(0.5, 5, there);
    const ovr_observation *o = ovr_simulation_observation(sim), first = *o;
    while (o->T < 14)
        step(sim);
    print_message("film %.1e, rises %.1e %.1e %.1e, friction %.1e off\n",
                  o->H_cen / first.H_cen - 1,
                  o->T_max_rise / first.T_max_rise - 1,
                  o->T_1_max_rise / first.T_1_max_rise - 1,
                  o->T_2_max_rise / first.T_2_max_rise - 1,
                  -o->F_slide / first.F_slide - 1);
    CHECK_CLOSE(o->H_cen, first.H_cen, 1e-3);
    CHECK_CLOSE(o->F_slide, -first.F_slide, 1e-3);
    CHECK_CLOSE(o->T_max_rise, first.T_max_rise, 5e-3);
    CHECK_CLOSE(o->T_1_max_rise, first.T_1_max_rise, 5e-3);
    CHECK_CLOSE(o->T_2_max_rise, first.T_2_max_rise, 5e-3);
    CHECK_NEAR(o->X_T_film_max, -first.X_T_film_max, 0.1);
    ovr_simulation_free(sim);
    ovr_history_free(there);
}
