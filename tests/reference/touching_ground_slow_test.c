/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ground surfaces that touch under a law of what the mesh has not: a tenth of
 * the pairs of verify/touching_ground_test, a level below, and a share that
 * does not hang on the level. */
#include <math.h>
#include <stdio.h>

#include "support/ground.h"
#include "support/test.h"

#include "overroll/overroll.h"

static void ground_pairs_go_through(void **state)
{
    (void)state;
    test_ground_tally thick = test_ground_survey(33100, 10, 0.7, 3, 6, 3),
                      thin = test_ground_survey(33100, 5, 0.3, 0.7, 6, 3);
    assert_int_equal(thick.broken, 0);
    assert_int_equal(thin.broken, 0);
}

/* Lambda 1: a film of 194 nm over surfaces of 137 nm each, waves of 0.15 to
 * 1 b; the mean of the contact share over the run. */
static double share_of(const char *law, int level)
{
    enum { SHARE = 0 };
    char text[1000];
    ovr_error err = {0};
    ovr_run_options how = {0};
    snprintf(text, sizeof text,
             "[contact]\nhertz_pressure = 1 GPa\nradius = 6.84 mm\n"
             "modulus = 227 GPa\nmean_speed = 3.22 m/s\nslide_to_roll = 0.3\n"
             "viscosity = 10 mPa.s\nalpha = 20 1/GPa\n"
             "[lubricant]\nrheology = eyring\neyring_stress = 5 MPa\n"
             "[domain]\ninlet = -3\noutlet = 2\nlevel = %d\n"
             "[time]\nend = 4.6\nscheme = characteristic\nstep = grid\n"
             "[boundary]\nof = unresolved\n%s"
             "[feature f1]\nshape = roughness\nRq = 137 nm\nlength = 8\n"
             "shortest = 0.15\nrolloff = 1\nseed = 1\nstart = inlet\n"
             "[feature f2]\nshape = roughness\nsurface = 2\nRq = 137 nm\n"
             "length = 8\nshortest = 0.15\nrolloff = 1\nseed = 2\n"
             "start = inlet\n",
             level, law);
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *run = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    CHECK_OK(run ? OVR_OK : err.status, &err);
    CHECK_OK(ovr_run_go(run, &err), &err);
    double share =
        ovr_simulation_statistics(ovr_run_about(run)->sim)->mean.more[SHARE];
    ovr_run_free(run);
    ovr_case_free(c);
    return share;
}

/* exp((60 nm - h)/20 nm) falls by e over more than a mesh changes the film;
 * what 20 nm and 5 nm make of it is printed beside. */
static void share_is_that_of_any_level(void **state)
{
    static const char wide[] = "law = exponential\namplitude = 20.0855\n"
                               "decay = 20 nm\n";
    static const char narrow[] = "law = exponential\namplitude = 54.6\n"
                                 "decay = 5 nm\n";
    (void)state;
    double share[3], thin[2];
    for (int k = 0; k < 3; k++)
        share[k] = share_of(wide, 7 + k);
    for (int k = 0; k < 2; k++)
        thin[k] = share_of(narrow, 7 + k);
    print_message("60/20 nm: %.5f %.5f %.5f on levels 7, 8, 9; 20/5 nm: %.3g "
                  "%.3g on levels 7, 8\n",
                  share[0], share[1], share[2], thin[0], thin[1]);
    assert_true(share[2] > 1e-3);
    CHECK_CLOSE(share[0], share[2], 0.05);
    CHECK_CLOSE(share[1], share[2], 0.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ground_pairs_go_through),
        cmocka_unit_test(share_is_that_of_any_level)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
