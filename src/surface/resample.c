/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Anti-aliasing and band-limited interpolation of a profile.
 *
 *   1. Points at unequal distances are interpolated by GSL's natural spline to
 *      equal distances d (the mean distance, or the smallest if that is not
 *      below 1/8 of the mean).
 *   2. A windowed sinc interpolates the profile between the points,
 *          z(s) = sum_j z_j w_j / sum_j w_j,
 *          w_j = sinc(2 fc u) B(u/W),  u = s - s_j,
 *      B the four-term Blackman-Harris window (side lobes -92 dB; Harris,
 *      Proc. IEEE 66, 1978). If the profile is coarser than the grid, fc is
 *      the profile's Nyquist frequency 1/(2 d), and the samples are reproduced.
 *      If it is finer, fc = 0.875/(2 D) and W = 24 D, so that wavelengths above
 *      2.7 D pass and those below 2 D vanish. Beyond its ends the profile is
 *      continued by point reflection at its end points.
 *   3. The table has 4 entries for each max(d, D). Its cubic spline has an
 *      error of 1e-4 of the amplitude for the shortest wave, and much less for
 *      longer waves.
 *
 * Cost about 200 n. A profile shorter than the mesh size is rejected, because
 * the filter would remove all of it.
 */
#include "surface/resample.h"

#include <math.h>
#include <string.h>

#include "surface/conditioning.h"
#include "surface/feature.h"
#include "surface/profile.h"

static const double PI = 3.14159265358979323846;

typedef struct series {
    size_t n;
    double d;        /* distance between samples */
    const double *z; /* heights */
    double fc, reach;
    bool closed;
} series;

/* ------------------------------------------------------- 1. equal spacing */

static double equal_distance(size_t n, const double *x)
{
    double mean = (x[n - 1] - x[0]) / (double)(n - 1), minimum = mean;
    for (size_t i = 1; i < n; i++)
        minimum = fmin(minimum, x[i] - x[i - 1]);
    return minimum > 0.98 * mean ? mean : fmax(minimum, mean / 8);
}

static double length_of(const ovr_points *p)
{
    return p->x[p->n - 1] - p->x[0];
}

static ovr_status make_equal(const ovr_points *p, series *s, ovr_arena *arena,
                             ovr_error *err)
{
    double length = length_of(p), d = equal_distance(p->n, p->x);
    size_t m = (size_t)ceil(length / d - 1e-6) + 1;
    double *at = ovr_arena_take(arena, m, sizeof *at, err);
    double *out = ovr_arena_take(arena, m, sizeof *out, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    s->n = m;
    s->d = length / (double)(m - 1);
    s->z = out;
    for (size_t k = 0; k < m; k++)
        at[k] = p->x[0] + length * (double)k / (double)(m - 1);
    return ovr_spline_resample(p, m, at, &arena->allocator, out, err);
}

/* ---------------------------------------------------------------- 2. sinc */

/* Returns z_j for any j: point-reflected at the ends repeatedly, or
 * periodic. */
static double sample(const series *s, ptrdiff_t j)
{
    ptrdiff_t last = s->n > 2 ? (ptrdiff_t)s->n - 1 : 1;
    double add = 0, sign = 1;
    if (s->closed)
        return s->z[(j % last + last) % last];
    while (j < 0 || j > last) {
        double end = j < 0 ? s->z[0] : s->z[last];
        add += sign * 2 * end;
        sign = -sign;
        j = j < 0 ? -j : 2 * last - j;
    }
    return add + sign * s->z[j];
}

double ovr_windowed_sinc(double u, double fc, double reach)
{
    double c = cos(PI * u / reach), phase = 2 * PI * fc * u;
    double window = 0.35875 + 0.48829 * c + 0.14128 * (2 * c * c - 1) +
                    0.01168 * (4 * c * c - 3) * c;
    return window * (fabs(phase) < 1e-9 ? 1 : sin(phase) / phase);
}

static double band_limited(const series *s, double at)
{
    ptrdiff_t first = (ptrdiff_t)ceil((at - s->reach) / s->d);
    ptrdiff_t last = (ptrdiff_t)floor((at + s->reach) / s->d);
    double sum = 0, weights = 0;
    for (ptrdiff_t j = first; j <= last; j++) {
        double w = ovr_windowed_sinc(at - (double)j * s->d, s->fc, s->reach);
        sum += w * sample(s, j);
        weights += w;
    }
    return sum / weights;
}

static double variance(size_t n, const double *z)
{
    double sum = 0, square = 0;
    for (size_t i = 0; i < n; i++)
        sum += z[i];
    for (size_t i = 0; i < n; i++)
        square += (z[i] - sum / (double)n) * (z[i] - sum / (double)n);
    return square / (double)n;
}

/* Returns the interval at which samples are evaluated for the removed variance,
 * so that the total cost is about 1000 n. */
static size_t sampling(const series *s)
{
    double window = 2 * s->reach / s->d;
    size_t step = s->n > 4096 ? s->n / 2048 : 1;
    size_t cheap = (size_t)fmin(window / 1000, (double)s->n / 16);
    return cheap > step ? cheap : step;
}

/* Returns the filtered height at sample j; weight[k] is that of samples j - k
 * and j + k. */
static double filtered(const series *s, ptrdiff_t j, ptrdiff_t reach,
                       const double *weight)
{
    double sum = weight[0] * sample(s, j), weights = weight[0];
    for (ptrdiff_t k = 1; k <= reach; k++) {
        sum += weight[k] * (sample(s, j - k) + sample(s, j + k));
        weights += 2 * weight[k];
    }
    return sum / weights;
}

/* Computes the fraction of the variance that is filtered out. */
static ovr_status find_lost(const series *s, ovr_table *table,
                            ovr_arena *scratch, ovr_error *err)
{
    size_t step = sampling(s);
    ptrdiff_t reach = (ptrdiff_t)floor(s->reach / s->d);
    double total = variance(s->n, s->z), lost = 0, count = 0;
    double *weight = ovr_arena_take(scratch, (size_t)reach + 1, sizeof *weight,
                                    err);
    if (!weight)
        return OVR_NO_MEMORY;
    for (ptrdiff_t k = 0; k <= reach; k++)
        weight[k] = ovr_windowed_sinc((double)k * s->d, s->fc, s->reach);
    for (size_t j = 0; j < s->n; j += step, count++) {
        double r = s->z[j] - filtered(s, (ptrdiff_t)j, reach, weight);
        lost += r * r;
    }
    table->lost = total > 0 ? lost / count / total : 0;
    table->work = 2 * (double)reach * count;
    return OVR_OK;
}

/* --------------------------------------------------------------- 3. table */

/* Checks the treatment of the ends, and computes the length of the table
 * without mirror images. */
static ovr_status check_ends(const ovr_ends *ends, double length, double *taper,
                             ovr_error *err)
{
    double maximum = length / 2;
    *taper = isnan(ends->taper) ? 0.05 * length : ends->taper;
    if (*taper >= 0 && *taper <= maximum)
        return OVR_OK;
    return ovr_about(
        err, "taper",
        ovr_fail(err, OVR_BAD_INPUT,
                 "taper = %g b must be between 0 and half the profile's "
                 "length, %g b",
                 *taper, maximum));
}

/* Returns a height of the periodic profile; its end is blended with its
 * beginning. */
static double height(const series *s, const ovr_ends *ends, double taper,
                     double length, double at)
{
    double v = taper > 0 ? at / taper : 2, z = band_limited(s, at);
    double w = taper > 0 ? (length - at) / taper : 2;
    if (ends->extend == OVR_EXTEND_MIRROR)
        return z;
    if (ends->extend == OVR_EXTEND_NONE)
        return z * ovr_smoothstep(v) * ovr_smoothstep(w);
    if (v >= 1)
        return z;
    return ovr_smoothstep(v) * z +
           (1 - ovr_smoothstep(v)) * band_limited(s, length - taper + at);
}

static ovr_status tabulate(const series *s, const ovr_ends *ends, double mesh,
                           ovr_table *table, ovr_arena *arena, ovr_error *err)
{
    bool mirror = ends->extend == OVR_EXTEND_MIRROR;
    double length = (double)(s->n - 1) * s->d, taper, span, entries;
    ovr_status status = check_ends(ends, length, &taper, err);
    size_t m;
    if (status)
        return status;
    table->fade = taper;
    if (ends->extend == OVR_EXTEND_PERIODIC && ends->closed)
        taper = 0;
    span = ends->extend == OVR_EXTEND_PERIODIC ? length - taper : length;
    entries = ceil(4 * span / fmax(s->d, mesh));
    if (!(entries < OVR_POINTS_MAX / 2.0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the profile is too long for the grid and needs a "
                        "table of %g points",
                        entries);
    m = entries < 8 ? 8 : (size_t)entries;
    table->n = (mirror ? 2 * m : m) + 1;
    table->h = span / (double)m;
    table->endless = ends->extend != OVR_EXTEND_NONE;
    table->both = ends->both && table->endless;
    table->z = ovr_arena_take(arena, table->n, sizeof *table->z, err);
    if (!table->z)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k <= m; k++)
        table->z[k] = height(s, ends, taper, length, (double)k * table->h);
    table->work += (double)m * 2 * s->reach / s->d * (OVR_SINC_WORK + 1);
    for (size_t k = 1; mirror && k <= m; k++)
        table->z[m + k] = table->z[m - k];
    if (table->endless)
        table->z[table->n - 1] = table->z[0];
    return ovr_table_prepare(table, arena, err);
}

ovr_status ovr_resample(const ovr_points *profile, double mesh,
                        const ovr_ends *ends, ovr_table *table,
                        ovr_arena *arena, ovr_error *err)
{
    double length = length_of(profile);
    if (!(length >= mesh))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the profile is %g b long, shorter than the mesh "
                        "size of %g b, so that the grid does not resolve it",
                        length, mesh);
    ovr_arena scratch = ovr_arena_make(&arena->allocator);
    series s = {.closed = ends->closed};
    ovr_status status = make_equal(profile, &s, &scratch, err);
    if (!status) {
        s.fc = fmin(0.5 / s.d, 0.875 * 0.5 / mesh);
        s.reach = 24 * fmax(s.d, mesh);
        status = find_lost(&s, table, &scratch, err);
    }
    if (!status)
        status = tabulate(&s, ends, mesh, table, arena, err);
    ovr_arena_release(&scratch);
    return status;
}
