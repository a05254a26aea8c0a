/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gears, cams and roller bearings compared with an independent program (1e-9),
 * geometric identities and closed forms; rejected inputs. */
#include <math.h>
#include <string.h>

#include "case/setup.h"
#include "contact/contact.h"
#include "elements/elements.h"
#include "reference/elements_truth.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;
static const double same = 1e-9; /* two programs, both in double precision */

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ----------------------------------------------------------------- gears */

static ovr_gear *gear(const ovr_gear_form *form)
{
    ovr_error err = {0};
    ovr_gear *made = ovr_gear_create(form, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static ovr_gear_form given_gear(const truth_gear *truth)
{
    ovr_gear_form form = ovr_gear_form_default();
    form.teeth_1 = truth->teeth_1;
    form.teeth_2 = truth->teeth_2;
    form.module = truth->given[0];
    form.speed = truth->given[1];
    form.torque = truth->given[2];
    form.face = truth->given[3];
    form.helix_angle = truth->given[4];
    form.pressure_angle = truth->given[5];
    form.shift_1 = truth->given[6];
    form.shift_2 = truth->given[7];
    form.centre = truth->given[8];
    return form;
}

static void check_geometry(const ovr_gear_geometry *g, const double *truth)
{
    const double ours[] = {
        g->centre,        g->working_angle, g->shift_2,    g->base_1,
        g->tip_1,         g->tip_2,         g->line,       g->R1_A,
        g->R1_B,          g->R1_C,          g->R1_D,       g->R1_E,
        g->contact_ratio, g->overlap_ratio, g->base_helix, g->normal_force,
        g->duration,      g->mesh_stiffness};
    for (size_t k = 0; k < COUNT(ours); k++)
        if (!isnan(truth[k]))
            CHECK_NEAR(ours[k], truth[k], same * fmax(fabs(truth[k]), 1e-3));
}

static double load_at(ovr_gear_form form, ovr_gear_sharing sharing,
                      double blend, double slice, double t)
{
    form.sharing = sharing;
    form.blend = blend;
    form.slice = slice;
    if (sharing == OVR_SHARING_STIFFNESS) {
        form.relief_1 = 15e-6;
        form.relief_2 = 20e-6;
    }
    ovr_gear *made = gear(&form);
    double load = ovr_gear_at(made, t).load;
    ovr_gear_free(made);
    return load;
}

static void check_loads(const ovr_gear_form *form, const ovr_gear_geometry *g,
                        double blend, const double *p)
{
    double whole = g->transverse_force / form->face;
    if (form->helix_angle != 0) {
        CHECK_CLOSE(load_at(*form, OVR_SHARING_ELASTIC, 0, 0.5, p[0]), p[6],
                    same);
        CHECK_CLOSE(load_at(*form, OVR_SHARING_ELASTIC, 0, 0.2, p[0]), p[7],
                    same);
        return;
    }
    CHECK_CLOSE(load_at(*form, OVR_SHARING_RULE, blend, 0.5, p[0]), p[6], same);
    CHECK_CLOSE(load_at(*form, OVR_SHARING_ELASTIC, 0, 0.5, p[0]), p[7], same);
    CHECK_CLOSE(load_at(*form, OVR_SHARING_ELASTIC, blend, 0.5, p[0]), p[8],
                same);
    if (!isnan(p[9]))
        CHECK_NEAR(load_at(*form, OVR_SHARING_STIFFNESS, 0, 0.5, p[0]),
                   p[9] * whole, same * whole);
}

TEST(gears_are_those_of_another_program)
{
    for (size_t k = 0; k < COUNT(truth_gears); k++) {
        const truth_gear *truth = &truth_gears[k];
        ovr_gear_form form = given_gear(truth);
        ovr_gear *made = gear(&form);
        const ovr_gear_geometry *g = ovr_gear_of(made);
        check_geometry(g, truth->derived);
        for (int i = 0; i < MOMENTS; i++) {
            const double *p = truth->points[i];
            ovr_element_moment m = ovr_gear_at(made, p[0]);
            CHECK_CLOSE(m.R, p[1], same);
            CHECK_CLOSE(m.R_1, p[2], same);
            CHECK_CLOSE(m.R_2, p[3], same);
            CHECK_CLOSE(m.u1, p[4], same);
            CHECK_CLOSE(m.u2, p[5], same);
            /* The first is the gear of the examples, which blends over 0.4 mm.
             */
            check_loads(&form, g, k ? 0.05 : 0.4e-3 / g->base_pitch, p);
        }
        ovr_gear_free(made);
    }
}

/* The pitch point does not slide, curvatures and radii add up, whatever the
 * pair. */
TEST(gears_keep_their_identities)
{
    for (size_t k = 0; k < COUNT(truth_gears); k++) {
        ovr_gear_form form = given_gear(&truth_gears[k]);
        ovr_gear *made = gear(&form);
        const ovr_gear_geometry *g = ovr_gear_of(made);
        double along = cos(g->base_helix);
        ovr_element_moment C = ovr_gear_at(made, ovr_gear_time(made, g->R1_C));
        CHECK_NEAR(C.u1 - C.u2, 0, 1e-13 * C.u1);
        CHECK_NEAR(C.R_1 + C.R_2, g->line / along, 1e-13 * fabs(g->line));
        CHECK_CLOSE(1 / C.R, 1 / C.R_1 + 1 / C.R_2, 1e-12);
        /* The contact ratio by the angles at the tips (ISO 21771). */
        double tip_1 = acos(2 * g->base_1 / g->tip_1);
        double tip_2 = acos(2 * fabs(g->base_2) / g->tip_2);
        double by_angles =
            (form.teeth_1 * (tan(tip_1) - tan(g->working_angle)) +
             form.teeth_2 * (tan(tip_2) - tan(g->working_angle))) /
            (2 * pi);
        CHECK_NEAR(g->contact_ratio, by_angles, 1e-12);
        ovr_gear_free(made);
    }
}

/* Load shares of all pairs in contact add up to 1 for every rule, except within
 * the blend around B and D. */
TEST(shares_add_up)
{
    const ovr_gear_sharing rules[] = {OVR_SHARING_RULE, OVR_SHARING_ELASTIC,
                                      OVR_SHARING_STIFFNESS};
    for (size_t r = 0; r < COUNT(rules); r++) {
        ovr_gear_form form = given_gear(&truth_gears[0]);
        form.sharing = rules[r];
        form.blend = 0;
        form.relief_1 = rules[r] == OVR_SHARING_STIFFNESS ? 12e-6 : 0;
        ovr_gear *made = gear(&form);
        const ovr_gear_geometry *g = ovr_gear_of(made);
        double pitch = g->base_pitch / (g->base_1 * g->omega_1);
        for (double t = 0.003 * pitch; t < pitch; t += 0.017 * pitch) {
            double sum = 0;
            for (double at = t; at < g->duration; at += pitch)
                sum += ovr_gear_at(made, at).load;
            CHECK_CLOSE(sum, g->transverse_force / form.face, 1e-12);
        }
        ovr_gear_free(made);
    }
}

/* At one moment, the contact lines of all pairs carry F_n together: the sum
 * over slices of the face, each of which meets the pairs a little later than
 * the one before. */
TEST(helical_lines_carry_the_load)
{
    enum { ACROSS = 2000 };
    ovr_gear_form form = given_gear(&truth_gears[2]);
    double sum = 0, along = 0, whole = 0;
    assert_true(form.helix_angle > 0);
    for (int i = 0; i < ACROSS; i++) {
        form.slice = (i + 0.5) / ACROSS;
        ovr_gear *made = gear(&form);
        const ovr_gear_geometry *g = ovr_gear_of(made);
        double pitch = g->base_pitch / (g->base_1 * g->omega_1);
        for (int j = -9; j <= 9; j++) {
            double t = (g->contact_ratio / 2 + j -
                        (form.slice - 0.5) * g->overlap_ratio) *
                       pitch;
            if (t >= 0 && t <= g->duration)
                sum += ovr_gear_at(made, t).load / ACROSS;
        }
        along = form.face / cos(g->base_helix);
        whole = g->normal_force;
        ovr_gear_free(made);
    }
    /* A line that ends within a slice is counted whole or not at all: of first
     * order in the slices. */
    CHECK_CLOSE(sum * along, whole, 2.0 / ACROSS);
}

/* Gear 1 and 2 exchanged, and which of them drives: the same contact with its
 * surfaces exchanged. */
TEST(a_mirrored_pair_is_the_same)
{
    for (size_t k = 0; k < COUNT(truth_gears); k++) {
        ovr_gear_form form = given_gear(&truth_gears[k]), other = form;
        if (form.teeth_2 < 0)
            continue;
        ovr_gear *one = gear(&form);
        const ovr_gear_geometry *g = ovr_gear_of(one);
        other.teeth_1 = form.teeth_2;
        other.teeth_2 = form.teeth_1;
        other.shift_1 = g->shift_2;
        other.shift_2 = g->shift_1;
        other.centre = NAN;
        other.speed = g->omega_2;
        other.torque = form.torque * form.teeth_2 / form.teeth_1;
        other.driving = 2;
        ovr_gear *two = gear(&other);
        for (int i = 0; i <= 20; i++) {
            double t = g->duration * i / 20;
            ovr_element_moment a = ovr_gear_at(one, t), b = ovr_gear_at(two, t);
            CHECK_CLOSE(b.R, a.R, 1e-9);
            CHECK_CLOSE(b.R_1, a.R_2, 1e-9);
            CHECK_CLOSE(b.u1, a.u2, 1e-9);
            CHECK_CLOSE(b.u2, a.u1, 1e-9);
            CHECK_CLOSE(b.load, a.load, 1e-9);
        }
        ovr_gear_free(one);
        ovr_gear_free(two);
    }
}

/* The radius of curvature is that of the involute drawn point by point: the
 * string's length is the arc it has left. */
TEST(radii_are_those_of_involutes)
{
    ovr_gear_form form = given_gear(&truth_gears[0]);
    ovr_gear *made = gear(&form);
    const ovr_gear_geometry *g = ovr_gear_of(made);
    for (int i = 1; i < 20; i++) {
        ovr_element_moment m = ovr_gear_at(made, g->duration * i / 20);
        double x[3], y[3], roll = m.R_1 / g->base_1, step = 1e-3 * roll;
        for (int k = 0; k < 3; k++) {
            double a = roll + (k - 1) * step;
            x[k] = g->base_1 * (cos(a) + a * sin(a));
            y[k] = g->base_1 * (sin(a) - a * cos(a));
        }
        /* The circle through three points. */
        double ax = x[1] - x[0], ay = y[1] - y[0], bx = x[2] - x[1],
               by = y[2] - y[1], cx = x[2] - x[0], cy = y[2] - y[0];
        double R = hypot(ax, ay) * hypot(bx, by) * hypot(cx, cy) /
                   (2 * fabs(ax * by - ay * bx));
        CHECK_CLOSE(m.R_1, R, 1e-5);
    }
    ovr_gear_free(made);
}

static void refused_gear(const ovr_gear_form *form, const char *about,
                         const char *part)
{
    ovr_error err = {0};
    assert_null(ovr_gear_create(form, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, part);
    assert_string_equal(err.about, about);
}

TEST(impossible_gears_are_refused)
{
    const ovr_gear_form good = given_gear(&truth_gears[0]);
    ovr_gear_form form = good;
    form.module = NAN;
    refused_gear(&form, "module", "must be positive");
    form = good;
    form.teeth_1 = 3;
    refused_gear(&form, "teeth_1", "5 or more");
    form = good;
    form.teeth_1 = -20;
    refused_gear(&form, "teeth_1", "internal gear must be gear 2");
    form = good;
    form.teeth_1 = 24;
    form.teeth_2 = -30;
    refused_gear(&form, "teeth_2", "at least 8 teeth more");
    form = good;
    form.centre = 0.08;
    refused_gear(&form, "centre", "centre must be above 84.5");
    form = good;
    form.shift_1 = form.shift_2 = 0;
    refused_gear(&form, "centre", "remove one of the");
    form = good;
    form.teeth_1 = 8;
    form.shift_1 = form.shift_2 = 0;
    form.centre = NAN;
    refused_gear(&form, "tip_2", "interference");
    form = good;
    form.addendum = 0.4;
    refused_gear(&form, "teeth_1", "no tooth pair is in contact");
    form = good;
    form.tip_1 = 0.05;
    refused_gear(&form, "tip_1", "inside the base circle");
    form = good;
    form.relief_1 = 1e-5;
    refused_gear(&form, "relief_1", "sharing = stiffness");
    form = good;
    form.helix_angle = 0.3;
    form.centre = NAN;
    form.shift_2 = 0;
    form.sharing = OVR_SHARING_RULE;
    refused_gear(&form, "sharing", "helical");
}

TEST(flash_temperatures_follow_blok)
{
    enum { STEPS = 400000 };
    const ovr_element_moment m = {
        .u1 = 3, .u2 = 2, .load = 1e5, .R = 0.01, .R_1 = 0.02, .R_2 = 0.02};
    double b = 1e-4, mu = 0.05, B = 1.2e4, largest = 0;
    /* A half-elliptic source of the heat Q = mu w |u1 - u2| moves over a half
     * space: T(x) = (1/(B sqrt(pi u))) times the integral of q over the root
     * of the way since; both surfaces share it so that B sqrt(u) adds up. */
    for (double x = 0.6; x < 0.7; x += 0.01) {
        double reach = sqrt(x + 1), step = reach / STEPS, sum = 0;
        for (int k = 0; k < STEPS; k++) {
            double y = (k + 0.5) * step, s = x - y * y;
            sum += sqrt(fmax(0, 1 - s * s)) * 2 * step;
        }
        largest = fmax(largest, sum);
    }
    double Q = mu * m.load * fabs(m.u1 - m.u2);
    double q0 = 2 * Q / (pi * b), carried = B * (sqrt(m.u1) + sqrt(m.u2));
    CHECK_CLOSE(ovr_flash_temperature(&m, b, mu, B, B),
                q0 * sqrt(b / pi) * largest / carried, 2e-4);
}

/* ------------------------------------------------------------------ cams */

static ovr_cam_form given_cam(const truth_cam *truth)
{
    const double *x = truth->given;
    ovr_cam_form form = ovr_cam_form_default();
    form.law = (ovr_cam_law)truth->law;
    form.follower = truth->roller ? OVR_FOLLOWER_ROLLER : OVR_FOLLOWER_FLAT;
    form.lift = x[0];
    form.rise = x[1];
    form.dwell = x[2];
    form.fall = x[3];
    form.base_radius = x[4];
    form.roller_radius = x[5];
    form.speed = x[6];
    form.preload = x[7];
    form.spring = x[8];
    form.mass = x[9];
    form.face = x[10];
    form.slip = x[11];
    return form;
}

static ovr_cam *cam(const ovr_cam_form *form)
{
    ovr_error err = {0};
    ovr_cam *made = ovr_cam_create(form, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static void check_cam_point(const ovr_cam *made, const truth_cam *truth,
                            const double *p)
{
    double t = p[0] / truth->given[6], lift[3], h = truth->given[0];
    ovr_element_moment m = ovr_cam_at(made, t);
    ovr_cam_lift(made, t, lift);
    CHECK_NEAR(lift[0], p[1], same * h);
    CHECK_NEAR(lift[1], p[2], same * h);
    CHECK_NEAR(lift[2], p[3], same * 10 * h);
    CHECK_CLOSE(m.R, p[4], 1e-8);
    CHECK_CLOSE(m.R_1, p[5], 1e-8);
    CHECK_NEAR(m.u1, p[6], 1e-8 * fabs(p[6]));
    CHECK_NEAR(m.u2, p[7], 1e-8 * (fabs(p[6]) + fabs(p[7])));
    CHECK_CLOSE(m.load, p[8], same);
}

TEST(cams_are_those_of_another_program)
{
    for (size_t k = 0; k < COUNT(truth_cams); k++) {
        const truth_cam *truth = &truth_cams[k];
        ovr_cam_form form = given_cam(truth);
        ovr_cam *made = cam(&form);
        const ovr_cam_event *event = ovr_cam_of(made);
        assert_int_equal(event->reversals, truth->turns);
        for (int i = 0; i < truth->turns; i++)
            CHECK_NEAR(event->reversal[i], truth->turn[i], 1e-9);
        for (int i = 0; i < MOMENTS; i++)
            check_cam_point(made, truth, truth->points[i]);
        ovr_cam_free(made);
    }
}

/* An eccentric circle under a flat follower: s = d (1 + cos), whose curvature
 * is that of the circle everywhere; as a table of exact numbers. */
TEST(a_circle_is_a_circle)
{
    enum { POINTS = 721 };
    const double r = 0.03, d = 0.006;
    double angle[POINTS], height[POINTS];
    ovr_cam_form form = given_cam(&truth_cams[0]);
    for (int k = 0; k < POINTS; k++) {
        angle[k] = 2 * pi * k / (POINTS - 1);
        height[k] = d * (1 - cos(angle[k]));
    }
    form.law = OVR_CAM_TABLE;
    form.base_radius = r - d;
    form.points = POINTS;
    form.angle = angle;
    form.height = height;
    /* A natural spline bends wrongly at its ends alone. */
    form.from = 1;
    form.to = 5;
    ovr_cam *made = cam(&form);
    for (int k = 0; k <= 40; k++) {
        double t = ovr_cam_of(made)->duration * k / 40;
        double theta = 1 + form.speed * t;
        ovr_element_moment m = ovr_cam_at(made, t);
        /* The spline's second derivative is off by step^2/12 of the fourth. */
        CHECK_NEAR(m.R_1, r, 1.01 * d * pow(angle[1], 2) / 12);
        CHECK_CLOSE(m.u1 - m.u2, form.speed * (r - d * cos(theta)), 1e-6);
    }
    ovr_cam_free(made);
}

static void refused_cam(const ovr_cam_form *form, const char *about,
                        const char *part)
{
    ovr_error err = {0};
    assert_null(ovr_cam_create(form, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, part);
    assert_string_equal(err.about, about);
}

TEST(impossible_cams_are_refused)
{
    enum { POINTS = 121 };
    double angle[POINTS], height[POINTS];
    const ovr_cam_form flat = given_cam(&truth_cams[0]);
    const ovr_cam_form roller = given_cam(&truth_cams[1]);
    ovr_cam_form form = flat;
    form.base_radius = 0.005;
    refused_cam(&form, "base_radius", "a flat follower loses contact");
    form = roller;
    form.roller_radius = 0.06;
    form.base_radius = 0.008;
    refused_cam(&form, "roller_radius", "undercut");
    form = flat;
    form.preload = 0;
    form.spring = 0;
    form.speed = 300;
    refused_cam(&form, "preload", "lifts off the cam");
    for (int k = 0; k < POINTS; k++) {
        angle[k] = k * pi / 180;
        height[k] = 1e-6 * floor(1e6 * 0.004 * (1 - cos(3 * angle[k])));
    }
    form = flat;
    form.law = OVR_CAM_TABLE;
    form.points = POINTS;
    form.angle = angle;
    form.height = height;
    form.rounding = 1e-6;
    refused_cam(&form, "file", "rounded to 1 um");
    form = flat;
    form.rise = NAN;
    refused_cam(&form, "rise", "must be positive");
}

/* -------------------------------------------------------------- bearings */

static ovr_bearing_form given_bearing(const truth_bearing *truth, int contact)
{
    const double *x = truth->given;
    ovr_bearing_form form = ovr_bearing_form_default();
    form.rollers = truth->rollers;
    form.roller = x[0];
    form.length = x[1];
    form.load = x[2];
    form.speed_inner = x[3];
    form.speed_outer = x[4];
    form.clearance = x[5];
    form.inner = x[6];
    form.pitch = x[7];
    form.contact = contact;
    return form;
}

static ovr_bearing *bearing(const ovr_bearing_form *form)
{
    ovr_error err = {0};
    ovr_bearing *made = ovr_bearing_create(form, NULL, &err);
    CHECK_OK(err.status, &err);
    return made;
}

static void check_passes(const ovr_bearing *made, const truth_raceway *truth)
{
    const double phase[2] = {0, 0.2};
    double angle[512], load[512];
    for (int i = 0; i < 2; i++) {
        double sum = 0;
        size_t count = ovr_bearing_passes(made, phase[i], 0, 512, angle, load);
        /* The other program lists them by angle, ours as they come. */
        size_t first = truth->step < 0 ? count - 1 : 0;
        assert_int_equal(count, truth->met[i].count);
        for (size_t k = 0; k < count; k++)
            sum += load[k];
        /* A ring that stands still meets every roller at the same place. */
        if (truth->step != 0)
            CHECK_NEAR(angle[first], truth->met[i].angle, 1e-12);
        CHECK_NEAR(load[first], truth->met[i].load, same * sum);
        CHECK_CLOSE(sum, truth->met[i].sum, same);
    }
}

TEST(bearings_are_those_of_another_program)
{
    for (size_t k = 0; k < COUNT(truth_bearings); k++) {
        const truth_bearing *truth = &truth_bearings[k];
        for (int contact = 1; contact <= 2; contact++) {
            const truth_raceway *way = &truth->raceway[contact - 1];
            ovr_bearing_form form = given_bearing(truth, contact);
            ovr_bearing *made = bearing(&form);
            const ovr_bearing_geometry *g = ovr_bearing_of(made);
            const double ours[] = {g->pitch, g->stiffness,    g->cage,
                                   g->spin,  g->displacement, g->heaviest};
            ovr_element_moment m = ovr_bearing_contact(made, g->heaviest);
            for (size_t i = 0; i < COUNT(ours); i++)
                CHECK_CLOSE(ours[i], truth->derived[i], same);
            assert_int_equal(g->loaded, truth->loaded);
            for (int i = 0; i < 5; i++)
                CHECK_NEAR(ovr_bearing_load(made, i), truth->Q[i],
                           same * g->heaviest);
            CHECK_CLOSE(m.R, way->R, same);
            CHECK_CLOSE(m.R_1, way->R_1, same);
            CHECK_CLOSE(m.R_2, way->R_2, same);
            CHECK_CLOSE(m.u1, way->u, same);
            CHECK_CLOSE(g->spacing, way->spacing, same);
            CHECK_CLOSE(g->period, way->period, same);
            CHECK_NEAR(g->step, way->step, same);
            check_passes(made, way);
            ovr_bearing_free(made);
        }
    }
}

/* With very many rollers the sum is Stribeck's load integral:
 * F = n Q_max J_r(eps), eps = (1 - clearance/(2 d))/2. */
TEST(many_rollers_are_the_integral)
{
    for (size_t k = 0; k < COUNT(truth_load_integral); k++) {
        double eps = truth_load_integral[k][0], d = 1e-5;
        ovr_bearing_form form = ovr_bearing_form_default();
        form.rollers = 1000;
        form.roller = 0.001;
        form.length = 0.01;
        form.inner = 1;
        form.speed_inner = 10;
        form.clearance = 2 * d * (1 - 2 * eps);
        form.stiffness = 1e9;
        double maximum = form.stiffness * pow(d - form.clearance / 2, 10.0 / 9);
        form.load = form.rollers * maximum * truth_load_integral[k][1];
        ovr_bearing *made = bearing(&form);
        CHECK_CLOSE(ovr_bearing_of(made)->displacement, d, 2e-5);
        ovr_bearing_free(made);
    }
}

static void refused_bearing(const ovr_bearing_form *form, const char *about,
                            const char *part)
{
    ovr_error err = {0};
    assert_null(ovr_bearing_create(form, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, part);
    assert_string_equal(err.about, about);
}

TEST(impossible_bearings_are_refused)
{
    const ovr_bearing_form good = given_bearing(&truth_bearings[0], 1);
    ovr_bearing_form form = good;
    form.roller = 0.02;
    form.inner = NAN;
    form.pitch = 0.065;
    refused_bearing(&form, "rollers", "do not fit on a pitch circle of 65 mm");
    form = good;
    form.pitch = 0.065;
    refused_bearing(&form, "pitch", "remove one of the");
    form = good;
    form.speed_outer = form.speed_inner;
    refused_bearing(&form, "speed_inner", "speed_outer are equal");
    form = good;
    form.rollers = 2;
    refused_bearing(&form, "rollers", "3 to");
    form = good;
    form.load = -1;
    refused_bearing(&form, "load", "must be positive");
}

/* The splines through 1601 times and the discontinuities have the accuracy
 * stated in overroll-case(5). */
TEST(splines_follow_the_element)
{
    static const char text[] =
        "[contact]\nmodulus = 226 GPa\n[gear]\nmodule = 3 mm\nteeth_1 = 20\n"
        "teeth_2 = 40\nface = 20 mm\nspeed = 3000 rpm\ntorque = 100 N.m\n"
        "[lubricant]\nviscosity = 10 mPa.s\nalpha = 16 1/GPa\n";
    enum { LOOKS = 5003 }; /* between the times of the tables */
    double radius = 0, load = 0, speed = 0;
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "gear", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    CHECK_OK(err.status, &err);
    if (!setup) /* which the check has seen to */
        return;
    const ovr_gear *made = ovr_setup_gear(setup);
    const ovr_gear_geometry *g = ovr_gear_of(made);
    const ovr_contact *contact = setup->contact;
    for (int k = 0; k <= LOOKS; k++) {
        double t = (g->end - g->begin) * k / LOOKS, T = t / contact->time;
        ovr_element_moment m = ovr_gear_at(made, g->begin + t);
        radius = fmax(radius, fabs(ovr_history_value(setup->radius, T) -
                                   m.R / contact->radius));
        load = fmax(load, fabs(ovr_history_value(setup->load, T) -
                               m.load / contact->load));
        speed = fmax(speed, fabs(ovr_history_value(setup->speed, T) -
                                 (m.u1 + m.u2) / 2 / contact->um));
    }
    CHECK_NEAR(radius, 0, 2e-7);
    CHECK_NEAR(speed, 0, 2e-7);
    CHECK_NEAR(load, 0, 1e-4);
    ovr_setup_free(setup);
    ovr_case_free(c);
}
