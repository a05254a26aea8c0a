/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random roughness has the specified parameters. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "overroll/overroll.h"
#include "surface/local_roughness.h"
#include "surface/profile.h"
#include "surface/surfaces.h"

static ovr_roughness good(void)
{
    ovr_roughness form = ovr_roughness_default();
    form.Rq = 0.3, form.length = 50, form.rolloff = 5, form.shortest = 0.1;
    return form;
}

static ovr_profile *make(const ovr_roughness *form)
{
    ovr_error err;
    ovr_profile *p = ovr_profile_random(form, NULL, &err);
    if (!p)
        fail_msg("%s", err.message);
    return p;
}

TEST(numbers_are_as_asked)
{
    static const double skew[] = {NAN, 0, -1, 0.7, NAN};
    static const double kurt[] = {NAN, 3, 5, NAN, 2.5};
    for (int k = 0; k < 10; k++) {
        ovr_roughness form = good();
        ovr_profile_numbers r;
        ovr_profile *p;
        ovr_error err;
        form.seed = k;
        form.skewness = skew[k % 5], form.kurtosis = kurt[k % 5];
        form.spectrum = k / 5 ? OVR_EXPONENTIAL : OVR_SELF_AFFINE;
        form.correlation = 1;
        p = make(&form);
        CHECK_OK(ovr_profile_measure(p, &r, &err), &err);
        CHECK_CLOSE(r.q, 0.3, 1e-9);
        CHECK_NEAR(r.mean, 0, 1e-12);
        CHECK_CLOSE(r.length, 50, 1e-12);
        if (!isnan(form.skewness))
            CHECK_NEAR(r.sk, form.skewness, 1e-8);
        if (!isnan(form.kurtosis))
            CHECK_NEAR(r.ku, form.kurtosis, 1e-7);
        if (isnan(form.skewness) && isnan(form.kurtosis))
            CHECK_NEAR(r.ku, 3, 1.5);
        ovr_profile_free(p);
    }
}

/* Spectrum by direct sums, averaged over seeds and bands. */
static double band_power(int first, int last, ovr_roughness form)
{
    double sum = 0;
    for (int seed = 0; seed < 12; seed++) {
        const ovr_profile_view *v;
        ovr_profile *p;
        form.seed = seed;
        p = make(&form);
        v = ovr_profile_get_view(p);
        for (int k = first; k <= last; k++) {
            double a = 0, b = 0;
            for (size_t i = 0; i + 1 < v->n; i++) {
                double phase = 6.283185307179586 * k * v->x[i] / 50;
                a += v->z[i] * cos(phase);
                b += v->z[i] * sin(phase);
            }
            sum += a * a + b * b;
        }
        ovr_profile_free(p);
    }
    return sum / (last - first + 1);
}

TEST(spectra_fall_as_asked)
{
    ovr_roughness form = good();
    double low, high, slope;
    low = band_power(38, 42, form), high = band_power(152, 168, form);
    slope = log(high / low) / log(160.0 / 40);
    CHECK_NEAR(slope, -1 - 2 * 0.8, 0.35);
    low = band_power(1, 5, form);
    slope = log(low / band_power(6, 10, form));
    CHECK_NEAR(slope, 0, 0.5);
    form.spectrum = OVR_EXPONENTIAL, form.correlation = 1;
    low = band_power(38, 42, form), high = band_power(152, 168, form);
    CHECK_NEAR(log(high / low) / log(160.0 / 40), -2, 0.35);
}

TEST(seeds_make_surfaces)
{
    ovr_roughness form = good();
    ovr_profile *p = make(&form), *q = make(&form), *other;
    const ovr_profile_view *a = ovr_profile_get_view(p),
                           *b = ovr_profile_get_view(q);
    assert_memory_equal(a->z, b->z, a->n * sizeof(double));
    form.seed = 2;
    other = make(&form);
    assert_memory_not_equal(a->z, ovr_profile_get_view(other)->z,
                            a->n * sizeof(double));
    /* the first heights of seed 1, so that a change is noticed */
    CHECK_NEAR(a->z[0], 0.17077300627817546, 1e-12);
    CHECK_NEAR(a->z[1000], -0.053019473017887307, 1e-12);
    assert_true(a->z[0] == a->z[a->n - 1]);
    ovr_profile_free(p), ovr_profile_free(q), ovr_profile_free(other);
}

/* Root of the mean of z^2 less the square of its mean in windows of 2, of a
 * sum of two waves: A^2/2 (1 - (sin a/a)^2), a = 2 pi/l, of each, over a length
 * that holds whole periods of both; the points stand unevenly. */
TEST(long_waves_are_no_roughness)
{
    static const double l[] = {0.5, 8}, A[] = {0.3, 1};
    enum { N = 48001 };
    const double length = 240, pi = acos(-1.0);
    double *x = calloc(N, sizeof *x), *z = calloc(N, sizeof *z), target = 0;
    assert_true(x && z);
    for (size_t i = 0; i < N; i++) {
        double even = (double)i / (N - 1);
        x[i] = length * (even + 0.05 * sin(2 * pi * even) / (2 * pi));
        for (int k = 0; k < 2; k++)
            z[i] += A[k] * sin(2 * pi * x[i] / l[k]);
    }
    for (int k = 0; k < 2; k++) {
        double a = 2 * pi / l[k], s = sin(a) / a;
        target += A[k] * A[k] / 2 * (1 - s * s);
        CHECK_CLOSE(ovr_local_roughness_of_wave(A[k], l[k], 2),
                    A[k] * sqrt((1 - s * s) / 2), 1e-12);
    }
    /* the ends, where windows are missing, and steps of a hundredth of l */
    CHECK_CLOSE(ovr_local_roughness(N, x, z, 2), sqrt(target), 1e-2);
    CHECK_CLOSE(ovr_local_roughness(101, x, z, 1e3) /
                    ovr_local_roughness(101, x, z, 2e3),
                1, 1e-15);
    free(x);
    free(z);
}

/* The lambda ratio's roughness is that of the surface, whatever the grid takes
 * out of it; that on the mesh is less. */
TEST(grid_takes_nothing_from_it)
{
    const ovr_contact contact = {.u1_ratio = 1, .u2_ratio = 1};
    ovr_roughness rough = good();
    ovr_feature_form form = ovr_feature_form_default();
    double Rq[2], on_mesh[2];
    ovr_error err = {0};
    form.shape = OVR_ROUGHNESS, form.roughness = &rough, form.start = -1;
    form.name = "rough";
    for (int k = 0; k < 2; k++) {
        ovr_surfaces *s = ovr_surfaces_create(&contact, NULL, k ? 0.3 : 0.01,
                                              NULL, &err);
        assert_non_null(s);
        CHECK_OK(ovr_surfaces_add(s, &form, &err), &err);
        Rq[k] = ovr_surfaces_roughness(s);
        on_mesh[k] = ovr_surfaces_info(s, 0).Rq;
        ovr_surfaces_free(s);
    }
    assert_true(Rq[0] == Rq[1] && Rq[0] > 0.05 && Rq[0] < 0.3);
    assert_true(on_mesh[1] < 0.99 * on_mesh[0]);
}

TEST(mistakes_are_reported)
{
    static const char *const names[] = {"Rq",       "length", "hurst",
                                        "shortest", "seed",   "kurtosis"};
    for (int k = 0; k < 6; k++) {
        ovr_roughness form = good();
        ovr_error err = {0};
        if (k == 0)
            form.Rq = NAN;
        if (k == 1)
            form.length = -1;
        if (k == 2)
            form.hurst = 3;
        if (k == 3)
            form.shortest = 1e-9;
        if (k == 4)
            form.seed = -1;
        if (k == 5)
            form.skewness = 2, form.kurtosis = 2;
        assert_null(ovr_profile_random(&form, NULL, &err));
        CHECK_ERROR(&err, OVR_BAD_INPUT, names[k]);
    }
}
