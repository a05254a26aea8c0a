/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Levelling, filters, gaps, outliers, resampling, statistics: against what
 * they are by definition. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "overroll/overroll.h"

enum { MOST = 4001 };
static double x[MOST], z[MOST];
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
    assert_int_equal(ovr_profile_look(p)->n, n);
    memcpy(z, ovr_profile_look(p)->z, n * sizeof *z);
    ovr_profile_free(p);
}

static ovr_conditioning nothing(void)
{
    ovr_conditioning how = ovr_conditioning_default();
    how.level = OVR_LEVEL_NONE;
    return how;
}

/* ---------------------------------------------------------------- levelling */

static void polynomials_are_taken_off(void **state)
{
    uint64_t seed = 1;
    (void)state;
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
static void levelling_is_least_squares(void **state)
{
    uint64_t seed = 2;
    ovr_conditioning how = nothing();
    double sum = 0, slope = 0;
    (void)state;
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

static void ends_make_the_datum(void **state)
{
    ovr_conditioning how = nothing();
    (void)state;
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

/* ------------------------------------------------------------------ filters */

/* ISO 16610-21: transmission of the mean line 2^(-(cut-off/wavelength)^2). */
static void gaussian_transmits_as_the_standard_says(void **state)
{
    static const double wavelengths[] = {0.5, 1, 2, 4};
    uint64_t seed = 3;
    (void)state;
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
static void gaussian_keeps_lines_to_the_ends(void **state)
{
    uint64_t seed = 4;
    (void)state;
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

static void gaps_are_bridged_and_limited(void **state)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    (void)state;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = i >= 40 && i < 44 ? NAN : 5 * x[i];
    p = make(101);
    assert_int_equal(ovr_profile_look(p)->missing, 4);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    assert_int_equal(ovr_profile_look(p)->filled, 4);
    assert_non_null(strstr(ovr_profile_look(p)->notes, "4 points filled"));
    for (size_t i = 0; i < 101; i++)
        CHECK_NEAR(ovr_profile_look(p)->z[i], 5 * x[i], 1e-14);
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

static void missing_ends_are_cut(void **state)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    (void)state;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = i < 3 || i > 95 ? NAN : 1;
    p = make(101);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    assert_int_equal(ovr_profile_look(p)->n, 93);
    ovr_profile_free(p);
}

static void outliers_are_found_and_replaced(void **state)
{
    uint64_t seed = 5;
    ovr_conditioning how = nothing();
    (void)state;
    how.outliers = 8;
    lay_out(1001, 1, NULL);
    for (size_t i = 0; i < 1001; i++)
        z[i] = sin(6 * x[i]) + test_random(&seed, -0.01, 0.01);
    z[100] += 1, z[500] -= 2, z[501] -= 2;
    condition(1001, &how);
    for (size_t i = 0; i < 1001; i++)
        CHECK_NEAR(z[i], sin(6 * x[i]), 0.03);
}

static void window_scale_and_direction(void **state)
{
    ovr_conditioning how = nothing();
    ovr_error err;
    ovr_profile *p;
    const ovr_profile_view *v;
    (void)state;
    lay_out(101, 1, NULL);
    for (size_t i = 0; i < 101; i++)
        z[i] = x[i] * x[i];
    how.from = 0.195, how.to = 0.805;
    how.scale = 3, how.invert = true, how.stretch = 2, how.reverse = true;
    how.offset = 1;
    p = make(101);
    CHECK_OK(ovr_profile_condition(p, &how, &err), &err);
    v = ovr_profile_look(p);
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

static void wrong_settings_are_named(void **state)
{
    static const char *const names[] = {"lambda_c", "lambda_s", "outliers",
                                        "max_gap",  "stretch",  "scale",
                                        "degree",   "offset",   "lambda_c"};
    (void)state;
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

static void statistics_of_a_cosine(void **state)
{
    ovr_profile *p;
    ovr_profile_numbers r;
    ovr_error err;
    (void)state;
    lay_out(4001, 10, NULL);
    for (size_t i = 0; i < 4001; i++)
        z[i] = 3 + 2 * cos(2 * PI * x[i]);
    p = make(4001);
    CHECK_OK(ovr_profile_measure(p, &r, &err), &err);
    CHECK_CLOSE(r.mean, 3, 1e-12);
    CHECK_CLOSE(r.Ra, 4 / PI, 1e-4);
    CHECK_CLOSE(r.Rq, sqrt(2), 1e-12);
    CHECK_CLOSE(r.Rz, 4, 1e-12);
    CHECK_CLOSE(r.Rt, 4, 1e-12);
    CHECK_NEAR(r.Rsk, 0, 1e-12);
    CHECK_CLOSE(r.Rku, 1.5, 1e-12);
    CHECK_CLOSE(r.Rdq, 2 * PI * sqrt(2), 1e-4);
    CHECK_CLOSE(r.spacing, 0.0025, 1e-12);
    ovr_profile_free(p);
}

static void waves_are_found(void **state)
{
    ovr_profile *p;
    ovr_profile_wave wave[3];
    size_t found;
    ovr_error err;
    (void)state;
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

static void master_curve(void **state)
{
    (void)state;
    /* r = 0.5 20^(3/4) 10^(-1/2) = 1.4953 */
    CHECK_CLOSE(ovr_wave_reduction(20, 10, 0.5), 0.75684, 1e-5);
    CHECK_NEAR(ovr_wave_reduction(20, 0, 0.5), 0, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_taken_off),
        cmocka_unit_test(levelling_is_least_squares),
        cmocka_unit_test(ends_make_the_datum),
        cmocka_unit_test(gaussian_transmits_as_the_standard_says),
        cmocka_unit_test(gaussian_keeps_lines_to_the_ends),
        cmocka_unit_test(gaps_are_bridged_and_limited),
        cmocka_unit_test(missing_ends_are_cut),
        cmocka_unit_test(outliers_are_found_and_replaced),
        cmocka_unit_test(window_scale_and_direction),
        cmocka_unit_test(wrong_settings_are_named),
        cmocka_unit_test(statistics_of_a_cosine),
        cmocka_unit_test(waves_are_found),
        cmocka_unit_test(master_curve),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
