/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Entrainment speed passing through zero: runs compared with the dense Newton
 * solution, which uses no mirror image, and with their mirror images; order at
 * the time of reversal. */
#include <math.h>
#include <string.h>

#include "support/reversal.h"
#include "support/test.h"

/* The issue asks for 1e-6 of the whole run. */
TEST(agrees_with_dense_newton)
{
    const test_reversal cases[] = {
        {.M = 20, .L = 10, .mean = 0, .swing = 1, .period = 2, .end = 1.6},
        {.M = 50,
         .L = 5,
         .mean = 0.2,
         .swing = -1,
         .period = 1.4,
         .end = 0.9,
         .feature = {'l', -0.05, 0.6, 0.4, 0, 0}}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        test_reversal r = cases[k];
        r.level = 5;
        r.tolerance = 1e-10;
        r.scheme = k ? OVR_UPSTREAM1 : OVR_UPSTREAM2;
        test_apart apart = test_reversal_against_dense(&r);
        print_message("    M %g L %g: P within %.1e, H_cen %.1e\n", r.M, r.L,
                      apart.P, apart.H);
        assert_true(apart.reversals >= 1);
        assert_true(apart.P < 1e-6 && apart.H < 1e-6);
    }
}

/* The same run the other way round: positions and speeds of the other sign. */
TEST(mirror_runs_agree)
{
    const ovr_scheme schemes[] = {OVR_UPSTREAM2, OVR_UPSTREAM1,
                                  OVR_CHARACTERISTIC};
    for (int k = 0; k < 5; k++) { /* 3: a flow law, 4: of fourth order */
        test_reversal r = {.M = 20,
                           .L = 10,
                           .mean = 0.1,
                           .swing = 1,
                           .period = 2,
                           .end = 2.2,
                           .level = 6,
                           .scheme = schemes[k < 4 ? k % 3 : 2],
                           .order = k == 4 ? 4 : 2,
                           .eyring = k == 3 ? 0.05 : 0,
                           .slide = k == 3 ? 0.5 : 0,
                           .tolerance = 1e-9,
                           .feature = {'l', -0.05, 0.3, -0.6, 1, 0}};
        test_apart apart = test_reversal_against_mirror(&r);
        print_message("    %s, order %d%s: P within %.1e, H %.1e\n",
                      ovr_scheme_name(r.scheme), r.order,
                      r.eyring > 0 ? ", Eyring, sliding" : "", apart.P,
                      apart.H);
        assert_true(apart.reversals >= 2);
        assert_true(apart.P < 1e-9 && apart.H < 1e-9);
    }
}

/* H_min at the instant, where the wedge is zero: errors that fall by four. */
static double at_the_reversal(int level, double steps_of_mesh,
                              ovr_scheme scheme, int order)
{
    const double turn = 8. / 7;
    const test_reversal r = {.M = 20,
                             .L = 10,
                             .mean = 0,
                             .swing = 1,
                             .period = 4 * turn,
                             .end = turn,
                             .level = level,
                             .steps_of_mesh = steps_of_mesh,
                             .scheme = scheme,
                             .order = order};
    return test_reversal_film(&r);
}

static void second_order(const double H[4], const char *of)
{
    double ratio[2];
    for (int k = 0; k < 2; k++)
        ratio[k] = (H[k + 1] - H[k]) / (H[k + 2] - H[k + 1]);
    print_message("    H_min at the turn by %s: %.7f %.7f %.7f %.7f, orders "
                  "%.2f %.2f\n",
                  of, H[0], H[1], H[2], H[3], log2(ratio[0]), log2(ratio[1]));
    for (int k = 0; k < 2; k++)
        assert_true(ratio[k] > 3.2 && ratio[k] < 5);
}

TEST(film_at_the_reversal_is_second_order)
{
    double H[4];
    for (int k = 0; k < 4; k++)
        H[k] = at_the_reversal(7, 8 >> k, OVR_UPSTREAM2, 2);
    second_order(H, "dT");
    for (int k = 0; k < 4; k++)
        H[k] = at_the_reversal(6 + k, 1, OVR_UPSTREAM2, 2);
    second_order(H, "dT = D");
}

/* Off the limit of second order along the characteristic, Richardson's of
 * levels 8 and 9: at level 7 corrections of fourth order leave a quarter of
 * what it lacks itself, or less. */
TEST(corrections_hold_through_the_reversal)
{
    double at[3], corrected;
    for (int k = 0; k < 3; k++)
        at[k] = at_the_reversal(7 + k, 1, OVR_CHARACTERISTIC, 2);
    corrected = at_the_reversal(7, 1, OVR_CHARACTERISTIC, 4);
    double limit = at[2] + (at[2] - at[1]) / 3;
    print_message("    H_min at the turn off by %.1e, of fourth order %.1e\n",
                  at[0] / limit - 1, corrected / limit - 1);
    assert_true(fabs(corrected - limit) < 0.25 * fabs(at[0] - limit));
}
