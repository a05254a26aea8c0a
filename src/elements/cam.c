/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cam with a translating follower whose line of motion passes through the cam's
 * axis. s(theta) is the lift, omega the rotational speed of the cam, rb and rr
 * the radii of base circle and roller.
 *
 * Flat:    R_1 = rb + s + s'',  R_2 = infinite,  u1 = omega R_1,
 *          u2 = omega s'',  F = preload + spring s + mass omega^2 s''
 * Roller:  r = rb + rr + s,  q = r^2 + s'^2
 *          rho = q^(3/2)/(r^2 + 2 s'^2 - r s'')       of the pitch curve
 *          R_1 = rho - rr,  R_2 = rr,  u1 = omega sqrt(q) (rho - rr)/rho
 *          load of the contact: F sqrt(q)/r
 *
 * The pitch curve of the roller is in polar coordinates. The contact moves
 * along the cam at the speed of the pitch point times (rho - rr)/rho. The
 * entrainment speed of a flat follower, omega (rb + s + 2 s'')/2, may pass
 * zero; that of a roller follower does not.
 */
#include <math.h>

#include "base/arena.h"
#include "base/error.h"
#include "elements/elements.h"

/* --------------------------------------------------------------------- Lift */

/*
 * Laws of lift s = h f(y), where y is the passed fraction of the rise; the fall
 * is the reversed law. Tables are interpolated by the natural cubic spline. Its
 * second derivative is continuous, and so is the curvature of the cam:
 *
 *     h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1}
 *         = 6 ((s_{k+1} - s_k)/h_k - (s_k - s_{k-1})/h_{k-1}),
 *     m_0 = m_{n-1} = 0
 *
 * If heights are rounded to r, the second derivatives have errors of up to 12
 * r/step^2. (The largest row sum of the inverse is 2, the difference quotient
 * contributes a factor of 6.)
 */

static const double pi = 3.14159265358979323846;

/* Computes f, f' and f'' of a law at y in 0..1. */
static void law_at(ovr_cam_law law, double y, double f[3])
{
    double z = 1 - y;
    switch (law) {
    case OVR_CAM_345:
        f[0] = y * y * y * (10 + y * (6 * y - 15));
        f[1] = 30 * y * y * z * z;
        f[2] = 60 * y * z * (z - y);
        return;
    case OVR_CAM_CYCLOIDAL:
        f[0] = y - sin(2 * pi * y) / (2 * pi);
        f[1] = 1 - cos(2 * pi * y);
        f[2] = 2 * pi * sin(2 * pi * y);
        return;
    case OVR_CAM_HARMONIC:
        f[0] = (1 - cos(pi * y)) / 2;
        f[1] = pi / 2 * sin(pi * y);
        f[2] = pi * pi / 2 * cos(pi * y);
        return;
    case OVR_CAM_TABLE:
    case OVR_CAM_4567: break;
    }
    f[0] = y * y * y * y * (35 - y * (84 - y * (70 - 20 * y)));
    f[1] = 140 * y * y * y * z * z * z;
    f[2] = 420 * y * y * z * z * (z - y);
}

static void by_law(const ovr_cam_form *form, double angle, double lift[3])
{
    double h = form->lift, top = form->rise + form->dwell, f[3];
    lift[0] = lift[1] = lift[2] = 0;
    if (angle < 0 || angle > top + form->fall)
        return;
    if (angle >= form->rise && angle <= top) {
        /* The ends of the dwell belong to the dwell, without acceleration. */
        lift[0] = h;
        if (form->dwell > 0)
            return;
    }
    bool rises = angle < form->rise;
    double width = rises ? form->rise : form->fall;
    law_at(form->law,
           rises ? angle / width : (top + form->fall - angle) / width, f);
    lift[0] = h * f[0];
    lift[1] = (rises ? h : -h) * f[1] / width;
    lift[2] = h * f[2] / (width * width);
}

static void by_table(const ovr_cam_form *form, const double *m, double angle,
                     double lift[3])
{
    const double *x = form->angle, *s = form->height;
    size_t low = 0, high = form->points - 1;
    lift[0] = lift[1] = lift[2] = 0;
    if (angle < x[0] || angle > x[high])
        return;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (x[middle] <= angle)
            low = middle;
        else
            high = middle;
    }
    double h = x[high] - x[low];
    double a = (x[high] - angle) / h, b = (angle - x[low]) / h;
    lift[0] = a * s[low] + b * s[high] +
              ((a * a * a - a) * m[low] + (b * b * b - b) * m[high]) * h * h /
                  6;
    lift[1] = (s[high] - s[low]) / h +
              ((3 * b * b - 1) * m[high] - (3 * a * a - 1) * m[low]) * h / 6;
    lift[2] = a * m[low] + b * m[high];
}

/* Computes s, s' and s'' at an angle measured from the beginning of the rise; 0
 * outside. */
static void lift_at(const ovr_cam_form *form, const double *bending,
                    double angle, double lift[3])
{
    if (form->law == OVR_CAM_TABLE)
        by_table(form, bending, angle, lift);
    else
        by_law(form, angle, lift);
}

/* --------------------------------------------------------------- tables */

static ovr_status check_table(const ovr_cam_form *form, ovr_error *err)
{
    double step = INFINITY, wrong;
    if (form->points < 4 || !form->angle || !form->height)
        return ovr_fail_about(err, "file",
                              "a table of lifts needs at least 4 points, has "
                              "%zu",
                              form->points);
    for (size_t k = 0; k < form->points; k++) {
        if (!isfinite(form->angle[k]) || !isfinite(form->height[k]))
            return ovr_fail_about(err, "file", "point %zu is not a number",
                                  k + 1);
        if (k && !(form->angle[k] > form->angle[k - 1]))
            return ovr_fail_about(
                err, "file", "angles must increase: point %zu does not", k + 1);
        if (k)
            step = fmin(step, form->angle[k] - form->angle[k - 1]);
    }
    wrong = 12 * form->rounding / (step * step);
    if (wrong > 0.05 * form->base_radius)
        return ovr_fail_about(
            err, "file",
            "lifts are rounded to %.3g um, which makes the radius of "
            "curvature wrong by %.3g mm; use %.2g um, or another cam.law",
            1e6 * form->rounding, 1e3 * wrong,
            1e6 * 0.05 * form->base_radius * step * step / 12);
    return OVR_OK;
}

/* Solves the tridiagonal system by Thomas's algorithm; `factor` stores the
 * upper diagonal. */
static void solve_spline(size_t n, const double *x, const double *s, double *m,
                         double *factor)
{
    m[0] = m[n - 1] = factor[0] = 0;
    for (size_t k = 1; k + 1 < n; k++) {
        double before = x[k] - x[k - 1], after = x[k + 1] - x[k];
        double right = 6 *
                       ((s[k + 1] - s[k]) / after - (s[k] - s[k - 1]) / before);
        double pivot = 2 * (before + after) - before * factor[k - 1];
        factor[k] = after / pivot;
        m[k] = (right - before * m[k - 1]) / pivot;
    }
    for (size_t k = n - 2; k > 0; k--)
        m[k] -= factor[k] * m[k + 1];
}

/* Computes the natural cubic spline of a table of lifts: its second derivatives
 * at the points. The tables of the form are replaced by copies in the arena. */
static ovr_status make_lift(ovr_cam_form *form, double **bending,
                            ovr_arena *arena, ovr_error *err)
{
    size_t n = form->points;
    ovr_status status;
    if (form->law != OVR_CAM_TABLE)
        return OVR_OK;
    if ((status = check_table(form, err)))
        return status;
    double *angle = ovr_arena_take(arena, n, sizeof *angle, err);
    double *height = ovr_arena_take(arena, n, sizeof *height, err);
    double *factor = ovr_arena_take(arena, n, sizeof *factor, err);
    *bending = ovr_arena_take(arena, n, sizeof **bending, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < n; k++) {
        angle[k] = form->angle[k];
        height[k] = form->height[k];
    }
    form->angle = angle;
    form->height = height;
    solve_spline(n, angle, height, *bending, factor);
    return OVR_OK;
}

/* --------------------------------------------------------- Cam and follower */

struct ovr_cam {
    ovr_cam_form form;
    ovr_cam_event event;
    double *bending; /* second derivatives of a table's spline */
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

/* Returns the radius of the pitch curve of a roller follower. */
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
    lift_at(f, cam->bending, angle, lift);
    m.load = force(f, lift) / f->face;
    if (f->follower == OVR_FOLLOWER_FLAT) {
        m.R = m.R_1 = f->base_radius + lift[0] + lift[2];
        m.R_2 = INFINITY;
        m.u1 = f->speed * m.R_1;
        m.u2 = f->speed * lift[2];
        return m;
    }
    double r = f->base_radius + f->roller_radius + lift[0];
    double root_q = sqrt(r * r + lift[1] * lift[1]),
           rho = pitch_radius(r, lift);
    m.R_1 = rho - f->roller_radius;
    m.R_2 = f->roller_radius;
    m.R = f->roller_radius * m.R_1 / rho;
    m.u1 = f->speed * root_q * m.R_1 / rho;
    double mean = m.u1 / (1 + f->slip / 2);
    m.u2 = mean * (1 - f->slip / 2);
    m.load *= root_q / r;
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

/* Returns the margin at an angle; the follower cannot follow if it is negative.
 * Flat follower: the cam's radius of curvature. Roller: radius of its pitch
 * curve minus roller radius, if the curve is not concave. */
static double clearance_at(const ovr_cam *cam, double angle)
{
    const ovr_cam_form *f = &cam->form;
    double lift[3];
    lift_at(f, cam->bending, angle, lift);
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
                              "the cam is concave at %.3g deg (rho = %.3g "
                              "mm), where a flat follower loses contact; set "
                              "base_radius to at least %.4g mm",
                              degrees(angle), 1e3 * clearance,
                              1e3 * (f->base_radius - clearance) * 1.001);
    return ovr_fail_about(err, "roller_radius",
                          "undercut at %.3g deg: the radius of the pitch "
                          "curve, %.3g mm, is smaller than that of the "
                          "roller, %.3g mm",
                          degrees(angle), 1e3 * (clearance + f->roller_radius),
                          1e3 * f->roller_radius);
}

/* ------------------------------------------------------------- lift event */

enum { LOOKS = 7200 };

static double sample_angle(const ovr_cam_event *e, int k)
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
        if (mean_speed(cam, sample_angle(e, k)) *
                mean_speed(cam, sample_angle(e, k + 1)) <
            0)
            e->reversal[e->reversals++] = reversal_between(
                cam, sample_angle(e, k), sample_angle(e, k + 1));
}

static ovr_status check_event(ovr_cam *cam, ovr_error *err)
{
    ovr_cam_event *e = &cam->event;
    double gone[2] = {NAN, NAN}, highest = -1, tightest = e->from;
    double minimum = clearance_at(cam, e->from);
    e->min_force = INFINITY;
    for (int k = 0; k <= LOOKS; k++) {
        double clearance = clearance_at(cam, sample_angle(e, k));
        if (clearance < minimum) {
            minimum = clearance;
            tightest = sample_angle(e, k);
        }
    }
    ovr_status status = check_shape(cam, tightest, err);
    if (status)
        return status;
    for (int k = 0; k <= LOOKS; k++) {
        double lift[3], now, angle = sample_angle(e, k);
        lift_at(&cam->form, cam->bending, angle, lift);
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
    return ovr_fail_about(
        err, "preload",
        "the follower lifts off the cam from %.3g to %.3g deg (minimum force "
        "%.3g N); increase spring preload or stiffness, or reduce the speed",
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
                              "must be between the start and the end of the "
                              "lift event, %.4g and %.4g deg",
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
        (status = make_lift(&cam->form, &cam->bending, arena, err)))
        return status;
    return make_event(cam, err);
}

ovr_cam *ovr_cam_create(const ovr_cam_form *form,
                        const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_cam *cam;
    if (!form) {
        ovr_fail(err, OVR_BAD_INPUT, "the input argument (cam) is NULL");
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
    lift_at(&cam->form, cam->bending, cam->event.from + cam->form.speed * t,
            lift);
}
