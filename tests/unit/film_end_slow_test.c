/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Loads and speeds for which the end of the film moves by many nodes between
 * solutions. These runs failed before film ends were moved in one pass and the
 * criterion for cavitated nodes had the unit of its row. */
#include <string.h>

#include "contact/contact.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/test.h"

static ovr_simulation *begin(double M, double L, double outlet, int level)
{
    ovr_options o = ovr_options_default();
    o.inlet = -4;
    o.outlet = outlet;
    o.level = level;
    o.scheme = OVR_UPSTREAM2;
    o.order = 2;
    return test_simulation(M, L, &o);
}

typedef struct swing {
    double M, L, outlet, end;
    ovr_history_form load;
    double speed; /* amplitude of its sine, or 0 */
} swing;

static ovr_history *made(ovr_history_form form)
{
    ovr_error err = {0};
    ovr_history *history = ovr_history_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    return history;
}

static ovr_history_form sine(double amplitude, double period)
{
    ovr_history_form form = ovr_history_form_default();
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = amplitude;
    form.period = period;
    return form;
}

static void run(const swing *w, double max_cycles, long max_retries)
{
    ovr_error err = {0};
    ovr_history *load = made(w->load);
    ovr_history *speed = made(sine(w->speed, 2.7237));
    ovr_simulation *sim = begin(w->M, w->L, w->outlet, 8);
    ovr_simulation_histories(sim, load, speed);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_statistics start = *ovr_simulation_statistics(sim);
    ovr_march march = {0};
    march.end = w->end;
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    ovr_statistics end = *ovr_simulation_statistics(sim);
    double cycles = (double)(end.cycles - start.cycles) /
                    (double)(end.steps - start.steps);
    print_message("M = %g: %.2f cycles a step, %ld retries\n", w->M, cycles,
                  end.retries - start.retries);
    assert_true(cycles < max_cycles);
    assert_true(end.retries - start.retries <= max_retries);
    assert_int_equal(end.marked, 0);
    ovr_simulation_free(sim);
    ovr_history_free(load);
    ovr_history_free(speed);
}

static ovr_history_form jump_to(double load)
{
    ovr_history_form jump = ovr_history_form_default();
    jump.kind = OVR_HISTORY_STEP;
    jump.from = 1;
    jump.to = load;
    jump.start = 0.05;
    return jump;
}

/* Version 0.1.0 failed at steps 19, 1 and 1,434. */
TEST(loads_that_failed)
{
    ovr_history_form swings = sine(0.48, 1.756);
    run(&(swing){200, 10, 1.5, 0.3, jump_to(1.1), 0}, 5, 10);
    run(&(swing){200, 10, 2.5, 1.5, swings, 0}, 6.5, 3);
    run(&(swing){329, 4.9, 1.5, 4.6, swings, 0.4777}, 5.5, 3);
}

/* Within one step of a mesh: films filled to the outlet, pressures above 2
 * there.  Version 0.1.0 failed at the step. */
TEST(loads_that_jump)
{
    run(&(swing){50, 10, 1.5, 0.1, jump_to(2), 0}, 80, 80);
    run(&(swing){500, 10, 1.5, 0.1, jump_to(1.1), 0}, 15, 30);
    run(&(swing){200, 10, 1.5, 0.1, jump_to(1.5), 0}, 60, 60);
    run(&(swing){200, 10, 1.5, 0.1, jump_to(0.5), 0}, 15, 20);
}

/* The film is solved, and the message contains the missing accuracy. */
TEST(a_tolerance_below_rounding)
{
    ovr_options o = test_options();
    ovr_error err = {0};
    o.level = 7;
    o.tolerance = 1e-15;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    assert_int_equal(ovr_simulation_steady(sim, &err), OVR_NOT_CONVERGED);
    assert_non_null(strstr(err.message, "below rounding"));
    CHECK_CLOSE(ovr_simulation_observation(sim)->H_cen, 0.0842, 2e-3);
    ovr_simulation_free(sim);
}

/* Rounding grows with the speed, and is no reason to halve a step. */
TEST(a_tolerance_below_rounding_at_speed)
{
    ovr_history_form ramp = ovr_history_form_default(), light = ramp;
    ovr_options o = test_options();
    ovr_error err = {0};
    o.scheme = OVR_UPSTREAM2;
    o.order = 2;
    ramp.kind = OVR_HISTORY_RAMP;
    ramp.from = 0.8;
    ramp.to = 2.4;
    ramp.start = 0;
    ramp.duration = 0.6;
    light.from = light.to = 0.6;
    o.level = 9;
    o.inlet = -43.38;
    o.outlet = 3.148;
    o.tolerance = 1e-7;
    light.kind = OVR_HISTORY_STEP;
    ovr_history *load = made(light), *speed = made(ramp);
    ovr_simulation *sim = test_simulation(5.086, 6.279, &o);
    ovr_simulation_histories(sim, load, speed);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_march march = {0};
    march.end = 0.9;
    march.dT = 0.05;
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
    assert_int_equal(ovr_simulation_statistics(sim)->substeps, 0);
    ovr_simulation_free(sim);
    ovr_history_free(load);
    ovr_history_free(speed);
}
