/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/profile_table.h"

#include <math.h>

#include "surface/feature.h"
#include "surface/spline.h"

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
    status = ovr_spline_second(&(ovr_points){n, x, table->z}, table->endless,
                               &arena->allocator, table->c, err);
    for (size_t i = 0; i < n; i++)
        table->c[i] /= 6; /* x in units of h already */
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
