/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Estimated discretization errors of random cases of mixed physics
 * (support/error_estimates.h): 5 cases at level 5; in make verify 70, and 30 at
 * level 6. According to overroll(1) some estimate is below half of the error in
 * one run of five, mostly for a pressure peak. A sample of n may exceed n/5 by
 * two standard deviations, 2 sqrt(n/5 4/5). These limits are 2 of 5, 10 of 30
 * and 20 of 70. */
#include <math.h>

#include "support/error_estimates.h"
#include "support/test.h"

/* With faces = gap, H_min of three levels agrees within 0.3 % by chance. On
 * finer levels it is 6 % smaller. */
static const char by_chance[] = "[contact]\n"
                                "load = 43457 N/m\n"
                                "radius = 6.444 mm\n"
                                "modulus = 242.3 GPa\n"
                                "mean_speed = 10.071 m/s\n"
                                "slide_to_roll = -0.455066\n"
                                "[lubricant]\n"
                                "viscosity = 0.019629 Pa.s\n"
                                "alpha = 19.83 1/GPa\n"
                                "[heat]\n"
                                "model = lobatto\n"
                                "temperature = 374.34 K\n"
                                "points = 7\n"
                                "temperature_2 = 444.76 K\n"
                                "[domain]\n"
                                "level = 5\n"
                                "inlet = -34.511806916033279\n"
                                "outlet = 1.7235580930157242\n"
                                "order = 2\n"
                                "faces = gap\n"
                                "[time]\n"
                                "scheme = upstream2\n"
                                "end = 4.4093\n"
                                "[load]\n"
                                "history = step\n"
                                "from = 1.27318\n"
                                "to = 1.32029\n"
                                "start = 1.74357\n"
                                "[cavitation]\n"
                                "model = conserving\n"
                                "[supply]\n"
                                "model = film\n"
                                "thickness_1 = 0.028171\n"
                                "thickness_2 = 0.0743571\n"
                                "[feature f0]\n"
                                "shape = roughness\n"
                                "surface = 2\n"
                                "Rq = 0.0346347\n"
                                "length = 6.77891\n"
                                "rolloff = 1.46674\n"
                                "shortest = 0.366684\n"
                                "seed = 0\n"
                                "start = 0.850268\n";

/* The period of the load is shorter than a few time steps of coarse levels. */
static const char swinging[] = "[contact]\n"
                               "load = 2.8249e+05 N/m\n"
                               "radius = 39.72 mm\n"
                               "modulus = 157.7 GPa\n"
                               "mean_speed = 1.9529 m/s\n"
                               "[lubricant]\n"
                               "viscosity = 0.1024 Pa.s\n"
                               "alpha = 18.24 1/GPa\n"
                               "rheology = eyring\n"
                               "eyring_stress = 17.34 MPa\n"
                               "[domain]\n"
                               "level = 5\n"
                               "inlet = -20.331687773479224\n"
                               "outlet = 5.0887810251248556\n"
                               "[time]\n"
                               "end = 4.39487\n"
                               "[load]\n"
                               "history = sine\n"
                               "amplitude = 0.724888\n"
                               "period = 0.18264\n"
                               "[speed]\n"
                               "history = sine\n"
                               "amplitude = 0.0698395\n"
                               "period = 5.16279\n"
                               "[feature f0]\n"
                               "shape = groove\n"
                               "surface = 2\n"
                               "depth = 0.0083729\n"
                               "width = 1.17608\n"
                               "flank = 0.29402\n"
                               "start = -4.51976\n"
                               "[feature f1]\n"
                               "shape = wave\n"
                               "surface = 1\n"
                               "amplitude = 0.0213285\n"
                               "wavelength = 0.63076\n"
                               "origin = -3.47692\n";

TEST(levels_that_agree_by_chance)
{
    test_error_estimates_case(by_chance, 5, 3);
    test_error_estimates_case(swinging, 5, 2);
}

static int at_most(int n)
{
    return (int)(0.2 * n + 2 * sqrt(0.16 * n));
}

TEST(estimated_errors_are_not_too_small)
{
    int cases = test_draws(5, 70), finer = test_draws(0, 30);
    test_error_estimates_survey(31000, cases, 5, 3, at_most(cases));
    if (finer)
        test_error_estimates_survey(41000, finer, 6, 2, at_most(finer));
}
