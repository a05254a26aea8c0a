/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic stresses above yield: limits of the smooth contact, and strips of
 * pressure above their surroundings. */
#include <math.h>

#include "stress/stress.h"
#include "stress/yield.h"
#include "support/test.h"

/* An independent computation's: p_h over Y at first yield by von Mises, nu =
 * 0.3, and its depth; collapse of a strip of uniform pressure over Y. */
static const double first_yield = 1.7936699, first_depth = 0.7043,
                    collapse = 2.9684999026134693;

TEST(limits)
{
    double z;
    ovr_hertz_criterion(OVR_CRITERION_VON_MISES, 0, 0.3, &z);
    CHECK_NEAR(ovr_first_yield(0.3), first_yield, 1e-6);
    CHECK_NEAR(z, first_depth, 1e-4);
    /* K. L. Johnson 1985: 3.1 k and 4 k, k = Y/sqrt 3 */
    CHECK_NEAR(ovr_first_yield(0.3) * sqrt(3), 3.1067272, 1e-6);
    CHECK_NEAR(ovr_shakedown_limit() * sqrt(3), 4, 1e-12 * 4);
    CHECK_NEAR(ovr_strip_collapse(), collapse, 1e-12);
}

enum { NODES = 4001 };
static const double INLET = -2.5, OUTLET = 2.5;

static double node(size_t i)
{
    return INLET + (OUTLET - INLET) * (double)i / (NODES - 1);
}

static ovr_strip worst_of(const double *P, double minimum, double maximum)
{
    static double sums[NODES + 1];
    double D = node(1) - node(0);
    ovr_pressure_sums s = {NODES, sums};
    ovr_strip worst = {0};
    ovr_strip_find(&s, P, minimum / D, maximum / D, &worst);
    worst.middle = INLET + worst.middle * D;
    worst.width *= D;
    return worst;
}

/* What surrounds a strip adds to what it bears: only the difference counts. */
TEST(strip_on_a_background)
{
    static double P[NODES];
    const double around[] = {0, 0.4, 1};
    for (int k = 0; k < 3; k++) {
        for (size_t i = 0; i < NODES; i++)
            P[i] = fabs(node(i)) > 1           ? 0
                   : fabs(node(i) - 0.3) < 0.1 ? around[k] + 2
                                               : around[k];
        ovr_strip worst = worst_of(P, 0.02, 0.2);
        CHECK_NEAR(worst.excess, 2, 1e-9);
        CHECK_NEAR(worst.middle, 0.3, 0.1);
    }
}

/* Steel yields to the less loaded side; the load on the other side does not
 * prevent it. */
TEST(strip_yields_to_the_less_loaded_side)
{
    static double P[NODES];
    for (size_t i = 0; i < NODES; i++)
        P[i] = node(i) < -1 || node(i) > 0.3 ? 0 : node(i) < 0 ? 1 : 2;
    CHECK_NEAR(worst_of(P, 0.05, 0.25).excess, 2, 1e-9);
}

/* Integral of sqrt(1 - x^2) from 0. */
static double hertz_sum(double x)
{
    x = fmax(fmin(x, 1), -1);
    return (x * sqrt(1 - x * x) + asin(x)) / 2;
}

static double hertz_excess(double from, double w)
{
    double inside = hertz_sum(from + w) - hertz_sum(from);
    double left = hertz_sum(from) - hertz_sum(from - w);
    double right = hertz_sum(from + 2 * w) - hertz_sum(from + w);
    return (inside - fmin(left, right)) / w;
}

/* The smooth contact's own, by its integral: widths a third of an octave apart
 * and places a sixteenth leave 2 % at most. */
TEST(smooth_contact)
{
    static double P[NODES];
    double exact = 0;
    for (size_t i = 0; i < NODES; i++)
        P[i] = sqrt(fmax(0, 1 - node(i) * node(i)));
    for (double w = 0.02; w < 4; w *= 1.01)
        for (double from = -1 - w; from < 1; from += w / 100)
            exact = fmax(exact, hertz_excess(from, w));
    ovr_strip worst = worst_of(P, 0.02, 4);
    assert_true(worst.excess <= exact * (1 + 1e-3));
    assert_true(worst.excess >= exact * 0.98);
    /* a mean of pressures below 1 */
    assert_true(exact < 1);
}

/* A later pressure counts only where it is worse. */
TEST(only_worse_ones)
{
    static double P[NODES], sums[NODES + 1];
    ovr_pressure_sums s = {NODES, sums};
    ovr_strip worst = {.excess = 0.9};
    for (size_t i = 0; i < NODES; i++)
        P[i] = sqrt(fmax(0, 1 - node(i) * node(i)));
    assert_true(!ovr_strip_find(&s, P, 8, 400, &worst));
    assert_true(worst.excess == 0.9 && worst.width == 0);
}
