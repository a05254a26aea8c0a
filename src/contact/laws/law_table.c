/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Tables of laws: Steffen's monotone spline (Astron. Astrophys. 239, 1990)
 * through the points, with slopes from parabolas at the ends. Value and slope
 * are sampled on a uniform grid of size h, on which the kernels use cubics. In
 * an interval without a point the cubic equals the spline; with a point it
 * differs by less than h^2/16 times the jump of the second derivative.
 */
#include "contact/laws/law_table.h"
#include "base/given.h"
#include "contact/oil.h"

#include <math.h>

enum { CELLS = 1024, MAX = 100000 };
static const double FIRST_MAX = 1e6; /* maximum pressure that is considered
                                      * ambient */

static ovr_status check_points(size_t n, const double *p, const double *value,
                               ovr_error *err)
{
    if (n < 2 || n > MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the table has %zu points; needs 2 to %d", n, MAX);
    for (size_t i = 0; i < n; i++) {
        if (!(isfinite(p[i]) && value[i] > 0 && isfinite(value[i])))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "point %zu: values must be positive numbers",
                            i + 1);
        if (i && !(p[i] > p[i - 1]))
            return ovr_fail(err, OVR_BAD_INPUT,
                            "point %zu: pressures must increase", i + 1);
        if (i && value[i] < value[i - 1])
            return ovr_fail(err, OVR_BAD_INPUT,
                            "point %zu: %g follows %g, but it must not fall "
                            "with pressure",
                            i + 1, value[i], value[i - 1]);
    }
    if (p[0] >= 0 && p[0] <= FIRST_MAX)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "the first pressure, %g Pa, must be ambient: 0 to 1 MPa",
                    p[0]);
}

/* Slope at an end from the parabola through the last three points, limited such
 * that it keeps the sign and is at most twice the slope of the last interval.
 */
static double end_slope(double h0, double s0, double h1, double s1)
{
    double parabola = s0 + (s0 - s1) * h0 / (h0 + h1);
    return fmax(0, fmin(parabola, 2 * s0));
}

static double inner_slope(double h0, double s0, double h1, double s1)
{
    double parabola = (s0 * h1 + s1 * h0) / (h0 + h1);
    return fmin(2 * fmin(s0, s1), parabola);
}

/* Steffen's slopes of non-decreasing values y. */
static void make_slopes(size_t n, const double *p, const double *y, double *m)
{
    double before = p[1] - p[0], rise = (y[1] - y[0]) / before;
    m[0] = m[1] = rise;
    for (size_t i = 1; i + 1 < n; i++) {
        double h = p[i + 1] - p[i], s = (y[i + 1] - y[i]) / h;
        if (i == 1)
            m[0] = end_slope(before, rise, h, s);
        m[i] = inner_slope(before, rise, h, s);
        m[i + 1] = end_slope(h, s, before, rise);
        before = h;
        rise = s;
    }
}

/* The spline; linear below its first point. */
typedef struct spline {
    size_t n, at; /* number of points; interval used last */
    const double *p, *y;
    double *m;
} spline;

static double value_at(spline *c, double p, double *slope)
{
    double h, f, g, rise, d, d1;
    size_t k;
    *slope = c->m[0];
    if (p < c->p[0])
        return c->y[0] - c->m[0] * (c->p[0] - p);
    while (c->at + 2 < c->n && p > c->p[c->at + 1])
        c->at++;
    k = c->at;
    h = c->p[k + 1] - c->p[k];
    f = (p - c->p[k]) / h;
    g = 1 - f;
    rise = c->y[k + 1] - c->y[k];
    d = h * c->m[k] - rise;
    d1 = h * c->m[k + 1] - rise;
    *slope = (rise + (g - f) * (g * d - f * d1) - f * g * (d + d1)) / h;
    return c->y[k] + f * rise + f * g * (g * d - f * d1);
}

static void fill(ovr_law_table *t, ovr_table_of what, spline *c)
{
    double slope, start = value_at(c, 0, &slope);
    t->ambient = what == OVR_TABLE_OF_VISCOSITY ? exp(start) : start;
    for (size_t k = 0; k <= t->cells; k++) {
        double at = fmin((double)k * t->mesh, c->p[c->n - 1]);
        t->value[k] = value_at(c, at, &slope);
        t->slope[k] = t->mesh * slope;
        if (what == OVR_TABLE_OF_VISCOSITY) {
            t->value[k] -= start;
        } else {
            t->value[k] /= start;
            t->slope[k] /= start;
        }
    }
    t->value[t->cells + 1] = t->value[t->cells] + t->slope[t->cells];
    t->slope[t->cells + 1] = t->slope[t->cells];
}

static ovr_status make(ovr_law_table *t, const ovr_law_points *of,
                       ovr_error *err)
{
    size_t n = of->n;
    double *y = ovr_arena_take(&t->arena, n, sizeof *y, err);
    double *m = ovr_arena_take(&t->arena, n, sizeof *m, err);
    t->cells = CELLS;
    t->mesh = of->p[n - 1] / CELLS;
    t->value = ovr_arena_take(&t->arena, CELLS + 2, sizeof *y, err);
    t->slope = ovr_arena_take(&t->arena, CELLS + 2, sizeof *y, err);
    if (ovr_arena_status(&t->arena))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        y[i] = of->of == OVR_TABLE_OF_VISCOSITY ? log(of->value[i])
                                                : of->value[i];
    make_slopes(n, of->p, y, m);
    fill(t, of->of, &(spline){n, 0, of->p, y, m});
    return OVR_OK;
}

ovr_law_table *ovr_law_table_create(const ovr_law_points *points,
                                    const ovr_allocator *allocator,
                                    ovr_error *err)
{
    if (!points || !points->p || !points->value)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_law_table *table;
    if (check_points(points->n, points->p, points->value, err))
        return NULL;
    table = ovr_arena_take(&arena, 1, sizeof *table, err);
    if (!table)
        return NULL;
    table->arena = arena;
    if (!make(table, points, err))
        return table;
    ovr_law_table_free(table);
    return NULL;
}

void ovr_law_table_free(ovr_law_table *table)
{
    if (table) {
        ovr_arena arena = table->arena;
        ovr_arena_release(&arena);
    }
}
