/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/material_ratio.h"

#include <math.h>
#include <stdlib.h>

static int by_height(const void *one, const void *other)
{
    double a = ((const ovr_height *)one)->z, b = ((const ovr_height *)other)->z;
    return (a < b) - (a > b);
}

/* The curve is linear between the middles of the lengths; there a height's
 * `length` is the ratio. */
static void make_curve(size_t n, ovr_height *at)
{
    double whole = 0, above = 0;
    qsort(at, n, sizeof *at, by_height);
    for (size_t i = 0; i < n; i++)
        whole += at[i].length;
    for (size_t i = 0; i < n; i++) {
        double part = at[i].length / whole;
        at[i].length = above + part / 2;
        above += part;
    }
}

/* The height at a ratio, and the ratio at a height. */
static double height_at(size_t n, const ovr_height *at, double ratio)
{
    size_t low = 0, high = n - 1;
    if (ratio <= at[low].length)
        return at[low].z;
    if (ratio >= at[high].length)
        return at[high].z;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (at[middle].length <= ratio)
            low = middle;
        else
            high = middle;
    }
    return at[low].z + (at[high].z - at[low].z) * (ratio - at[low].length) /
                           (at[high].length - at[low].length);
}

static double ratio_at(size_t n, const ovr_height *at, double z)
{
    size_t i = 0;
    if (z >= at[0].z)
        return 0;
    while (i < n && at[i].z > z)
        i++;
    if (i == n)
        return 1;
    return at[i].length + (at[i - 1].length - at[i].length) * (z - at[i].z) /
                              (at[i - 1].z - at[i].z);
}

static const double CENTRAL = 0.4;

/* Finds where the flattest secant begins. */
static double flattest(size_t n, const ovr_height *at)
{
    double best = INFINITY, from = 0;
    for (size_t i = 0; i < n && at[i].length + CENTRAL <= 1; i++) {
        double falls = at[i].z - height_at(n, at, at[i].length + CENTRAL);
        if (falls < best) {
            best = falls;
            from = at[i].length;
        }
    }
    return from;
}

/* The line of least squares over the central part: its heights at 0 and 1. */
static void fit(size_t n, const ovr_height *at, double from, double line[2])
{
    enum { PARTS = 4000 };
    const double step = CENTRAL / PARTS;
    double mean = 0, moment = 0, slope;
    for (int k = 0; k < PARTS; k++) {
        double u = (k + 0.5) * step, z = height_at(n, at, from + u);
        mean += z / PARTS;
        moment += z * (u - CENTRAL / 2) * step;
    }
    slope = moment * 12 / (CENTRAL * CENTRAL * CENTRAL);
    line[0] = mean - slope * (from + CENTRAL / 2);
    line[1] = line[0] + slope;
}

/* The area between the curve and a height, above it. */
static double area_above(size_t n, const ovr_height *at, double z)
{
    double area = 0, ratio = 0, high = fmax(at[0].z - z, 0);
    for (size_t i = 0; i < n && at[i].z > z; i++) {
        area += (at[i].length - ratio) * (high + at[i].z - z) / 2;
        ratio = at[i].length;
        high = at[i].z - z;
    }
    return area + (ratio_at(n, at, z) - ratio) * high / 2;
}

static double area_below(size_t n, const ovr_height *at, double z)
{
    double area = 0, ratio = 1, deep = fmax(z - at[n - 1].z, 0);
    for (size_t i = n; i-- > 0 && at[i].z < z;) {
        area += (ratio - at[i].length) * (deep + z - at[i].z) / 2;
        ratio = at[i].length;
        deep = z - at[i].z;
    }
    return area + (ratio - ratio_at(n, at, z)) * deep / 2;
}

ovr_core ovr_material_ratio(size_t n, ovr_height *heights)
{
    ovr_height *at = heights;
    double line[2];
    ovr_core core = {0};
    make_curve(n, at);
    fit(n, at, flattest(n, at), line);
    core.k = fmax(line[0] - line[1], 0); /* rounding of a plateau */
    core.mr1 = ratio_at(n, at, line[0]);
    core.mr2 = ratio_at(n, at, line[1]);
    if (core.mr1 > 0)
        core.pk = 2 * area_above(n, at, line[0]) / core.mr1;
    if (core.mr2 < 1)
        core.vk = 2 * area_below(n, at, line[1]) / (1 - core.mr2);
    return core;
}
