/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/spline.h"

#include <math.h>

#include "base/interpolation.h"

static ovr_status check(size_t n, const double *x, const double *y,
                        ovr_error *err)
{
    if (n < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a spline needs two points, there are %zu", n);
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]) || !isfinite(y[i]) || (i && !(x[i] > x[i - 1])))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "a spline needs finite points with increasing x; "
                            "point %zu is (%g, %g)",
                            i + 1, x[i], y[i]);
    return OVR_OK;
}

/* GSL takes its own memory from malloc (about 5 n doubles): the hook is asked
 * for as much first, so that its limits count. */
static ovr_status enough_memory(size_t n, const ovr_allocator *allocator,
                                ovr_error *err)
{
    ovr_arena probe = ovr_arena_make(allocator);
    bool enough = ovr_arena_take(&probe, n + 16, 6 * sizeof(double), err);
    ovr_arena_release(&probe);
    return enough ? OVR_OK : OVR_NO_MEMORY;
}

/* Two points have a straight line, three or more a spline. */
static const gsl_interp_type *kind(size_t n, bool periodic)
{
    if (n < 3)
        return gsl_interp_linear;
    return periodic ? gsl_interp_cspline_periodic : gsl_interp_cspline;
}

static ovr_status make(size_t n, const double *x, const double *y,
                       bool periodic, const ovr_allocator *allocator,
                       gsl_interp **spline, ovr_error *err)
{
    ovr_status status = check(n, x, y, err);
    if (!status)
        status = enough_memory(n, allocator, err);
    if (status)
        return status;
    *spline = ovr_interpolation(kind(n, periodic), n, x, y, err);
    return *spline ? OVR_OK : OVR_NO_MEMORY;
}

ovr_status ovr_spline_second(size_t n, const double *x, const double *y,
                             bool periodic, const ovr_allocator *allocator,
                             double *y2, ovr_error *err)
{
    gsl_interp *spline = NULL;
    gsl_interp_accel near = {0};
    ovr_status status = make(n, x, y, periodic, allocator, &spline, err);
    if (status)
        return status;
    for (size_t i = 0; i < n; i++)
        y2[i] = n < 3 ? 0 : gsl_interp_eval_deriv2(spline, x, y, x[i], &near);
    gsl_interp_free(spline);
    return OVR_OK;
}

ovr_status ovr_spline_resample(size_t n, const double *x, const double *y,
                               size_t m, const double *at,
                               const ovr_allocator *allocator, double *out,
                               ovr_error *err)
{
    gsl_interp *spline = NULL;
    gsl_interp_accel near = {0};
    ovr_status status = make(n, x, y, false, allocator, &spline, err);
    if (status)
        return status;
    for (size_t k = 0; k < m; k++) {
        double a = fmin(fmax(at[k], x[0]), x[n - 1]);
        out[k] = gsl_interp_eval(spline, x, y, a, &near);
    }
    gsl_interp_free(spline);
    return OVR_OK;
}
