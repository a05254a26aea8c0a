/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/spline.h"

#include <math.h>

#include "base/interpolation.h"
#include "surface/feature.h"

static ovr_status check(const ovr_points *of, ovr_error *err)
{
    const double *x = of->x, *y = of->y;
    if (of->n < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a spline needs two points, there are %zu", of->n);
    for (size_t i = 0; i < of->n; i++)
        if (!isfinite(x[i]) || !isfinite(y[i]) || (i && !(x[i] > x[i - 1])))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "a spline needs finite points with increasing x; "
                            "point %zu is (%g, %g)",
                            i + 1, x[i], y[i]);
    return OVR_OK;
}

/* GSL allocates its memory by malloc, about 5 n doubles. The same amount is
 * first requested from the allocator, so that its limits apply. */
static ovr_status enough_memory(size_t n, const ovr_allocator *allocator,
                                ovr_error *err)
{
    ovr_arena probe = ovr_arena_make(allocator);
    bool enough = ovr_arena_take(&probe, n + 16, 6 * sizeof(double), err);
    ovr_arena_release(&probe);
    return enough ? OVR_OK : OVR_NO_MEMORY;
}

/* Chooses linear interpolation for two points, a spline for more. */
static ovr_status make(const ovr_points *of, bool periodic,
                       const ovr_allocator *allocator, gsl_interp **spline,
                       ovr_error *err)
{
    ovr_status status = check(of, err);
    if (!status)
        status = enough_memory(of->n, allocator, err);
    if (status)
        return status;
    *spline = ovr_interpolation(of->n < 3  ? gsl_interp_linear
                                : periodic ? gsl_interp_cspline_periodic
                                           : gsl_interp_cspline,
                                of->n, of->x, of->y, err);
    return *spline ? OVR_OK : OVR_NO_MEMORY;
}

/* Computes the second derivatives y2 at x of the cubic spline through n >= 2
 * points. The spline is natural or, with y[n-1] = y[0], periodic. x must
 * increase and all values be finite. */
static ovr_status spline_second(const ovr_points *of, bool periodic,
                                const ovr_allocator *allocator, double *y2,
                                ovr_error *err)
{
    gsl_interp *spline = NULL;
    gsl_interp_accel near = {0};
    ovr_status status = make(of, periodic, allocator, &spline, err);
    if (status)
        return status;
    for (size_t i = 0; i < of->n; i++)
        y2[i] = of->n < 3 ? 0
                          : gsl_interp_eval_deriv2(spline, of->x, of->y,
                                                   of->x[i], &near);
    gsl_interp_free(spline);
    return OVR_OK;
}

ovr_status ovr_spline_resample(const ovr_points *of, size_t m, const double *at,
                               const ovr_allocator *allocator, double *out,
                               ovr_error *err)
{
    gsl_interp *spline = NULL;
    gsl_interp_accel near = {0};
    ovr_status status = make(of, false, allocator, &spline, err);
    if (status)
        return status;
    for (size_t k = 0; k < m; k++) {
        double a = fmin(fmax(at[k], of->x[0]), of->x[of->n - 1]);
        out[k] = gsl_interp_eval(spline, of->x, of->y, a, &near);
    }
    gsl_interp_free(spline);
    return OVR_OK;
}

/* ------------------------------------------------------ tables of heights */

ovr_status ovr_table_prepare(ovr_table *table, ovr_arena *arena, ovr_error *err)
{
    size_t n = table->n;
    double *x = ovr_arena_take(arena, n, sizeof *x, err);
    ovr_status status;
    table->c = ovr_arena_take(arena, n, sizeof *table->c, err);
    if (!x || !table->c)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        x[i] = (double)i;
    status = spline_second(&(ovr_points){n, x, table->z}, table->endless,
                           &arena->allocator, table->c, err);
    for (size_t i = 0; i < n; i++)
        table->c[i] /= 6; /* x is in units of h */
    return status;
}

double ovr_table_length(const ovr_table *table)
{
    return (double)(table->n - 1) * table->h;
}

static double spline(const ovr_table *table, double s)
{
    double u = s / table->h, t, r;
    size_t i = u > 0 ? (size_t)u : 0;
    if (i > table->n - 2)
        i = table->n - 2;
    t = u - (double)i;
    r = 1 - t;
    return r * table->z[i] + t * table->z[i + 1] +
           r * (r * r - 1) * table->c[i] + t * (t * t - 1) * table->c[i + 1];
}

double ovr_table_height(const ovr_table *table, double s)
{
    double length = ovr_table_length(table), fade = 1;
    if (!table->endless)
        return s >= 0 && s <= length ? spline(table, s) : 0;
    if (!table->both && s >= length)
        return 0;
    if (!table->both && table->fade > 0)
        fade = ovr_smoothstep((length - s) / table->fade);
    return fade * spline(table, s - length * floor(s / length));
}
