/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Laws of lift s = h f(y), y the part of the rise that has passed; the fall is
 * the law backwards.  Tables go through the natural cubic spline, whose second
 * derivative is continuous: that is the curvature of the cam, and what counts.
 * Its coefficients solve the tridiagonal equations
 *   h_{k-1} m_{k-1} + 2 (h_{k-1} + h_k) m_k + h_k m_{k+1}
 *       = 6 ((s_{k+1} - s_k)/h_k - (s_k - s_{k-1})/h_{k-1}),  m_0 = m_{n-1} = 0
 * Heights rounded to r give second derivatives wrong by up to 12 r/step^2 (the
 * largest row sum of the inverse, 2, times the difference quotient's 6).
 */
#include "elements/lift.h"
#include "base/error.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* f, f' and f'' of a law at y in 0..1. */
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
        /* The joints belong to the dwell, where nothing accelerates. */
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

void ovr_lift_at(const ovr_cam_form *form, const double *bending, double angle,
                 double lift[3])
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
            "lifts are rounded to %.3g um: the curvature they give is off by "
            "%.3g mm; give %.2g um or a law",
            1e6 * form->rounding, 1e3 * wrong,
            1e6 * 0.05 * form->base_radius * step * step / 12);
    return OVR_OK;
}

/* Thomas's algorithm, with `factor` for the upper diagonal. */
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

ovr_status ovr_lift_make(ovr_cam_form *form, double **bending, ovr_arena *arena,
                         ovr_error *err)
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
    if (!angle || !height || !factor || !*bending)
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
