/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Residual histories, cycle by cycle to 1e-8, of a steady solution and of ten
 * steps of each scheme. The numbers are the program's own, two digits of each
 * as printed by it (the test prints new ones if they differ). This test does
 * not check that solutions are right. It detects every change of smoother,
 * transfers, coarse-grid equations, initial guess or tolerances.
 *
 * The history of one solve is observed by solving again with a tolerance just
 * below the final residual of the last solve. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/contact.h"
#include "support/copied.h"

enum { MAX = 20, STEPS = 10 };
static const double enough = 1e-8;

/* All that the history depends on is written out. */
static ovr_options form(ovr_scheme scheme, double tolerance)
{
    ovr_options o = test_options();
    o.inlet = -4;
    o.outlet = 1.5;
    o.level = 7;
    o.coarsest_level = 3;
    o.scheme = scheme;
    o.smoother = OVR_LINE;
    o.cycle_index = 1;
    o.sweeps_before = o.sweeps_after = 1;
    o.max_cycles = 60;
    o.stop = OVR_STOP_NEGLIGIBLE;
    o.tolerance = tolerance;
    o.mlmi_order = 8;
    o.mlmi_range = 24;
    return o;
}

static test_feature dent = {'l', -0.05, 0.5, -1.2, 1, 0};

static ovr_simulation *made(ovr_scheme scheme, double tolerance)
{
    ovr_options o = form(scheme, tolerance);
    ovr_simulation *sim = test_simulation(20, 10, &o);
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    return sim;
}

/* -------------------------------------------------------------- histories */

/* Residual of the steady start, or of the step of dT that follows `before`,
 * solved to a tolerance. */
static double solved(ovr_scheme scheme, ovr_simulation *before, double dT,
                     double tolerance)
{
    ovr_error err = {0};
    ovr_simulation *sim = made(scheme, tolerance);
    if (before)
        test_copy_state(before, sim);
    CHECK_OK(before ? ovr_simulation_step(sim, dT, &err)
                    : ovr_simulation_steady(sim, &err),
             &err);
    ovr_observation seen = *ovr_simulation_observation(sim);
    ovr_simulation_free(sim);
    assert_int_equal(seen.retries, 0);
    return seen.residual;
}

/* Residuals above 1e-8, to two digits, one for each cycle. */
static void history(ovr_scheme scheme, ovr_simulation *before, double dT,
                    char text[8 * MAX])
{
    double tolerance = 0.999;
    size_t used = 0;
    for (int k = 0; k < MAX && tolerance > enough; k++) {
        double residual = solved(scheme, before, dT, tolerance);
        if (residual > enough)
            used += (size_t)snprintf(text + used, 8 * MAX - used, "%s%.1e",
                                     k ? " " : "", residual);
        tolerance = 0.999 * residual;
    }
}

/* Each residual within one unit of its second digit. */
static bool alike(const char *is, const char *was)
{
    char *end_is, *end_was;
    while (*is && *was) {
        double x = strtod(is, &end_is), y = strtod(was, &end_was);
        if (fabs(x - y) > 1.01 * pow(10, floor(log10(y)) - 1))
            return false;
        is = end_is;
        was = end_was;
    }
    return !*is && !*was;
}

static void compare(ovr_scheme scheme, ovr_simulation *before, double dT,
                    const char *was)
{
    char is[8 * MAX] = "";
    history(scheme, before, dT, is);
    if (!alike(is, was))
        fail_msg("residuals were\n    %s\nand are\n    %s", was, is);
}

TEST(of_a_steady_solution)
{
    compare(OVR_UPSTREAM1, NULL, 0, "5.4e-03 1.6e-04 5.9e-06 1.6e-07");
    compare(OVR_UPSTREAM2, NULL, 0, "4.1e-03 2.5e-04 2.0e-05 1.6e-06 1.3e-07");
}

static void of_steps(ovr_scheme scheme, const char *const was[STEPS])
{
    const double D = 5.5 / 896;
    ovr_error err = {0};
    ovr_simulation *sim = made(scheme, enough);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (int step = 0; step < STEPS; step++) {
        compare(scheme, sim, D, was[step]);
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
    }
    ovr_simulation_free(sim);
}

TEST(of_ten_steps)
{
    static const char *const upstream1[STEPS] = {
        "6.0e-03 2.6e-04 1.3e-06", "2.1e-02 1.0e-04 6.8e-07",
        "6.9e-04 2.4e-06 1.4e-08", "6.3e-01 1.8e-03 9.3e-06",
        "2.2e-01 1.0e-03 5.3e-06", "8.5e-02 5.0e-04 2.6e-06",
        "3.5e-02 2.3e-04 1.2e-06", "1.4e-02 1.1e-04 5.4e-07",
        "6.0e-03 5.3e-05 2.6e-07", "2.6e-03 2.9e-05 1.4e-07"};
    static const char *const upstream2[STEPS] = {
        "3.9e-03 1.5e-05 7.0e-08", "1.5e-02 4.9e-05 4.1e-07",
        "2.5e-03 1.2e-05 1.2e-07", "3.8e-03 1.5e-05",
        "6.2e-01 1.6e-03 3.2e-06", "4.0e-01 6.1e-04 2.8e-06",
        "1.3e-01 2.3e-04 1.5e-06", "1.6e-02 4.5e-05 4.7e-07",
        "1.3e-02 2.0e-05 1.6e-07", "1.0e-02 1.6e-05 1.1e-07"};
    static const char *const characteristic[STEPS] = {
        "6.9e-03 3.1e-05 3.1e-07", "1.1e-02 4.0e-05 4.4e-07",
        "6.7e-04 1.6e-06",         "1.6e-03 5.4e-06",
        "4.2e-01 9.7e-04 3.3e-06", "3.5e-01 4.8e-04 1.1e-06",
        "1.6e-01 1.7e-04 2.2e-07", "3.2e-02 3.5e-05 1.2e-07",
        "9.0e-03 1.8e-05 1.3e-07", "1.0e-02 1.6e-05 9.4e-08"};
    of_steps(OVR_UPSTREAM1, upstream1);
    of_steps(OVR_UPSTREAM2, upstream2);
    of_steps(OVR_CHARACTERISTIC, characteristic);
}
