/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Features against their formulas, motion, growth, repetition, errors. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/contact.h"
#include "overroll/overroll.h"
#include "support/test.h"
#include "surface/surfaces.h"

enum { N = 897 };
static double X[N], S[N];
static const double PI = 3.14159265358979323846;

static ovr_contact moes(double u1, double u2)
{
    ovr_contact c = {.M = 20,
                     .L = 10,
                     .u1_ratio = u1,
                     .u2_ratio = u2,
                     .b = NAN,
                     .height = NAN};
    return c;
}

static int grid(void **state)
{
    (void)state;
    for (int i = 0; i < N; i++)
        X[i] = -4 + 5.5 * i / (N - 1);
    return 0;
}

static ovr_surfaces *with(const ovr_contact *c, const ovr_history *speed,
                          const ovr_feature_form *form)
{
    ovr_error err;
    ovr_surfaces *s = ovr_surfaces_create(c, speed, X[1] - X[0], NULL, &err);
    assert_non_null(s);
    assert_int_equal(ovr_surfaces_add(s, form, &err), OVR_OK);
    return s;
}

static ovr_feature_form local(ovr_shape shape, double height, double width)
{
    ovr_feature_form form = ovr_feature_form_default();
    form.name = "it";
    form.shape = shape;
    *(shape == OVR_DENT ? &form.depth : &form.height) = height;
    form.width = width;
    form.start = -4.6;
    return form;
}

static double reference(double A, double w, double Xd, double x)
{
    double xi = (x - Xd) / w;
    return A * pow(10, -10 * xi * xi) * cos(2 * PI * xi);
}

TEST(dent_and_bump_follow_their_formula)
{
    ovr_contact c = moes(1.3, 0.7);
    for (int bump = 0; bump < 2; bump++) {
        ovr_feature_form form = local(bump ? OVR_BUMP : OVR_DENT, 0.1, 0.5);
        ovr_surfaces *s = with(&c, NULL, &form);
        for (double T = 0; T < 6; T += 0.37) {
            ovr_surfaces_heights(s, T, N, X, S);
            for (int i = 0; i < N; i++)
                assert_true(fabs(S[i] - reference(bump ? 0.1 : -0.1, 0.5,
                                                  -4.6 + 1.3 * T, X[i])) <
                            1e-15);
        }
        ovr_surfaces_free(s);
    }
}

TEST(wave_grows_and_is_convected)
{
    ovr_contact c = moes(1, 0.5);
    ovr_feature_form form = ovr_feature_form_default();
    ovr_surfaces *s;
    form.shape = OVR_WAVE, form.amplitude = 0.05, form.wavelength = 0.4;
    form.grow = 1, form.surface = 2, form.origin = 0.1;
    s = with(&c, NULL, &form);
    for (double T = 0; T < 3; T += 0.23) {
        double v = fmin(T, 1);
        double g = v * v * v * (10 - 15 * v + 6 * v * v);
        ovr_surfaces_heights(s, T, N, X, S);
        for (int i = 0; i < N; i += 7)
            assert_true(fabs(S[i] - 0.05 * g *
                                        cos(2 * PI * (X[i] - 0.1 - 0.5 * T) /
                                            0.4)) < 1e-14);
    }
    assert_null(ovr_surfaces_inside(s, -4, 1.5));
    ovr_surfaces_free(s);
}

/* Overlapping features add up, in any order, on both surfaces. */
TEST(features_add_up)
{
    ovr_contact c = moes(1, -0.2);
    ovr_feature_form a = local(OVR_DENT, 0.1, 0.5), b = a, w = a;
    ovr_surfaces *both, *one, *other;
    ovr_error err;
    static double S1[N], S2[N];
    w = ovr_feature_form_default();
    w.shape = OVR_WAVE, w.amplitude = 0.01, w.wavelength = 0.3, w.surface = 2;
    b.start = -4.2;
    both = with(&c, NULL, &a), one = with(&c, NULL, &w);
    other = with(&c, NULL, &a);
    assert_int_equal(ovr_surfaces_add(both, &w, &err), OVR_OK);
    assert_int_equal(ovr_surfaces_add(both, &b, &err), OVR_OK);
    assert_int_equal(ovr_surfaces_add(other, &b, &err), OVR_OK);
    ovr_surfaces_heights(both, 3, N, X, S);
    ovr_surfaces_heights(one, 3, N, X, S1);
    ovr_surfaces_heights(other, 3, N, X, S2);
    for (int i = 0; i < N; i++)
        assert_true(fabs(S[i] - S1[i] - S2[i]) < 1e-15);
    assert_int_equal(ovr_surfaces_count(both), 3);
    ovr_surfaces_free(both), ovr_surfaces_free(one), ovr_surfaces_free(other);
}

TEST(copies_follow)
{
    ovr_contact c = moes(1, 1);
    ovr_feature_form form = local(OVR_DENT, 0.1, 0.2);
    ovr_surfaces *s;
    form.repeat = 0.7;
    for (int copies = 0; copies < 4; copies += 3) {
        form.copies = copies;
        s = with(&c, NULL, &form);
        ovr_surfaces_heights(s, 5.5, N, X, S);
        for (int i = 0; i < N; i++) {
            double sum = 0;
            for (int k = 0; k < (copies ? copies : 40); k++)
                sum += reference(-0.1, 0.2, 0.9 - 0.7 * k, X[i]);
            assert_true(fabs(S[i] - sum) < 1e-14);
        }
        assert_true(fabs(ovr_surfaces_arrival(s, 0, 0, 5, 99) - 5.3) < 1e-9);
        ovr_surfaces_free(s);
    }
}

/* Height at s from the centre, of a feature at X = -1. */
static double at(const ovr_feature_form *form, double s)
{
    ovr_contact c = moes(0, 2);
    double x = -1 + s, z;
    ovr_surfaces *surfaces = with(&c, NULL, form);
    ovr_surfaces_heights(surfaces, 0, 1, &x, &z);
    ovr_surfaces_free(surfaces);
    return z;
}

TEST(other_shapes_have_their_heights)
{
    ovr_feature_form f = ovr_feature_form_default();
    f.name = "it", f.centre = -1;
    f.shape = OVR_STEP, f.height = 0.2, f.flank = 0.4;
    assert_true(fabs(at(&f, 0) - 0.1) < 1e-15);
    assert_true(fabs(at(&f, 0.2)) < 1e-15 && fabs(at(&f, -0.2) - 0.2) < 1e-15);
    assert_true(fabs(at(&f, -1e6) - 0.2) < 1e-15);
    f.length = 2;
    assert_true(fabs(at(&f, -2.2)) < 1e-15 && fabs(at(&f, -1) - 0.2) < 1e-15);
    f.length = f.height = NAN;
    f.shape = OVR_GROOVE, f.depth = 0.3, f.width = 1;
    assert_true(fabs(at(&f, 0) + 0.3) < 1e-15 && fabs(at(&f, 0.7)) < 1e-15);
    assert_true(fabs(at(&f, -0.5) + 0.15) < 1e-15);
    f.flank = NAN, f.shape = OVR_RIDGE;
    assert_true(fabs(at(&f, 0.3) + 0.3 * pow(10, -0.9)) < 1e-15);
    f.shape = OVR_INDENT, f.shoulder = 0.1, f.shoulder_at = 1.5;
    assert_true(fabs(at(&f, 1.5) - 0.1) < 1e-14);
    f.shoulder = f.shoulder_at = NAN, f.centre = NAN, f.origin = -1;
    f.shape = OVR_TEXTURE, f.wavelength = 2;
    assert_true(fabs(at(&f, 2) + 0.3) < 1e-15 && at(&f, 0.6) == 0);
    assert_true(fabs(at(&f, 0.25) + 0.15) < 1e-15);
}

TEST(chirp_runs_from_one_wavelength_to_the_other)
{
    ovr_feature_form f = ovr_feature_form_default();
    double rear = -2, last = 0, periods = 0;
    f.name = "it", f.centre = -1, f.shape = OVR_CHIRP, f.amplitude = 1;
    f.length = 4, f.wavelength = 0.2, f.wavelength_end = 0.4, f.flank = 0.1;
    assert_true(at(&f, -2) == 0 && at(&f, 2) == 0);
    for (double s = rear + 0.11; s < 1.89; s += 0.001) {
        double z = at(&f, s);
        periods += (z > 0) != (last > 0);
        last = z;
    }
    /* phase = int of 1/wavelength = 4 (5 + 2.5)/2 = 15 periods */
    assert_true(fabs(periods / 2 - 14.2) < 0.6);
}

TEST(places_agree)
{
    ovr_contact c = moes(1.25, 0.75);
    ovr_feature_form f = local(OVR_DENT, 0.1, 0.5);
    ovr_surfaces *s;
    f.start = NAN, f.arrival = 4;
    s = with(&c, NULL, &f);
    assert_true(fabs(ovr_surfaces_centre(s, 0, 4)) < 1e-14);
    assert_true(fabs(ovr_surfaces_arrival(s, 0, 1, 0, 99) - 4.8) < 1e-14);
    ovr_surfaces_free(s);
    f.arrival = NAN, f.edge = -4.1;
    s = with(&c, NULL, &f);
    assert_true(fabs(ovr_surfaces_centre(s, 0, 0) + 4.6) < 1e-14);
    assert_null(ovr_surfaces_inside(s, -4.1, 1.5));
    assert_string_equal(ovr_surfaces_inside(s, -4.2, 1.5), "it");
    ovr_surfaces_free(s);
}

/* Half of the depth is left at half the diameter, by the shape's formula; a
 * form with the diameter is the form with the width. */
TEST(diameters_are_at_half_depth)
{
    const ovr_shape shapes[] = {OVR_DENT, OVR_INDENT, OVR_RIDGE, OVR_GROOVE,
                                OVR_INDENT};
    ovr_contact c = moes(1, 1);
    for (int k = 0; k < 5; k++) {
        ovr_feature_form f = local(shapes[k], 0.1, 0.43);
        double at[2] = {-1.3}, height[2], diameter;
        ovr_surfaces *s;
        f.height = NAN, f.depth = 0.1;
        f.start = -1.3, f.shoulder = k == 4 ? 0.02 : NAN;
        s = with(&c, NULL, &f);
        diameter = ovr_surfaces_info(s, 0).diameter;
        at[1] = at[0] + diameter / 2;
        ovr_surfaces_heights(s, 0, 2, at, height);
        assert_true(diameter > 0 && fabs(height[1] / height[0] - 0.5) < 1e-12);
        ovr_surfaces_free(s);
        if (k == 4)
            continue;
        assert_true(
            fabs(ovr_shape_width_half((int)shapes[k]) * 0.43 / diameter - 1) <
            1e-14);
        for (int way = 0; way < 3; way++) {
            f.width = NAN;
            f.half_width = way == 0 ? diameter / 2 : NAN;
            f.diameter = way == 1 ? diameter : NAN;
            f.width_half = way == 2 ? diameter : NAN;
            s = with(&c, NULL, &f);
            assert_true(fabs(ovr_surfaces_info(s, 0).diameter / diameter - 1) <
                        1e-14);
            ovr_surfaces_free(s);
        }
    }
}

/* Indentation of a ball: depth and rim as specified, a spherical bowl,
 * continuous slope and curvature, and the displaced volume in the rim (within 1
 * % because of rounding). */
TEST(a_ball_leaves_its_volume_in_the_rim)
{
    enum { POINTS = 40001 };
    static double at[POINTS], height[POINTS];
    const double d = 0.2, step = 4. / (POINTS - 1), crest = 0.25;
    ovr_contact c = moes(1, 1);
    ovr_feature_form f = local(OVR_INDENT, 0.1, 0.5);
    double below = 0, above = 0, top = 0, where = 0, kink = 0;
    ovr_surfaces *s;
    f.height = f.width = NAN, f.depth = d, f.start = 0, f.surface = 2;
    f.rim_diameter = 2 * crest;
    s = with(&c, NULL, &f);
    for (int i = 0; i < POINTS; i++)
        at[i] = i * step;
    ovr_surfaces_heights(s, 0, POINTS, at, height);
    for (int i = 1; i + 1 < POINTS; i++) {
        double volume = at[i] * height[i] * step;
        double bend = (height[i + 1] - 2 * height[i] + height[i - 1]);
        below += volume < 0 ? volume : 0;
        above += volume > 0 ? volume : 0;
        kink = fmax(kink, fabs(bend) / step);
        if (height[i] > top)
            top = height[i], where = at[i];
    }
    assert_true(fabs(height[0] + d) < 1e-14);
    assert_true(fabs(top / d - 0.1585366) < 1e-5);
    assert_true(fabs(where - crest) < 2 * step);
    print_message("# rim over bowl %.4f\n", -above / below);
    assert_true(fabs(above / below + 1) < 0.02);
    assert_true(kink < 0.05); /* a break in the slope is some 2 */
    assert_true(fabs((height[1000] + d) / (height[500] + d) - 4) < 1e-9);
    assert_true(height[POINTS - 1] == 0);
    ovr_surfaces_free(s);
}

/* Without a place they are just outside, on the side that they come from. */
TEST(features_come_in_from_the_end)
{
    ovr_contact c = moes(1.25, -0.5);
    for (int surface = 1; surface <= 2; surface++) {
        ovr_feature_form f = local(OVR_DENT, 0.1, 0.5);
        ovr_surfaces *s = ovr_surfaces_create(&c, NULL, 0.01, NULL, NULL);
        double speed = surface == 1 ? 1.25 : -0.5;
        ovr_feature_times t;
        f.surface = surface, f.repeat = 2, f.copies = 3;
        f.start = surface == 1 ? NAN : -INFINITY;
        ovr_surfaces_domain(s, -4, 1.5);
        assert_int_equal(ovr_surfaces_add(s, &f, NULL), OVR_OK);
        assert_true(ovr_surfaces_centre(s, 0, 0) == (speed > 0 ? -4.5 : 2));
        assert_null(ovr_surfaces_inside(s, -4, 1.5));
        t = ovr_surfaces_times(s, 0, -4, 1.5, 1e3);
        assert_true(t.enters == 0);
        assert_true(fabs(t.centre - (speed > 0 ? 4.5 / 1.25 : 4)) < 1e-12);
        assert_true(fabs(t.leaves - (5.5 + 1 + 4) / fabs(speed)) < 1e-12);
        assert_true(isinf(ovr_surfaces_times(s, 0, -4, 1.5, 5).leaves));
        ovr_surfaces_free(s);
    }
}

/* Under a speed that changes, features keep to their surface's way. */
TEST(speed_history_moves_features)
{
    ovr_contact c = moes(1.5, 0.5);
    ovr_feature_form f = local(OVR_DENT, 0.1, 0.5);
    ovr_history_form h = ovr_history_form_default();
    ovr_history *speed;
    ovr_surfaces *s;
    h.kind = OVR_HISTORY_RAMP, h.from = 0, h.to = 1, h.duration = 2;
    speed = ovr_history_create(&h, NULL, NULL);
    assert_non_null(speed);
    s = with(&c, speed, &f);
    assert_true(fabs(ovr_surfaces_centre(s, 0, 4) - (-4.6 + 1.5 * 3)) < 1e-12);
    assert_true(fabs(ovr_surfaces_arrival(s, 0, -0.1, 0, 99) - 4) < 1e-9);
    ovr_surfaces_free(s);
    ovr_history_free(speed);
}

/* Features return after a reversal and pass again. After a start with negative
 * speed features and their copies enter from the right. */
TEST(features_return_after_a_reversal)
{
    const double quarter = acos(0), period = 8;
    ovr_contact c = moes(1.5, 0.5);
    ovr_feature_form f = local(OVR_DENT, 0.1, 0.5);
    ovr_history_form h = ovr_history_form_default();
    h.kind = OVR_HISTORY_SINE, h.mean = 0, h.amplitude = 1, h.period = period;
    h.start = -period / 4; /* cos(2 pi T/8) */
    ovr_history *speed = ovr_history_create(&h, NULL, NULL);
    assert_non_null(speed);
    f.start = -1;
    double way = 1.5 * period / (4 * quarter); /* times sin(2 pi T/8) */
    double there = asin(1 / way) * period / (4 * quarter);
    const double when[] = {there, period / 2 - there, period + there};
    for (int repeated = 0; repeated < 2; repeated++) {
        f.repeat = repeated ? 1.2 : NAN; /* no other copy comes so far */
        ovr_surfaces *s = with(&c, speed, &f);
        double T = -1;
        for (int k = 0; k < 3; k++) {
            T = ovr_surfaces_arrival(s, 0, 0, T, 99);
            assert_true(fabs(T - when[k]) < 1e-9);
        }
        ovr_surfaces_free(s);
    }
    ovr_history_free(speed);
    h.amplitude = -1;
    speed = ovr_history_create(&h, NULL, NULL);
    f.start = 1, f.repeat = 1;
    ovr_surfaces *s = with(&c, speed, &f);
    double left[1], right[1], at[] = {0, 2};
    ovr_surfaces_heights(s, 0, 1, at, left);
    ovr_surfaces_heights(s, 0, 1, at + 1, right);
    assert_true(left[0] == 0 && fabs(right[0] + 0.1) < 1e-12);
    ovr_surfaces_free(s);
    ovr_history_free(speed);
}

static void refuse(const ovr_feature_form *form, const char *word)
{
    ovr_contact c = moes(1, 0);
    ovr_error err = {0};
    ovr_surfaces *s = ovr_surfaces_create(&c, NULL, 0.01, NULL, &err);
    assert_int_equal(ovr_surfaces_add(s, form, &err), OVR_BAD_INPUT);
    if (!strstr(err.message, word))
        fail_msg("'%s' does not name '%s'", err.message, word);
    assert_null(strchr(err.message, '\n'));
    assert_int_equal(ovr_surfaces_count(s), 0);
    ovr_surfaces_free(s);
}

TEST(mistakes_are_reported)
{
    const ovr_feature_form good = local(OVR_DENT, 0.1, 0.5);
    ovr_feature_form f = good;
    f.width = NAN, refuse(&f, "width"), f = good;
    f.diameter = 1, refuse(&f, "one of width"), f = good;
    f.shape = OVR_WAVE, f.depth = f.width = NAN, f.half_width = 1;
    refuse(&f, "wave has no half_width"), f = good;
    f.rim_diameter = 1, refuse(&f, "dent has no rim_diameter"), f = good;
    f.shape = OVR_INDENT, f.rim_diameter = 1, refuse(&f, "no width");
    f.width = NAN, f.rim_height = 0.2, refuse(&f, "rim_height"), f = good;
    f.width = -1, refuse(&f, "width"), f = good;
    f.width = INFINITY, refuse(&f, "width"), f = good;
    f.depth = NAN, refuse(&f, "depth"), f = good;
    f.height = 1, refuse(&f, "height"), f = good;
    f.surface = 3, refuse(&f, "surface"), f = good;
    f.start = NAN, refuse(&f, "start"), f = good;
    f.edge = 1, refuse(&f, "only one of"), f = good;
    f.start = INFINITY, refuse(&f, "finite"), f = good;
    f.grow = -1, refuse(&f, "grow"), f = good;
    f.repeat = 1e-9, refuse(&f, "repeat"), f = good;
    f.copies = -1, refuse(&f, "copies"), f = good;
    f.shape = (ovr_shape)77, refuse(&f, "77"), f = good;
    f.start = NAN, f.arrival = 3, f.surface = 2, refuse(&f, "does not move");
    f = good, f.shape = OVR_WAVE, refuse(&f, "wave has no depth");
    f = good, f.shape = OVR_RIDGE, f.height = 1, refuse(&f, "not both");
    f = good, f.shape = OVR_GROOVE, f.radius = 1, refuse(&f, "with dimensions");
}

static void set_size(ovr_feature_form *form, const char *key, double value)
{
    const struct {
        const char *key;
        double *to;
    } sizes[] = {{"depth", &form->depth},
                 {"height", &form->height},
                 {"amplitude", &form->amplitude},
                 {"width", &form->width},
                 {"wavelength", &form->wavelength},
                 {"wavelength_end", &form->wavelength_end},
                 {"length", &form->length}};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
        if (!strcmp(sizes[k].key, key))
            *sizes[k].to = value;
}

static bool is_made(const ovr_contact *c, const ovr_feature_form *form)
{
    ovr_error err;
    ovr_surfaces *s = ovr_surfaces_create(c, NULL, X[1] - X[0], NULL, &err);
    assert_non_null(s);
    bool made = ovr_surfaces_add(s, form, &err) == OVR_OK;
    ovr_surfaces_free(s);
    return made;
}

/* The rules of the manual: a feature with all stated sizes is accepted, and
 * rejected without the last of them. */
TEST(shapes_need_the_stated_sizes)
{
    ovr_contact c = moes(1, 1);
    for (int shape = 0; shape < OVR_PROFILE; shape++) {
        char text[500], *word, *rest = text + strlen("needs ");
        ovr_feature_form form = ovr_feature_form_default();
        assert_true(ovr_shape_takes(shape, text, sizeof text) < 500);
        assert_int_equal(strncmp(text, "needs ", 6), 0);
        form.name = "it";
        form.shape = (ovr_shape)shape;
        if (shape != OVR_WAVE && shape != OVR_TEXTURE) /* they are endless */
            form.start = -4.6;
        text[strcspn(text, ";.")] = '\0';
        while ((word = strtok_r(rest, ",", &rest))) {
            word += strspn(word, " ");
            word[strcspn(word, " ")] = '\0'; /* "depth or height" */
            assert_false(is_made(&c, &form));
            set_size(&form, word, strcmp(word, "length") ? 0.3 : 3);
        }
        assert_true(is_made(&c, &form));
    }
}

TEST_GROUP(grid, NULL)
