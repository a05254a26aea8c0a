/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time-dependent radii: slopes of histories compared with difference quotients,
 * and the cubic term of a convected curvature with exact involutes. */
#include "contact/curvature.h"

#include <math.h>

#include "contact/contact.h"
#include "contact/history.h"
#include "support/test.h"

static ovr_history *history(ovr_history_form form)
{
    ovr_error err = {0};
    ovr_history *made = ovr_history_create(&form, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

/* A table of f, which takes `data`, from 0 to `end`. */
static ovr_history *table(double f(const void *, double), const void *data,
                          double end)
{
    enum { POINTS = 401 };
    double T[POINTS], value[POINTS];
    ovr_history_form form = ovr_history_form_default();
    for (int k = 0; k < POINTS; k++) {
        T[k] = end * k / (POINTS - 1);
        value[k] = f(data, T[k]);
    }
    form.kind = OVR_HISTORY_TABLE;
    form.points = POINTS;
    form.T = T;
    form.value = value;
    return history(form);
}

static double wavy(const void *data, double T)
{
    (void)data;
    return 1 + 0.3 * sin(T) + 0.1 * T;
}

static void check_slope(const ovr_history *h, double T)
{
    const double d = 1e-5;
    double by_differences =
        (ovr_history_value(h, T + d) - ovr_history_value(h, T - d)) / (2 * d);
    CHECK_NEAR(ovr_history_slope(h, T), by_differences, 1e-7);
}

TEST(slopes_are_difference_quotients)
{
    ovr_history_form form = ovr_history_form_default();
    form.kind = OVR_HISTORY_RAMP;
    form.from = 0.6;
    form.to = 1.7;
    form.start = 1;
    form.duration = 3;
    form.amplitude = 0.4;
    form.period = 2.5;
    ovr_history *ramp = history(form);
    form.kind = OVR_HISTORY_SINE;
    ovr_history *sine = history(form), *points = table(wavy, NULL, 6);
    uint64_t seed = 1;
    for (int k = 0; k < 200; k++) {
        double T = test_random(&seed, 1.01, 5.99);
        check_slope(ramp, T);
        check_slope(sine, T);
        check_slope(points, T);
        check_slope(ramp, T - 6);
        check_slope(points, T + 5.1);
    }
    CHECK_NEAR(ovr_history_slope(points, 0), 0.4, 1e-3);
    CHECK_NEAR(ovr_history_slope(points, 6), 0.1 + 0.3 * cos(6), 1e-3);
    assert_true(ovr_history_slope(NULL, 1) == 0);
    ovr_history_free(ramp);
    ovr_history_free(sine);
    ovr_history_free(points);
}

/* -------------------------------------------------------------- involutes */

/* Base radii and the length of the line of action between the base circles, in
 * R0; the contact's way along it a b/um, from R_1 = start at T = 0. */
typedef struct pair {
    double base[2], line, start, way;
} pair;

static double radius_1(const void *data, double T)
{
    const pair *p = data;
    return p->start + p->way * T;
}

static double radius(const void *data, double T)
{
    const pair *p = data;
    double R1 = radius_1(p, T);
    return R1 * (p->line - R1) / p->line;
}

/* u_k/um: w_k R_k, and w_k times the base radius is the contact's speed; the
 * unit um is that of both at T = 0. */
static double speed_of(const pair *p, int k, double T)
{
    double R[2] = {radius_1(p, T), p->line - radius_1(p, T)};
    double R0[2] = {p->start, p->line - p->start};
    double um = 0.5 * (R0[0] / p->base[0] + R0[1] / p->base[1]);
    return R[k] / p->base[k] / um;
}

static double speed(const void *p, double T)
{
    return 0.5 * (speed_of(p, 0, T) + speed_of(p, 1, T));
}

static double sliding(const void *p, double T)
{
    return speed_of(p, 0, T) - speed_of(p, 1, T);
}

/* Height of an involute over its tangent, `along` to the tip, at roll angle
 * R/base: x = rb ((a + s) sin s + cos s - 1), z = rb (a - (a + s) cos s +
 * sin s). */
static double involute(double base, double R, double along)
{
    double a = R / base, s = along / R;
    for (int k = 0; k < 60; k++) {
        double x = base * ((a + s) * sin(s) + cos(s) - 1);
        s -= (x - along) / (base * (a + s) * cos(s));
    }
    return base * (a - (a + s) * cos(s) + sin(s));
}

/* The largest difference from the gap between both teeth, b = kappa R0, in
 * units of b^2/R0.  The material of the driver moves to its root. */
static double gap_error(double kappa, bool convected)
{
    /* the contact's speed over um times b/R0 is dR_1/dT */
    pair p = {{2.5, 5.5}, 3.4, 1.1, 0};
    double um = 0.5 * (p.start / p.base[0] + (p.line - p.start) / p.base[1]);
    p.way = kappa / um;
    double end = 0.9 / p.way, worst = 0;
    ovr_history *R = table(radius, &p, end), *R1 = table(radius_1, &p, end);
    ovr_history *Cu = table(speed, &p, end), *V = table(sliding, &p, end);
    ovr_curving g = {R, R1, Cu, V, {1, 1}, convected};
    for (int k = 1; k < 8; k++) {
        double T = end * k / 8, one = radius_1(&p, T);
        ovr_smooth smooth = ovr_smooth_of(&g, T);
        CHECK_CLOSE(2 * smooth.half, 1 / radius(&p, T), 1e-5);
        for (double X = -4; X <= 2; X += 0.25) {
            double x = kappa * X;
            double h = involute(p.base[0], one, -x) +
                       involute(p.base[1], p.line - one, x);
            worst = fmax(worst,
                         fabs(h / (kappa * kappa) - ovr_smooth_at(&smooth, X)));
        }
    }
    ovr_history_free(R);
    ovr_history_free(R1);
    ovr_history_free(Cu);
    ovr_history_free(V);
    return worst;
}

/* The next term is X^4 (b/R)^2; without the cubic X^3 b/R is left. */
TEST(the_cubic_is_that_of_involutes)
{
    double with[2] = {gap_error(0.004, true), gap_error(0.002, true)};
    double without[2] = {gap_error(0.004, false), gap_error(0.002, false)};
    print_message("    b/R = .004, .002: %.2e %.2e, without the cubic %.2e "
                  "%.2e\n",
                  with[0], with[1], without[0], without[1]);
    CHECK_CLOSE(with[0] / with[1], 4, 0.1);
    CHECK_CLOSE(without[0] / without[1], 2, 0.1);
    assert_true(with[0] < 0.2 * without[0]);
}

/* Where both surfaces move alike it does not matter whose the curvature is. */
TEST(in_rolling_the_share_does_not_matter)
{
    const pair p = {{2.5, 5.5}, 3.4, 1.1, 0.01};
    ovr_history *R = table(radius, &p, 50), *R1 = table(radius_1, &p, 50);
    ovr_curving both = {R, NULL, NULL, NULL, {1, 1}, true}, each = both;
    each.radius_1 = R1;
    for (double T = 0; T < 50; T += 3) {
        ovr_smooth a = ovr_smooth_of(&both, T), b = ovr_smooth_of(&each, T);
        assert_true(a.cubic != 0);
        CHECK_CLOSE(a.cubic, b.cubic, 1e-12);
        assert_true(a.half == b.half);
    }
    ovr_history_free(R);
    ovr_history_free(R1);
}

/* A pass of a load zone: all of a history times its load. */
TEST(scaled_histories)
{
    ovr_history_form form = ovr_history_form_default();
    form.kind = OVR_HISTORY_SINE;
    form.amplitude = 0.4;
    form.period = 2.5;
    ovr_history *plain[] = {NULL, history(form), table(wavy, NULL, 6)};
    ovr_history *half[] = {NULL, history(form), table(wavy, NULL, 6)};
    ovr_error err = {0};
    for (int k = 0; k < 3; k++) {
        CHECK_OK(ovr_history_scale(&half[k], 0.5, NULL, &err), &err);
        for (double T = 0; T < 7; T += 0.7) {
            CHECK_NEAR(ovr_history_value(half[k], T),
                       0.5 * ovr_history_value(plain[k], T), 1e-15);
            CHECK_NEAR(ovr_history_integral(half[k], T),
                       0.5 * ovr_history_integral(plain[k], T), 1e-14);
            CHECK_NEAR(ovr_history_slope(half[k], T),
                       0.5 * ovr_history_slope(plain[k], T), 1e-14);
        }
        CHECK_NEAR(ovr_history_min(half[k]), 0.5 * ovr_history_min(plain[k]),
                   1e-15);
        assert_true(ovr_history_varies(half[k]) ==
                    ovr_history_varies(plain[k]));
        ovr_history_free(plain[k]);
        ovr_history_free(half[k]);
    }
}
