/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A cam and a follower whose way goes through the cam's axis; s(theta) the
 * lift, omega the cam's speed, rb and rr the radii of base circle and roller.
 *
 * Flat:    R_1 = rb + s + s'',  R_2 = infinite,  u1 = omega R_1,
 *          u2 = omega s'',  F = preload + spring s + mass omega^2 s''
 * Roller:  r = rb + rr + s,  q = r^2 + s'^2
 *          rho = q^(3/2)/(r^2 + 2 s'^2 - r s'')       of the pitch curve
 *          R_1 = rho - rr,  R_2 = rr,  u1 = omega sqrt(q) (rho - rr)/rho
 *          the contact carries F sqrt(q)/r
 * (the pitch curve in polar coordinates; the speed of the contact along the cam
 * is that of its pitch point less the roller's part).  A flat follower's mean
 * speed omega (rb + s + 2 s'')/2 may pass zero, a roller's never does.
 */
#include "elements/elements.h"

#include <math.h>

#include "base/arena.h"
#include "base/error.h"
#include "elements/lift.h"
#include "elements/needed.h"

static const double pi = 3.14159265358979323846;

struct ovr_cam {
    ovr_cam_form form;
    ovr_cam_event event;
    double *bending; /* of a table's spline */
    ovr_arena arena;
};

ovr_cam_form ovr_cam_form_default(void)
{
    return (ovr_cam_form){.base_radius = NAN,
                          .roller_radius = NAN,
                          .face = NAN,
                          .speed = NAN,
                          .lift = NAN,
                          .rise = NAN,
                          .fall = NAN,
                          .spring = NAN,
                          .preload = NAN,
                          .from = NAN,
                          .to = NAN};
}

/* --------------------------------------------------------------- contact */

/* Radius of the pitch curve of a roller. */
static double pitch_radius(double r, const double lift[3])
{
    double q = r * r + lift[1] * lift[1];
    return q * sqrt(q) / (q + lift[1] * lift[1] - r * lift[2]);
}

static double force(const ovr_cam_form *f, const double lift[3])
{
    return f->preload + f->spring * lift[0] +
           f->mass * f->speed * f->speed * lift[2];
}

static ovr_element_moment contact(const ovr_cam *cam, double angle)
{
    const ovr_cam_form *f = &cam->form;
    ovr_element_moment m = {.t = (angle - cam->event.from) / f->speed};
    double lift[3];
    ovr_lift_at(f, cam->bending, angle, lift);
    m.load = force(f, lift) / f->face;
    if (f->follower == OVR_FOLLOWER_FLAT) {
        m.R = m.R_1 = f->base_radius + lift[0] + lift[2];
        m.R_2 = INFINITY;
        m.u1 = f->speed * m.R_1;
        m.u2 = f->speed * lift[2];
        return m;
    }
    double r = f->base_radius + f->roller_radius + lift[0];
    double way = sqrt(r * r + lift[1] * lift[1]), rho = pitch_radius(r, lift);
    m.R_1 = rho - f->roller_radius;
    m.R_2 = f->roller_radius;
    m.R = f->roller_radius * m.R_1 / rho;
    m.u1 = f->speed * way * m.R_1 / rho;
    double mean = m.u1 / (1 + f->slip / 2);
    m.u2 = mean * (1 - f->slip / 2);
    m.load *= way / r;
    return m;
}

/* --------------------------------------------------------------- checks */

static ovr_status check_form(const ovr_cam_form *f, ovr_error *err)
{
    bool laws = f->law != OVR_CAM_TABLE;
    const ovr_needed all[] = {
        {"base_radius", f->base_radius, false},
        {"face", f->face, false},
        {"speed", f->speed, false},
        {"spring", f->spring, true},
        {"preload", f->preload, true},
        {"mass", f->mass, true},
        {"roller_radius",
         f->follower == OVR_FOLLOWER_ROLLER ? f->roller_radius : 1, false},
        {"lift", laws ? f->lift : 1, false},
        {"rise", laws ? f->rise : 1, false},
        {"dwell", laws ? f->dwell : 1, true},
        {"fall", laws ? f->fall : 1, false}};
    if (ovr_check_needed(all, sizeof all / sizeof *all, err))
        return OVR_BAD_INPUT;
    if (!(fabs(f->slip) < 2))
        return ovr_fail_about(err, "slip", "slip = %g: must be below 2",
                              f->slip);
    return OVR_OK;
}

static double degrees(double angle)
{
    return angle * 180 / pi;
}

/* The space that there is at an angle until the follower cannot follow: of a
 * flat one the cam's radius of curvature; of a roller what its pitch curve's is
 * above its own, where it is not hollow. */
static double clearance_at(const ovr_cam *cam, double angle)
{
    const ovr_cam_form *f = &cam->form;
    double lift[3];
    ovr_lift_at(f, cam->bending, angle, lift);
    if (f->follower == OVR_FOLLOWER_FLAT)
        return f->base_radius + lift[0] + lift[2];
    double rho = pitch_radius(f->base_radius + f->roller_radius + lift[0],
                              lift);
    return rho < 0 ? INFINITY : rho - f->roller_radius;
}

static ovr_status check_shape(const ovr_cam *cam, double angle, ovr_error *err)
{
    const ovr_cam_form *f = &cam->form;
    double clearance = clearance_at(cam, angle);
    if (clearance > 0)
        return OVR_OK;
    if (f->follower == OVR_FOLLOWER_FLAT)
        return ovr_fail_about(err, "base_radius",
                              "the cam is concave at %.3g deg: rho = %.3g mm; "
                              "a flat follower cannot follow: base_radius at "
                              "least %.4g mm",
                              degrees(angle), 1e3 * clearance,
                              1e3 * (f->base_radius - clearance) * 1.001);
    return ovr_fail_about(err, "roller_radius",
                          "undercut at %.3g deg: the pitch curve's radius "
                          "%.3g mm is within the roller's %.3g mm",
                          degrees(angle), 1e3 * (clearance + f->roller_radius),
                          1e3 * f->roller_radius);
}

/* ------------------------------------------------------------- the event */

enum { LOOKS = 7200 };

static double look(const ovr_cam_event *e, int k)
{
    return e->from + (e->to - e->from) * k / LOOKS;
}

static double mean_speed(const ovr_cam *cam, double angle)
{
    ovr_element_moment m = contact(cam, angle);
    return m.u1 + m.u2;
}

static double reversal_between(const ovr_cam *cam, double low, double high)
{
    bool rises = mean_speed(cam, low) < 0;
    for (int k = 0; k < 80; k++) {
        double middle = 0.5 * (low + high);
        if ((mean_speed(cam, middle) < 0) == rises)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

static void find_reversals(ovr_cam *cam)
{
    ovr_cam_event *e = &cam->event;
    size_t capacity = sizeof e->reversal / sizeof *e->reversal;
    for (int k = 0; k < LOOKS && e->reversals < capacity; k++)
        if (mean_speed(cam, look(e, k)) * mean_speed(cam, look(e, k + 1)) < 0)
            e->reversal[e->reversals++] = reversal_between(cam, look(e, k),
                                                           look(e, k + 1));
}

static ovr_status check_event(ovr_cam *cam, ovr_error *err)
{
    ovr_cam_event *e = &cam->event;
    double gone[2] = {NAN, NAN}, highest = -1, tightest = e->from;
    double minimum = clearance_at(cam, e->from);
    e->min_force = INFINITY;
    for (int k = 0; k <= LOOKS; k++) {
        double clearance = clearance_at(cam, look(e, k));
        if (clearance < minimum) {
            minimum = clearance;
            tightest = look(e, k);
        }
    }
    ovr_status status = check_shape(cam, tightest, err);
    if (status)
        return status;
    for (int k = 0; k <= LOOKS; k++) {
        double lift[3], now, angle = look(e, k);
        ovr_lift_at(&cam->form, cam->bending, angle, lift);
        now = force(&cam->form, lift);
        e->min_force = fmin(e->min_force, now);
        if (lift[0] > highest) {
            highest = lift[0];
            e->nose = angle;
        }
        if (now > 0)
            continue;
        gone[0] = isnan(gone[0]) ? angle : gone[0];
        gone[1] = angle;
    }
    if (isnan(gone[0]))
        return OVR_OK;
    return ovr_fail_about(err, "preload",
                          "the follower leaves the cam at %.3g to %.3g deg: "
                          "the least force is %.3g N: more preload or spring, "
                          "less speed",
                          degrees(gone[0]), degrees(gone[1]), e->min_force);
}

static ovr_status make_event(ovr_cam *cam, ovr_error *err)
{
    const ovr_cam_form *f = &cam->form;
    ovr_cam_event *e = &cam->event;
    bool table = f->law == OVR_CAM_TABLE;
    double first = table ? f->angle[0] : 0;
    double last = table ? f->angle[f->points - 1]
                        : f->rise + f->dwell + f->fall;
    e->from = isnan(f->from) ? first : f->from;
    e->to = isnan(f->to) ? last : f->to;
    if (!(e->from < e->to))
        return ovr_fail_about(err, "to",
                              "to = %.4g deg: must be above from = "
                              "%.4g deg",
                              degrees(e->to), degrees(e->from));
    if (e->from < first - 2 * pi || e->to > last + 2 * pi)
        return ovr_fail_about(err, e->from < first ? "from" : "to",
                              "the event goes from %.4g to %.4g deg",
                              degrees(first), degrees(last));
    e->duration = (e->to - e->from) / f->speed;
    e->joints[0] = first;
    e->joints[1] = table ? first : f->rise;
    e->joints[2] = table ? last : f->rise + f->dwell;
    e->joints[3] = last;
    e->jumps = f->law == OVR_CAM_HARMONIC;
    ovr_status status = check_event(cam, err);
    if (!status)
        find_reversals(cam);
    return status;
}

/* -------------------------------------------------------------- creation */

static ovr_status make(ovr_cam *cam, ovr_arena *arena, ovr_error *err)
{
    ovr_status status;
    if (isnan(cam->form.fall))
        cam->form.fall = cam->form.rise;
    if ((status = check_form(&cam->form, err)) ||
        (status = ovr_lift_make(&cam->form, &cam->bending, arena, err)))
        return status;
    return make_event(cam, err);
}

ovr_cam *ovr_cam_create(const ovr_cam_form *form,
                        const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_cam *cam;
    if (!form) {
        ovr_fail(err, OVR_BAD_INPUT, "no form of a cam was given");
        return NULL;
    }
    cam = ovr_arena_take(&arena, 1, sizeof *cam, err);
    if (cam) {
        cam->form = *form;
        if (!make(cam, &arena, err)) {
            cam->arena = arena;
            return cam;
        }
    }
    ovr_arena_release(&arena);
    return NULL;
}

void ovr_cam_free(ovr_cam *cam)
{
    if (cam) {
        ovr_arena arena = cam->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_cam_event *ovr_cam_of(const ovr_cam *cam)
{
    return cam ? &cam->event : NULL;
}

const ovr_cam_form *ovr_cam_form_of(const ovr_cam *cam)
{
    return cam ? &cam->form : NULL;
}

ovr_element_moment ovr_cam_at(const ovr_cam *cam, double t)
{
    if (!cam)
        return (ovr_element_moment){0};
    ovr_element_moment m = contact(cam, cam->event.from + cam->form.speed * t);
    m.t = t;
    return m;
}

void ovr_cam_lift(const ovr_cam *cam, double t, double lift[3])
{
    if (!cam || !lift)
        return;
    ovr_lift_at(&cam->form, cam->bending, cam->event.from + cam->form.speed * t,
                lift);
}
