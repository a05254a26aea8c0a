/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Levelling, filters, gaps, outliers, resampling and statistics of profiles
 * compared with their definitions. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/overroll.h"
#include "surface/profile.h"

enum { MAX = 4001 };
static double x[MAX], z[MAX];
static const double PI = 3.14159265358979323846;

static void lay_out(size_t n, double length, uint64_t *seed)
{
    for (size_t i = 0; i < n; i++) {
        double jitter = seed ? test_random(seed, -0.3, 0.3) : 0;
        if (i == 0 || i == n - 1)
            jitter = 0;
        x[i] = length * ((double)i + jitter) / (double)(n - 1);
    }
}

static ovr_profile *make(size_t n)
{
    ovr_error err;
    ovr_profile *p = ovr_profile_create(n, x, z, true, NULL, &err);
    if (!p)
        fail_msg("%s", err.message);
    return p;
}

/* Conditions (x, z) and puts the result back into z. */
static void condition(size_t n, const ovr_conditioning *how)
{
    ovr_profile *p = make(n);
    ovr_error err;
    CHECK_OK(ovr_profile_condition(p, how, &err), &err);
    assert_int_equal(ovr_profile_get_view(p)->n, n);
    memcpy(z, ovr_profile_get_view(p)->z, n * sizeof *z);
    ovr_profile_free(p);
}

static ovr_conditioning nothing(void)
{
    ovr_conditioning how = ovr_conditioning_default();
    how.level = OVR_LEVEL_NONE;
    return how;
}

/* ---------------------------------------------------------------- levelling */

TEST(polynomials_are_removed)
{
    uint64_t seed = 1;
    for (int degree = 0; degree <= 8; degree++) {
        ovr_conditioning how = nothing();
        double c[9];
        lay_out(301, 7, &seed);
        how.level = degree == 0   ? OVR_LEVEL_MEAN
                    : degree == 1 ? OVR_LEVEL_LINE
                                  : OVR_LEVEL_POLYNOMIAL;
        how.degree = degree;
        for (int k = 0; k <= degree; k++)
            c[k] = test_random(&seed, -3, 3);
        for (size_t i = 0; i < 301; i++) {
            double t = x[i] / 3.5 - 1, power = 1;
            z[i] = 0;
            for (int k = 0; k <= degree; k++, power *= t)
                z[i] += c[k] * power;
        }
        condition(301, &how);
        for (size_t i = 0; i < 301; i++)
            CHECK_NEAR(z[i], 0, 1e-12);
    }
}

/* What is left is orthogonal to what was taken off. */
TEST(levelling_is_least_squares)
{
    uint64_t seed = 2;
    ovr_conditioning how = nothing();
    double sum = 0, slope = 0;
    how.level = OVR_LEVEL_LINE;
    lay_out(501, 1, NULL);
    for (size_t i = 0; i < 501; i++)
        z[i] = test_random(&seed, -1, 1);
    condition(501, &how);
    for (size_t i = 0; i < 501; i++) {
        double share = i == 0 || i == 500 ? 0.5 : 1;
        sum += share * z[i], slope += share * z[i] * x[i];
    }
    CHECK_NEAR(sum, 0, 1e-11);
    CHECK_NEAR(slope, 0, 1e-11);
}

TEST(ends_make_the_datum)
{
    ovr_conditioning how = nothing();
    how.level = OVR_LEVEL_ENDS;
    lay_out(1001, 10, NULL);
    for (size_t i = 0; i < 1001; i++) {
        double s = x[i] - 5;
        z[i] = 2 - 0.3 * x[i] - exp(-s * s);
    }
    condition(1001, &how);
    CHECK_NEAR(z[500], -1, 1e-6);
    CHECK_NEAR(z[0], 0, 1e-6);
}

/* An arc of the radius, its highest point at `top`, tilted by `tilt` rad, as
 * points on the circle are: no series in 1/radius. */
static void lay_arc(size_t n, double length, double radius, double top,
                    double tilt)
{
    for (size_t i = 0; i < n; i++) {
        x[i] = length * (double)i / (double)(n - 1);
        z[i] = sqrt(radius * radius - pow(x[i] - top + radius * sin(tilt), 2));
    }
}

TEST(circles_are_removed)
{
    /* length, radius, top, tilt: shallow, deep, tilted */
    static const double arcs[][4] = {
        {1, 40, 0.5, 0}, {10, 5.5, 5, 0}, {4, 7, 2, 0.4}, {2, 2000, -1, 0.02}};
    for (int k = 0; k < 8; k++) {
        const double *a = arcs[k % 4];
        double sign = k < 4 ? 1 : -1;
        ovr_conditioning how = nothing();
        ovr_profile *p;
        ovr_error err;
        char named[60];
        how.level = OVR_LEVEL_CIRCLE;
        lay_arc(801, a[0], a[1], a[2], a[3]);
        for (size_t i = 0; i < 801; i++)
            x[i] *= 1e-3, z[i] *= sign * 1e-3;
        p = ovr_profile_create(801, x, z, false, NULL, &err);
        assert_non_null(p);
        CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
        for (size_t i = 0; i < 801; i++)
            CHECK_NEAR(ovr_profile_get_view(p)->z[i], 0, 1e-13);
        snprintf(named, sizeof named, "radius %g %sm, a %s",
                 a[1] / (a[1] > 99 ? 1e3 : 1), a[1] > 99 ? "" : "m",
                 sign > 0 ? "crown" : "hollow");
        if (!strstr(ovr_profile_get_view(p)->notes, named))
            fail_msg("no '%s' in: %s", named, ovr_profile_get_view(p)->notes);
        ovr_profile_free(p);
    }
}

/* What is left is orthogonal to what the three numbers of a circle change:
 * to constant, line and, for a shallow arc, parabola. */
TEST(circle_is_least_squares)
{
    uint64_t seed = 12;
    ovr_conditioning how = nothing();
    double by[3] = {0};
    how.level = OVR_LEVEL_CIRCLE;
    lay_arc(501, 1, 1e4, 0.4, 0);
    for (size_t i = 0; i < 501; i++)
        z[i] += test_random(&seed, -1, 1) * 1e-3 - 1e4;
    condition(501, &how); /* in b and b^2/R: the parabola */
    for (size_t i = 0; i < 501; i++) {
        double share = i == 0 || i == 500 ? 0.5 : 1;
        by[0] += share * z[i];
        by[1] += share * z[i] * x[i];
        by[2] += share * z[i] * x[i] * x[i];
    }
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(by[k], 0, 1e-10);
}

/* Line, arc and a crown of the fourth power, each under roughness, and a dent
 * of a third of the trace, which is no form. */
TEST(the_form_is_chosen)
{
    static const char *const names[] = {"(auto): line", "(auto): circle",
                                        "(auto): polynomial of degree 4",
                                        "(auto): line"};
    uint64_t seed = 13;
    for (int k = 0; k < 4; k++) {
        ovr_conditioning how = nothing();
        ovr_profile *p;
        ovr_error err;
        how.level = OVR_LEVEL_AUTO;
        lay_out(1001, 2, &seed);
        for (size_t i = 0; i < 1001; i++) {
            double s = x[i] - 1;
            double forms[] = {0.3 * s, -0.5 * s * s, -s * s * s * s,
                              -exp(-40 * s * s)};
            z[i] = forms[k] + test_random(&seed, -1e-3, 1e-3);
        }
        p = make(1001);
        CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
        if (!strstr(ovr_profile_get_view(p)->notes, names[k]))
            fail_msg("no '%s' in: %s", names[k],
                     ovr_profile_get_view(p)->notes);
        ovr_profile_free(p);
    }
}

/* ------------------------------------------------------------------ filters */

/* ISO 16610-21: transmission of the mean line 2^(-(cut-off/wavelength)^2). */
TEST(gaussian_transmission_by_the_standard)
{
    static const double wavelengths[] = {0.5, 1, 2, 4};
    uint64_t seed = 3;
    for (int k = 0; k < 16; k++) {
        double wl = wavelengths[k % 4], expected = pow(2, -1 / (wl * wl));
        ovr_conditioning how = nothing();
        bool high = k / 4 % 2;
        lay_out(2001, 20, k / 8 ? &seed : NULL);
        for (size_t i = 0; i < 2001; i++)
            z[i] = cos(2 * PI * x[i] / wl);
        *(high ? &how.lambda_c : &how.lambda_s) = 1;
        condition(2001, &how);
        if (high)
            expected = 1 - expected;
        for (size_t i = 150; i < 1850; i++)
            CHECK_NEAR(z[i], expected * cos(2 * PI * x[i] / wl),
                       k / 8 ? 2e-3 : 2e-6);
    }
}

/* No run-out at the ends: a straight line has no roughness. */
TEST(gaussian_keeps_lines_to_the_ends)
{
    uint64_t seed = 4;
    for (int k = 0; k < 2; k++) {
        ovr_conditioning how = nothing();
        lay_out(301, 3, k ? &seed : NULL);
        for (size_t i = 0; i < 301; i++)
            z[i] = 3 - 2 * x[i];
        how.lambda_s = 0.8;
        condition(301, &how);
        for (size_t i = 0; i < 301; i++)
            CHECK_NEAR(z[i], 3 - 2 * x[i], 1e-12);
    }
}

/* --------------------------------------------------------- gaps, outliers */

TEST(gaps_are_bridged_and_limited)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = i >= 40 && i < 44 ? NAN : 5 * x[i];
    p = make(101);
    assert_int_equal(ovr_profile_get_view(p)->missing, 4);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    assert_int_equal(ovr_profile_get_view(p)->filled, 4);
    assert_non_null(
        strstr(ovr_profile_get_view(p)->notes, "4 points interpolated"));
    for (size_t i = 0; i < 101; i++)
        CHECK_NEAR(ovr_profile_get_view(p)->z[i], 5 * x[i], 1e-14);
    ovr_profile_free(p);
    how.max_gap = 0.03;
    p = make(101);
    CHECK_STATUS(ovr_profile_condition(p, &how, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "max_gap");
    ovr_profile_free(p);
    how.max_gap = NAN, how.max_missing = 0.01;
    p = make(101);
    CHECK_STATUS(ovr_profile_condition(p, &how, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "max_missing");
    ovr_profile_free(p);
}

TEST(missing_ends_are_cut)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = i < 3 || i > 95 ? NAN : 1;
    p = make(101);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    assert_int_equal(ovr_profile_get_view(p)->n, 93);
    ovr_profile_free(p);
}

TEST(outliers_are_found_and_replaced)
{
    uint64_t seed = 5;
    ovr_conditioning how = nothing();
    how.outliers = 8;
    lay_out(1001, 1, NULL);
    for (size_t i = 0; i < 1001; i++)
        z[i] = sin(6 * x[i]) + test_random(&seed, -0.01, 0.01);
    z[100] += 1, z[500] -= 2, z[501] -= 2;
    condition(1001, &how);
    for (size_t i = 0; i < 1001; i++)
        CHECK_NEAR(z[i], sin(6 * x[i]), 0.03);
}

TEST(window_scale_and_direction)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    const ovr_profile_view *v;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = x[i] * x[i];
    how.from = 0.195, how.to = 0.805;
    how.scale = 3, how.invert = true, how.stretch = 2, how.reverse = true;
    how.offset = 1;
    p = make(101);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    v = ovr_profile_get_view(p);
    assert_int_equal(v->n, 61);
    for (size_t i = 0; i < v->n; i++) {
        double from = -v->x[i] / 2;
        CHECK_NEAR(v->z[i], 1 - 3 * from * from, 1e-14);
    }
    CHECK_NEAR(v->x[0], -1.6, 1e-14);
    ovr_profile_free(p);
    how.from = 5;
    how.to = NAN;
    p = make(101);
    CHECK_STATUS(ovr_profile_condition(p, &how, &err), OVR_BAD_INPUT, &err);
    ovr_profile_free(p);
}

TEST(wrong_settings_are_named)
{
    static const char *const names[] = {"lambda_c", "lambda_s", "outliers",
                                        "max_gap",  "stretch",  "scale",
                                        "degree",   "offset",   "lambda_c"};
    lay_out(11, 1, NULL);
    for (int k = 0; k < 9; k++) {
        ovr_conditioning how = nothing();
        ovr_error err = {0};
        ovr_profile *p = make(11);
        if (k == 0)
            how.lambda_c = -1;
        if (k == 1)
            how.lambda_s = 0;
        if (k == 2)
            how.outliers = INFINITY;
        if (k == 3)
            how.max_gap = -2;
        if (k == 4)
            how.stretch = 0;
        if (k == 5)
            how.scale = NAN;
        if (k == 6)
            how.degree = 99;
        if (k == 7)
            how.offset = INFINITY;
        if (k == 8)
            how.lambda_c = 1, how.lambda_s = 2;
        CHECK_STATUS(ovr_profile_condition(p, &how, &err), OVR_BAD_INPUT, &err);
        CHECK_ERROR(&err, OVR_BAD_INPUT, names[k]);
        ovr_profile_free(p);
    }
}

/* -------------------------------------------------------------- statistics */

TEST(statistics_of_a_cosine)
{
    ovr_profile *p;
    ovr_profile_numbers r;
    ovr_error err;
    lay_out(4001, 10, NULL);
    for (size_t i = 0; i < 4001; i++)
        z[i] = 3 + 2 * cos(2 * PI * x[i]);
    p = make(4001);
    CHECK_OK(ovr_profile_measure(p, &r, &err), &err);
    assert_int_equal(r.kind, 'P');
    assert_int_equal(r.sections, 1);
    CHECK_CLOSE(r.mean, 3, 1e-12);
    CHECK_CLOSE(r.a, 4 / PI, 1e-4);
    CHECK_CLOSE(r.q, sqrt(2), 1e-12);
    CHECK_CLOSE(r.z, 4, 1e-12);
    CHECK_CLOSE(r.t, 4, 1e-12);
    CHECK_NEAR(r.sk, 0, 1e-12);
    CHECK_CLOSE(r.ku, 1.5, 1e-12);
    CHECK_CLOSE(r.dq, 2 * PI * sqrt(2), 1e-4);
    CHECK_CLOSE(r.spacing, 0.0025, 1e-12);
    ovr_profile_free(p);
}

/* Heights in an order of their own: of ratio (i + 1/2)/n, by a curve. */
static ovr_profile_numbers of_curve(double (*curve)(double))
{
    enum { N = 4000, STRIDE = 1777 };
    ovr_profile *p;
    ovr_profile_numbers r;
    ovr_error err;
    lay_out(N, 10, NULL);
    for (size_t i = 0; i < N; i++)
        z[i] = curve(((double)((i * STRIDE + N / 2) % N) + 0.5) / N);
    p = make(N);
    CHECK_OK(ovr_profile_measure(p, &r, &err), &err);
    ovr_profile_free(p);
    return r;
}

static double even(double ratio)
{
    return 3 - 2 * ratio;
}

static double plateau(double ratio)
{
    return ratio < 0.9 ? 1 - ratio / 0.9 : -100 * (ratio - 0.9);
}

/* By bisection of erfc. */
static double gaussian(double ratio)
{
    double low = -6, high = 6;
    for (int k = 0; k < 60; k++) {
        double at = (low + high) / 2;
        if (erfc(at / sqrt(2)) / 2 > ratio)
            low = at;
        else
            high = at;
    }
    return low;
}

/* Even heights are all core; a plateau with valleys has a triangle below; of
 * normal heights the central line is the one of least squares from 30 to 70 %,
 * its slope, areas and ratios by quadrature of the normal distribution.  The
 * two outer points stand for half a length: 1/N of a ratio, which is 5e-4 here.
 */
TEST(core_lies_between_peaks_and_valleys)
{
    ovr_profile_numbers r = of_curve(even);
    CHECK_CLOSE(r.k, 2, 5e-4);
    CHECK_NEAR(r.pk, 0, 1e-3);
    CHECK_NEAR(r.vk, 0, 1e-3);
    r = of_curve(plateau);
    CHECK_CLOSE(r.k, 1 / 0.9, 5e-4);
    CHECK_NEAR(r.pk, 0, 1e-3);
    CHECK_CLOSE(r.vk, 10 - 1 / 9., 2e-3);
    CHECK_NEAR(r.mr2, 0.9 + 1 / 900., 5e-4);
    r = of_curve(gaussian);
    CHECK_CLOSE(r.k, 2.57396, 5e-4);
    CHECK_CLOSE(r.pk, 0.94503, 1e-3);
    CHECK_CLOSE(r.vk, r.pk, 1e-3);
    CHECK_NEAR(r.mr1, 0.09905, 5e-4);
    CHECK_NEAR(r.mr2, 1 - r.mr1, 5e-4);
}

/* The numbers of a trace of n points, spacing 1, after lambda_c. */
static ovr_profile_numbers filtered(size_t n, double lambda_c)
{
    ovr_conditioning how = nothing();
    ovr_profile_numbers r;
    ovr_error err;
    ovr_profile *p = make(n);
    how.lambda_c = lambda_c;
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    CHECK_OK(ovr_profile_measure(p, &r, &err), &err);
    memcpy(z, ovr_profile_get_view(p)->z, n * sizeof *z);
    ovr_profile_free(p);
    return r;
}

/* ISO 4287, 4.1.3: Rz is the mean of five sampling lengths' peak to valley.
 * Spikes narrow against lambda_c, one a section, of other heights each: the
 * sections are read off the filtered heights here by index. */
TEST(Rz_is_the_mean_of_five_sampling_lengths)
{
    static const double tall[] = {1, 7, 3, 2, 5};
    for (size_t extra = 0; extra <= 300; extra += 300) { /* beside the five */
        size_t n = 5 * 400 + extra;
        double sum = 0, high = 0, low = 0;
        ovr_profile_numbers r;
        for (size_t i = 0; i < n; i++)
            x[i] = (double)i, z[i] = 0;
        for (size_t k = 0; k < 5; k++)
            z[extra / 2 + 400 * k + 150] = tall[k];
        z[0] += extra ? 50 : 0; /* outside: counts for nothing */
        r = filtered(n, 400);
        for (size_t k = 0; k < 5; k++) {
            double top = -INFINITY, bottom = INFINITY;
            for (size_t i = 0; i < 400; i++) {
                top = fmax(top, z[extra / 2 + 400 * k + i]);
                bottom = fmin(bottom, z[extra / 2 + 400 * k + i]);
            }
            sum += top - bottom;
            high = fmax(high, top);
            low = fmin(low, bottom);
        }
        assert_int_equal(r.kind, 'R');
        assert_int_equal(r.sections, 5);
        CHECK_CLOSE(r.z, sum / 5, 1e-12);
        CHECK_CLOSE(r.p + r.v, r.z, 1e-12);
        CHECK_CLOSE(r.t, high - low, 1e-12);
    }
    x[1200] = 1200;
    assert_int_equal(filtered(1201, 400).sections, 3);
    assert_int_equal(filtered(1201, 5000).sections, 1);
}

/* ISO 21920-3: five of the cut-off in the length. */
TEST(cutoffs_follow_from_the_length)
{
    static const double mm[][2] = {{40, 8},     {39, 2.5},   {4.8, 0.8},
                                   {4, 0.8},    {3.9, 0.25}, {1.25, 0.25},
                                   {0.4, 0.08}, {1000, 8}};
    for (size_t k = 0; k < sizeof mm / sizeof mm[0]; k++)
        CHECK_CLOSE(ovr_profile_cutoff(1e-3 * mm[k][0]), 1e-3 * mm[k][1],
                    1e-12);
    assert_true(isnan(ovr_profile_cutoff(0.39e-3)));
}

TEST(waves_are_found)
{
    ovr_profile *p;
    ovr_profile_wave wave[3];
    size_t found;
    ovr_error err;
    lay_out(3001, 10, NULL);
    for (size_t i = 0; i < 3001; i++)
        z[i] = 0.5 * x[i] + 2 * cos(2 * PI * x[i] / 0.731) +
               cos(2 * PI * x[i] / 0.111 + 1);
    p = make(3001);
    CHECK_OK(ovr_profile_waves(p, 2, wave, &found, &err), &err);
    assert_int_equal(found, 2);
    CHECK_CLOSE(wave[0].wavelength, 0.731, 2e-3);
    CHECK_CLOSE(wave[1].wavelength, 0.111, 2e-3);
    CHECK_CLOSE(wave[0].amplitude, 2, 0.02);
    CHECK_CLOSE(wave[1].amplitude, 1, 0.02);
    CHECK_CLOSE(wave[0].part, 0.8, 0.02);
    ovr_profile_free(p);
}
