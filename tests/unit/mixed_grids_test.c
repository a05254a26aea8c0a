/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profiles finer and coarser than the grid, shorter and longer than the domain,
 * with equal and unequal spacing: the heights on the grid are the known
 * function without the waves that the grid cannot represent. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"
#include "surface/profile.h"
#include "surface/surfaces.h"

enum { MAX = 20001, N = 897 };
static double x[MAX], z[MAX], X[N], S[N];
static const double PI = 3.14159265358979323846;
static const double D = 5.5 / (N - 1);
static const char *path;

static ovr_contact still(void)
{
    ovr_contact c = {.M = 20,
                     .L = 10,
                     .u1_ratio = 0,
                     .u2_ratio = 2,
                     .b = 2e-4,
                     .height = 4e-6};
    return c;
}

static int prepare(void **state)
{
    if (test_make_folder(state))
        return -1;
    path = strdup(test_path(*state, "profile.csv"));
    for (int i = 0; i < N; i++)
        X[i] = -4 + D * i;
    return 0;
}

static int clear(void **state)
{
    free((void *)(uintptr_t)path);
    return test_remove_folder(state);
}

static void save(size_t n, bool scaled)
{
    ovr_error err;
    ovr_profile *p = ovr_profile_create(n, x, z, scaled, NULL, &err);
    assert_non_null(p);
    CHECK_OK(ovr_profile_save(p, path, &err), &err);
    ovr_profile_free(p);
}

static ovr_profile_source source;
static ovr_conditioning conditioning;

static ovr_feature_form on_grid(void)
{
    ovr_feature_form form = ovr_feature_form_default();
    source = ovr_profile_source_default();
    conditioning = ovr_conditioning_default();
    form.name = "it", form.shape = OVR_PROFILE, source.file = path;
    form.source = &source, form.conditioning = &conditioning;
    conditioning.level = OVR_LEVEL_NONE;
    return form;
}

static ovr_surfaces *heights(const ovr_feature_form *form, double T)
{
    ovr_contact c = still();
    ovr_error err;
    ovr_surfaces *s;
    if (form->surface == 1 && T > 0)
        c.u1_ratio = 1, c.u2_ratio = 1;
    s = ovr_surfaces_create(&c, NULL, D, NULL, &err);
    assert_non_null(s);
    CHECK_OK(ovr_surfaces_add(s, form, &err), &err);
    ovr_surfaces_heights(s, T, N, X, S);
    return s;
}

/* A packet about 0 that has vanished at |s| = 2. */
static double packet(double s, double wavelength)
{
    return exp(-4 * s * s) * cos(2 * PI * s / wavelength + 0.3);
}

static double error_of(double wavelength, double spacing, bool uniform,
                       double rubbish)
{
    size_t n = (size_t)(5 / spacing) + 1;
    uint64_t seed = 7;
    double worst = 0;
    ovr_feature_form form = on_grid();
    assert_true(n <= MAX);
    for (size_t i = 0; i < n; i++) {
        double jitter = uniform ? 0 : test_random(&seed, -0.3, 0.3);
        x[i] = ((double)i + jitter) * spacing;
        z[i] = packet(x[i] - 2.5, wavelength) +
               rubbish * packet(x[i] - 2.5, 1.4 * D);
    }
    save(n, true);
    form.start = x[n - 1] - 2.5 - 0.5;
    ovr_surfaces_free(heights(&form, 0));
    for (int i = 0; i < N; i++)
        worst = fmax(worst, fabs(S[i] - packet(X[i] + 0.5, wavelength)));
    return worst;
}

TEST(fine_and_coarse_profiles_meet_the_grid)
{
    /* finer than the grid (D = 0.0061): nothing that it carries is lost */
    assert_true(error_of(0.3, 0.0003, true, 0) < 1e-6);
    assert_true(error_of(4 * D, 0.0003, true, 0) < 2e-4);
    assert_true(error_of(0.3, D / 1.1, true, 0) < 1e-6);
    /* coarser: the band-limited interpolation of its samples */
    assert_true(error_of(0.3, 0.03, true, 0) < 1e-5);
    assert_true(error_of(0.3, 0.06, true, 0) < 1e-3);
    /* at unequal distances: GSL's spline, fourth order */
    assert_true(error_of(0.3, 0.003, false, 0) < 1e-5);
    assert_true(error_of(0.3, 0.012, false, 0) < 1e-3);
}

/* A wave shorter than 2 D is removed and not aliased to a long wave. */
TEST(short_waves_do_not_alias)
{
    assert_true(error_of(0.3, 0.0004, true, 1) < 2e-4);
}

/* Physical units, moving, through the same path. */
TEST(metres_become_hertzian_units)
{
    ovr_feature_form form = on_grid();
    ovr_surfaces *s;
    for (size_t i = 0; i < 1001; i++) {
        x[i] = 2e-4 * 0.005 * (double)i;
        z[i] = 4e-6 * packet(0.005 * (double)i - 2.5, 0.5);
    }
    save(1001, false);
    form.start = -2;
    s = heights(&form, 3.7);
    for (int i = 0; i < N; i++)
        CHECK_NEAR(S[i], packet(X[i] - (-2 - 2.5 + 3.7), 0.5), 1e-6);
    CHECK_NEAR(ovr_surfaces_centre(s, 0, 3.7), -2 - 2.5 + 3.7, 1e-12);
    CHECK_CLOSE(ovr_surfaces_info(s, 0).amplitude, 0.9978, 1e-3);
    assert_non_null(strstr(ovr_surfaces_info(s, 0).assumed, "by the grid"));
    ovr_surfaces_free(s);
}

static double steepest(void)
{
    double maximum = 0;
    for (int i = 1; i < N; i++)
        maximum = fmax(maximum, fabs(S[i] - S[i - 1]) / D);
    return maximum;
}

/* A plateau enters without a step. */
TEST(ends_are_blended)
{
    ovr_feature_form form = on_grid();
    for (size_t i = 0; i < 201; i++)
        x[i] = 0.01 * (double)i, z[i] = 1;
    save(201, true);
    form.start = 0.5;
    conditioning.taper = 0.5;
    ovr_surfaces_free(heights(&form, 0));
    /* the steepest of sigma(s/0.5) is 15/8/0.5 */
    CHECK_CLOSE(steepest(), 3.75, 1e-2);
    for (int i = 0; i < N; i++)
        if (fabs(X[i] + 0.5) < 0.5)
            CHECK_NEAR(S[i], 1, 1e-9);
}

TEST(profiles_go_on_without_end)
{
    for (size_t i = 0; i < 501; i++)
        x[i] = 0.002 * (double)i, z[i] = sin(2 * PI * x[i]) + x[i];
    save(501, true);
    for (int k = 0; k < 2; k++) {
        ovr_feature_form form = on_grid();
        double period;
        form.origin = 0;
        conditioning.taper = 0.2;
        conditioning.extend = k ? OVR_EXTEND_MIRROR : OVR_EXTEND_PERIODIC;
        period = k ? 2 : 0.8;
        ovr_surfaces_free(heights(&form, 0));
        assert_true(steepest() < 12);
        for (int i = 0; i < N; i++) {
            double far = X[i] + period, there;
            ovr_contact c = still();
            ovr_surfaces *s = ovr_surfaces_create(&c, NULL, D, NULL, NULL);
            if (i % 80 == 0) {
                assert_int_equal(ovr_surfaces_add(s, &form, NULL), OVR_OK);
                ovr_surfaces_heights(s, 0, 1, &far, &there);
                CHECK_NEAR(there, S[i], 1e-9);
            }
            ovr_surfaces_free(s);
        }
    }
}

/* With a start, endless profiles begin there. */
TEST(endless_profiles_have_a_front)
{
    ovr_feature_form form = on_grid();
    for (size_t i = 0; i < 501; i++)
        x[i] = 0.002 * (double)i, z[i] = 1;
    save(501, true);
    form.start = 0;
    conditioning.extend = OVR_EXTEND_PERIODIC;
    conditioning.taper = 0.3;
    ovr_surfaces_free(heights(&form, 0));
    for (int i = 0; i < N; i++) {
        if (X[i] > 0)
            CHECK_NEAR(S[i], 0, 0);
        if (X[i] < -0.3)
            CHECK_NEAR(S[i], 1, 1e-9);
    }
}

TEST(profiles_need_scales_and_places)
{
    ovr_contact c = {.M = 20,
                     .L = 10,
                     .u1_ratio = 1,
                     .u2_ratio = 1,
                     .b = NAN,
                     .height = NAN};
    ovr_feature_form form = on_grid();
    ovr_error err;
    ovr_surfaces *s = ovr_surfaces_create(&c, NULL, D, NULL, &err);
    for (size_t i = 0; i < 501; i++)
        x[i] = 0.002 * (double)i, z[i] = 1;
    save(501, false);
    CHECK_STATUS(ovr_surfaces_add(s, &form, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "contact with dimensions");
    save(501, true);
    CHECK_STATUS(ovr_surfaces_add(s, &form, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "start");
    form.start = 0, conditioning.taper = 2;
    CHECK_STATUS(ovr_surfaces_add(s, &form, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "taper");
    ovr_surfaces_free(s);
}

static ovr_status add_once(void *data, const ovr_allocator *hook,
                           ovr_error *err)
{
    ovr_contact c = still();
    ovr_surfaces *s = ovr_surfaces_create(&c, NULL, D, hook, err);
    ovr_status status;
    if (!s)
        return err->status;
    status = ovr_surfaces_add(s, data, err);
    ovr_surfaces_free(s);
    return status;
}

TEST(every_allocation_may_fail)
{
    ovr_feature_form form = on_grid();
    ovr_roughness roughness = ovr_roughness_default();
    for (size_t i = 0; i < 2001; i++)
        x[i] = 0.002 * (double)i + (i ? 0.0003 : 0), z[i] = sin(x[i]);
    save(2001, true);
    form.start = 0;
    assert_true(test_every_allocation(add_once, &form) > 5);
    form.shape = OVR_ROUGHNESS, form.roughness = &roughness;
    roughness.Rq = 0.1, roughness.length = 4, roughness.skewness = -0.5;
    assert_true(test_every_allocation(add_once, &form) > 5);
}

TEST_GROUP(prepare, clear)
