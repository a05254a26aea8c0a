/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Areal surfaces: interpolation, conditioning, random roughness, and heights on
 * a strip. */
#include "surface/areal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "support/contact.h"
#include "support/test.h"
#include "surface/areal_table.h"
#include "surface/surfaces.h"

static const double TWO_PI = 6.283185307179586;

/* An empty map of nx x ny points in b and b^2/R. */
static ovr_areal *make_map(size_t nx, size_t ny, double dx, double dy)
{
    ovr_profile *p = ovr_profile_new("map", NULL, NULL);
    assert_true(p && !ovr_areal_reserve(p, nx, ny, dx, dy, NULL));
    p->map.scaled_x = p->map.scaled_z = true;
    p->map.owner = p;
    p->view.scaled_x = p->view.scaled_z = true;
    return &p->map;
}

static double product(double x, double y)
{
    return cos(TWO_PI * x / 2) * cos(TWO_PI * (y - 0.1) / 1.5);
}

static ovr_areal *product_map(void)
{
    ovr_areal *map = make_map(161, 121, 4.0 / 160, 3.0 / 120);
    for (size_t j = 0; j < map->ny; j++)
        for (size_t i = 0; i < map->nx; i++)
            map->z[j * map->nx + i] = product((double)i * map->dx,
                                              (double)j * map->dy);
    return map;
}

/* Waves of 40 mesh sizes and more, between the points of the map. */
TEST(tables_interpolate_waves)
{
    static const int extend[] = {OVR_EXTEND_PERIODIC, OVR_EXTEND_NONE};
    for (int k = 0; k < 2; k++) {
        ovr_areal *map = product_map();
        ovr_arena arena = ovr_arena_make(NULL);
        ovr_areal_table t;
        const ovr_areal_fit fit = {.mesh = {0.03, 0.03},
                                   .taper = {0, 0},
                                   .extend = {extend[k], extend[k]},
                                   .both = true,
                                   .closed = k == 0};
        assert_true(!ovr_areal_tabulate(map, &fit, &t, &arena, NULL));
        CHECK_NEAR(t.Sq, 0.5, 0.01);
        for (int i = 0; i < 200; i++) {
            double x = 0.5 + 0.0151 * i, y = 0.3 + 0.0117 * i, S = 0;
            ovr_areal_add(&t, 1, x, 0, 1, &y, &S);
            CHECK_NEAR(S, product(x, y), 1e-4);
            if (k == 0) {
                double again = 0, far = y - 6;
                ovr_areal_add(&t, 1, x + 8, 0, 1, &far, &again);
                CHECK_NEAR(again, S, 1e-12);
            }
        }
        ovr_arena_release(&arena);
        ovr_areal_free(map);
    }
}

/* Waves shorter than two mesh sizes vanish, whatever the map has. */
TEST(tables_drop_waves_below_the_grid)
{
    ovr_areal *map = make_map(401, 401, 0.01, 0.01);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_areal_table t;
    const ovr_areal_fit fit = {
        .mesh = {0.06, 0.06},
        .extend = {OVR_EXTEND_PERIODIC, OVR_EXTEND_PERIODIC},
        .closed = true};
    for (size_t j = 0; j < map->ny; j++)
        for (size_t i = 0; i < map->nx; i++)
            map->z[j * map->nx + i] = cos(TWO_PI * (double)j / 10);
    assert_true(!ovr_areal_tabulate(map, &fit, &t, &arena, NULL));
    assert_true(t.largest < 1e-3);
    CHECK_NEAR(t.lost, 1, 1e-6);
    ovr_arena_release(&arena);
    ovr_areal_free(map);
}

/* Transmission one half at the cut-off, along x, y and both; constant and plane
 * pass. */
TEST(gaussian_filter_halves_at_its_nesting_index)
{
    static const double waves[][2] = {{1, 0}, {0, 1}, {0.6, 0.8}, {0, 0}};
    for (int k = 0; k < 4; k++) {
        const double lambda = 0.5;
        ovr_areal *map = make_map(241, 241, 0.0125, 0.0125);
        ovr_conditioning how = ovr_conditioning_default();
        double largest = 0;
        how.level = OVR_LEVEL_NONE;
        how.lambda_s = lambda;
        for (size_t j = 0; j < map->ny; j++)
            for (size_t i = 0; i < map->nx; i++) {
                double x = (double)i * map->dx, y = (double)j * map->dy;
                map->z[j * map->nx + i] =
                    3 + 0.5 * x - y +
                    cos(TWO_PI * (waves[k][0] * x + waves[k][1] * y) / lambda);
            }
        assert_true(!ovr_areal_condition(map, &how, NULL));
        for (size_t j = 60; j < 180; j++)
            for (size_t i = 60; i < 180; i++) {
                double x = (double)i * map->dx, y = (double)j * map->dy;
                double rest = map->z[j * map->nx + i] - (3 + 0.5 * x - y);
                largest = fmax(largest, fabs(rest));
            }
        CHECK_NEAR(largest, k < 3 ? 0.5 : 1, 2e-3);
        if (k == 3) /* the plane, at a corner too */
            CHECK_NEAR(map->z[0], 4, 1e-10);
        ovr_areal_free(map);
    }
}

TEST(form_is_removed_and_gaps_are_filled)
{
    ovr_areal *map = make_map(60, 40, 0.1, 0.1);
    ovr_conditioning how = ovr_conditioning_default();
    double largest = 0;
    how.level = OVR_LEVEL_POLYNOMIAL;
    how.degree = 3;
    for (size_t j = 0; j < map->ny; j++)
        for (size_t i = 0; i < map->nx; i++) {
            double x = (double)i / 10 - 2, y = (double)j / 10 - 1;
            map->z[j * map->nx + i] = 5 + x - 2 * y + x * x - x * y +
                                      x * x * y - y * y * y;
        }
    map->z[20 * map->nx + 30] = map->z[20 * map->nx + 31] = NAN;
    map->missing = 2;
    assert_true(!ovr_areal_condition(map, &how, NULL));
    for (size_t k = 0; k < map->nx * map->ny; k++)
        if (k != 20 * map->nx + 30 && k != 20 * map->nx + 31)
            largest = fmax(largest, fabs(map->z[k]));
    assert_true(largest < 1e-3);
    assert_true(fabs(map->z[20 * map->nx + 30]) < 0.05);
    assert_true(map->missing == 0);
    ovr_areal_free(map);
}

/* Spikes on a rough wavy map, at a corner too; the rest stays. */
TEST(outliers_of_a_map_are_found_and_replaced)
{
    static const size_t spike[] = {0, 1234, 1235, 2000};
    ovr_areal *map = make_map(60, 40, 0.1, 0.1);
    ovr_conditioning how = ovr_conditioning_default();
    uint64_t seed = 8;
    double kept[2400];
    how.level = OVR_LEVEL_NONE;
    how.outliers = 10;
    for (size_t k = 0; k < 2400; k++)
        map->z[k] = kept[k] = cos(0.05 * (double)(k % 60)) +
                              sin(0.07 * (double)(k / 60)) +
                              test_random(&seed, -0.05, 0.05);
    for (size_t k = 0; k < 4; k++)
        map->z[spike[k]] += k % 2 ? -2 : 3;
    assert_true(!ovr_areal_condition(map, &how, NULL));
    assert_non_null(strstr(map->notes, "4 outliers beyond 10 robust"));
    for (size_t k = 0; k < 2400; k++) {
        bool was = k == spike[0] || k == spike[1] || k == spike[2] ||
                   k == spike[3];
        CHECK_NEAR(map->z[k], kept[k], was ? 0.3 : 0);
    }
    how.outliers = -1;
    assert_true(ovr_areal_condition(map, &how, NULL) == OVR_BAD_INPUT);
    ovr_areal_free(map);
}

/* Distance along x or y where the autocorrelation falls below exp(-1). */
static double decay(const ovr_areal *map, bool along)
{
    size_t nx = map->nx - 1, ny = map->ny - 1, n = along ? nx : ny;
    double zero = 0;
    for (size_t shift = 0; shift < n; shift++) {
        double sum = 0;
        for (size_t j = 0; j < ny; j++)
            for (size_t i = 0; i < nx; i++) {
                size_t u = along ? (i + shift) % nx : i;
                size_t v = along ? j : (j + shift) % ny;
                sum += map->z[j * map->nx + i] * map->z[v * map->nx + u];
            }
        zero = shift ? zero : sum;
        if (sum < 0.3679 * zero)
            return (double)shift * (along ? map->dx : map->dy);
    }
    return INFINITY;
}

TEST(roughness_has_its_height_and_peklenik_number)
{
    static const double numbers[] = {0.25, 1, 4};
    for (int k = 0; k < 3; k++) {
        ovr_roughness form = ovr_roughness_default();
        form.Rq = 0.05;
        form.length = 8;
        form.spectrum = OVR_EXPONENTIAL;
        form.correlation = 0.3;
        form.shortest = 0.1;
        form.peklenik = numbers[k];
        ovr_areal *map = ovr_areal_random(&form, 8, 0, NULL, NULL);
        ovr_areal *turned = ovr_areal_random(&form, 8, TWO_PI / 4, NULL, NULL);
        assert_true(map && turned);
        double squares = 0, mean = 0, n = 0;
        for (size_t j = 0; j + 1 < map->ny; j++)
            for (size_t i = 0; i + 1 < map->nx; i++, n++) {
                double z = map->z[j * map->nx + i];
                squares += z * z;
                mean += z;
            }
        CHECK_NEAR(sqrt(squares / n), 0.05, 1e-9);
        CHECK_NEAR(mean / n, 0, 1e-12);
        double ratio = decay(map, true) / decay(map, false);
        CHECK_NEAR(log(ratio / numbers[k]), 0, 0.3);
        ratio = decay(turned, false) / decay(turned, true);
        CHECK_NEAR(log(ratio / numbers[k]), 0, 0.3);
        ovr_areal_free(map);
        ovr_areal_free(turned);
    }
}

/* The parameters need the pairs of heights at each shift, which are counted if
 * a height is missing. */
TEST(one_missing_height_hardly_changes_the_lay)
{
    static const double peklenik[] = {0.3, 1, 3};
    for (int k = 0; k < 3; k++) {
        ovr_roughness form = ovr_roughness_default();
        form.Rq = 0.05;
        form.length = 10;
        form.shortest = 0.1;
        form.peklenik = peklenik[k];
        ovr_areal_numbers whole, holed;
        ovr_areal *map = ovr_areal_random(&form, 6, 0.5, NULL, NULL);
        assert_non_null(map);
        assert_int_equal(ovr_areal_measure(map, &whole, NULL), OVR_OK);
        map->z[map->nx * (map->ny / 2) + 1] = NAN;
        map->missing = 1;
        assert_int_equal(ovr_areal_measure(map, &holed, NULL), OVR_OK);
        CHECK_NEAR(holed.Str, whole.Str, 2e-3);
        assert_int_equal(isnan(holed.lay), isnan(whole.lay));
        if (!isnan(whole.lay))
            CHECK_NEAR(holed.lay, whole.lay, 0.2);
        ovr_areal_free(map);
    }
}

TEST(roughness_has_its_moments)
{
    ovr_roughness form = ovr_roughness_default();
    form.Rq = 1;
    form.length = 4;
    form.shortest = 0.25;
    form.skewness = -0.8;
    form.kurtosis = 4.5;
    ovr_areal *map = ovr_areal_random(&form, 2, 0, NULL, NULL);
    assert_true(map != NULL);
    double third = 0, fourth = 0, n = 0;
    for (size_t j = 0; j + 1 < map->ny; j++)
        for (size_t i = 0; i + 1 < map->nx; i++, n++) {
            double z = map->z[j * map->nx + i];
            third += z * z * z;
            fourth += z * z * z * z;
        }
    CHECK_NEAR(third / n, -0.8, 1e-6);
    CHECK_NEAR(fourth / n, 4.5, 1e-6);
    ovr_areal_free(map);
}

/* -------------------------------------------------------------- on a strip */

/* Writes the product of waves as text; 121 x 81 points of 0.05 b, whose sides
 * agree where the width is blended. */
static const char *write_map(void)
{
    static const char path[] = "areal_test.npy";
    FILE *file = fopen(path, "wb");
    char header[128];
    assert_true(file != NULL);
    memset(header, ' ', sizeof header);
    memcpy(header, "\x93NUMPY\x01\x00\x76\x00", 10);
    int used = snprintf(header + 10, 100,
                        "{'descr': '<f8', 'fortran_order': False, 'shape': "
                        "(81, 121), }");
    header[10 + used] = ' ';
    header[127] = '\n';
    fwrite(header, 1, sizeof header, file);
    for (int j = 0; j < 81; j++)
        for (int i = 0; i < 121; i++) {
            double z = 0.1 * cos(TWO_PI * i / 40) * cos(TWO_PI * j / 40);
            fwrite(&z, sizeof z, 1, file);
        }
    fclose(file);
    return path;
}

static ovr_surfaces *strip_with_map(double width, ovr_extension across,
                                    ovr_error *err)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_conditioning how = ovr_conditioning_default();
    ovr_feature_form form = ovr_feature_form_default();
    ovr_contact contact = test_contact_make(20, 10).contact;
    ovr_surfaces *s = ovr_surfaces_create(&contact, NULL, 0.05, NULL, NULL);
    assert_true(s != NULL);
    source.file = write_map();
    source.unit_z = "b^2/R";
    source.spacing = 0.05;
    source.spacing_scaled = true;
    how.level = OVR_LEVEL_NONE;
    how.taper = how.taper_across = 0.4;
    how.extend_across = across;
    form.name = "map";
    form.shape = OVR_AREAL;
    form.source = &source;
    form.conditioning = &how;
    form.centre = 0;
    ovr_surfaces_strip(s, width, 64);
    if (ovr_surfaces_add(s, &form, err)) {
        ovr_surfaces_free(s);
        s = NULL;
    }
    remove("areal_test.npy");
    return s;
}

static double height_on(ovr_surfaces *s, double T, double x, double y)
{
    double S;
    ovr_surfaces_across(s, 0, T, 1, &x, 1, &y, 1, &S);
    return S;
}

/* The map's period across is its width less the taper, 3.6. */
TEST(maps_close_on_the_strip)
{
    ovr_error err = {0};
    assert_true(!strip_with_map(5, OVR_EXTEND_PERIODIC, &err));
    assert_true(strstr(err.message, "set strip.width to 3.6 or 7.2") != NULL);
    assert_true(!strcmp(err.about, "extend_across"));
    assert_true(!strip_with_map(3, OVR_EXTEND_NONE, &err));
    assert_true(strstr(err.message, "strip.width to at least 4") != NULL);
    ovr_surfaces *s = strip_with_map(7.2, OVR_EXTEND_PERIODIC, &err);
    assert_true(s != NULL);
    for (int k = 0; k < 40; k++) {
        double x = -1.9 + 0.1 * k, y = 0.13 * k;
        double S = height_on(s, 0, x, y);
        CHECK_NEAR(height_on(s, 0, x, y + 7.2), S, 1e-12);
        CHECK_NEAR(height_on(s, 0, x, y + 3.6), S, 1e-12);
        CHECK_NEAR(height_on(s, 0.7, x + 0.7, y), S, 1e-12); /* rides */
    }
    /* The centre of the map is at x = 3 b and y = 1.8 b of the period.
     */
    CHECK_NEAR(height_on(s, 0, 0.2, 0.3),
               0.1 * cos(TWO_PI * 3.2 / 2) * cos(TWO_PI * 2.1 / 2), 2e-4);
    ovr_surfaces_free(s);
}

TEST(maps_without_repeat_end_in_the_smooth_surface)
{
    ovr_error err = {0};
    ovr_surfaces *s = strip_with_map(6, OVR_EXTEND_NONE, &err);
    assert_true(s != NULL);
    CHECK_NEAR(height_on(s, 0, 0.2, 2.5), 0, 1e-12);
    CHECK_NEAR(height_on(s, 0, 0.2, -2.0), 0, 1e-4);
    CHECK_NEAR(height_on(s, 0, 3.1, 0), 0, 1e-12);
    CHECK_NEAR(height_on(s, 0, 0.2, 0.3),
               0.1 * cos(TWO_PI * 3.2 / 2) * cos(TWO_PI * 2.3 / 2), 2e-4);
    ovr_surfaces_free(s);
}
