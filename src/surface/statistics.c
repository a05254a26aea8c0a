/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computes height, slope and wavelength parameters of a profile. */
#include "surface/statistics.h"

#include <gsl/gsl_fft_real.h>
#include <math.h>
#include <stdlib.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/conditioning.h"
#include "surface/profile.h"
#include "surface/spline.h"

/* ----------------------------------------------------------- material ratio */

static int by_height(const void *one, const void *other)
{
    double a = ((const ovr_height *)one)->z, b = ((const ovr_height *)other)->z;
    return (a < b) - (a > b);
}

/* Sorts the heights and computes the material ratio curve, which is linear
 * between the midpoints of their lengths. `length` of each height becomes its
 * ratio. */
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

/* Returns the height at a ratio; the ratio at a height. */
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

/* Returns the ratio at which the secant with the smallest slope begins. */
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

/* Fits a line to the central part by least squares; returns its heights at 0
 * and 1. */
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

/* Returns the area between the curve and a height z, above z. */
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
    core.k = fmax(line[0] - line[1], 0); /* a plateau may have a slope from
                                          * rounding */
    core.mr1 = ratio_at(n, at, line[0]);
    core.mr2 = ratio_at(n, at, line[1]);
    if (core.mr1 > 0)
        core.pk = 2 * area_above(n, at, line[0]) / core.mr1;
    if (core.mr2 < 1)
        core.vk = 2 * area_below(n, at, line[1]) / (1 - core.mr2);
    return core;
}

enum { SECTIONS = 5 };          /* by the standard */
static const double EPS = 1e-9; /* rounding errors of lengths */

static ovr_status whole(const ovr_profile *p, ovr_error *err)
{
    size_t missing = 0;
    for (size_t i = 0; i < p->view.n; i++)
        missing += isnan(p->z[i]) ? 1 : 0;
    return missing ? ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%zu heights are missing; fill the gaps "
                                 "first",
                                 missing)
                   : OVR_OK;
}

/* ---------------------------------------------------------------- numbers */

static void measure_lengths(const ovr_profile *p, ovr_profile_numbers *r)
{
    size_t n = r->n = p->view.n;
    r->length = p->x[n - 1] - p->x[0];
    r->spacing = r->length / (double)(n - 1);
    r->spacing_min = r->spacing_max = p->x[1] - p->x[0];
    for (size_t i = 1; i < n; i++) {
        double d = p->x[i] - p->x[i - 1];
        r->spacing_min = fmin(r->spacing_min, d);
        r->spacing_max = fmax(r->spacing_max, d);
    }
}

/* The points that are evaluated: all, or those of the middle five section
 * lengths. Each point represents one spacing, also the outer ones: 4000 points
 * at 1 um are five times 0.8 mm. */
typedef struct part {
    const double *x, *z; /* start of the evaluated part */
    size_t n;
    double from; /* start of the first section */
} part;

static part find_part(const ovr_profile *p, ovr_profile_numbers *r)
{
    part w = {p->x, p->z, r->n, p->x[0]};
    double lc = p->view.lambda_c, end;
    r->kind = isnan(lc) ? 'P' : 'R';
    r->sections = 1;
    r->section = r->length;
    if (isnan(lc) || lc > r->length + r->spacing)
        return w;
    r->sections = (int)fmin(SECTIONS,
                            (r->length + r->spacing) / lc * (1 + EPS));
    r->section = lc;
    w.from = p->x[0] + (r->length - r->sections * lc) / 2;
    end = w.from + r->sections * lc;
    while (w.n > 2 && *w.x < w.from)
        w.x++, w.z++, w.n--;
    while (w.n > 2 && w.x[w.n - 1] >= end)
        w.n--;
    return w;
}

static void measure_heights(const part *w, ovr_profile_numbers *r)
{
    double m1 = 0, m2 = 0, m3 = 0, m4 = 0, length = w->x[w->n - 1] - w->x[0];
    for (size_t i = 0; i < w->n; i++)
        r->mean += w->z[i] * ovr_share(w->n, w->x, i) / length;
    for (size_t i = 0; i < w->n; i++) {
        double share = ovr_share(w->n, w->x, i) / length;
        double z = w->z[i] - r->mean;
        m1 += share * fabs(z);
        m2 += share * z * z;
        m3 += share * z * z * z;
        m4 += share * z * z * z * z;
    }
    r->a = m1;
    r->q = sqrt(m2);
    r->sk = m2 > 0 ? m3 / m2 / r->q : NAN;
    r->ku = m2 > 0 ? m4 / m2 / m2 : NAN;
}

/* Computes the highest peak and deepest valley of each section, their means,
 * and the extremes of all sections. */
static void measure_peaks(const part *w, ovr_profile_numbers *r)
{
    double top[SECTIONS], bottom[SECTIONS], high = -INFINITY, low = INFINITY;
    int parts = 0;
    for (int k = 0; k < r->sections; k++)
        top[k] = -INFINITY, bottom[k] = INFINITY;
    for (size_t i = 0; i < w->n; i++) {
        double at = (w->x[i] - w->from) / r->section;
        int k = (int)fmax(0, fmin(r->sections - 1, floor(at + EPS)));
        top[k] = fmax(top[k], w->z[i] - r->mean);
        bottom[k] = fmin(bottom[k], w->z[i] - r->mean);
    }
    for (int k = 0; k < r->sections; k++) {
        if (top[k] < bottom[k])
            continue; /* section without points */
        r->p += top[k];
        r->v -= bottom[k];
        high = fmax(high, top[k]);
        low = fmin(low, bottom[k]);
        parts++;
    }
    r->p /= parts;
    r->v /= parts;
    r->z = r->p + r->v;
    r->t = high - low;
}

static double rms_slope(const part *w)
{
    double sum = 0;
    for (size_t i = 1; i < w->n; i++) {
        double d = w->x[i] - w->x[i - 1], rise = w->z[i] - w->z[i - 1];
        sum += rise * rise / d;
    }
    return sqrt(sum / (w->x[w->n - 1] - w->x[0]));
}

static ovr_status measure_core(const part *w, const ovr_allocator *allocator,
                               ovr_profile_numbers *r, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_height *heights = ovr_arena_take(&arena, w->n, sizeof *heights, err);
    ovr_core core;
    if (!heights)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < w->n; i++)
        heights[i] = (ovr_height){w->z[i], ovr_share(w->n, w->x, i)};
    core = ovr_material_ratio(w->n, heights);
    r->k = core.k;
    r->pk = core.pk;
    r->vk = core.vk;
    r->mr1 = core.mr1;
    r->mr2 = core.mr2;
    ovr_arena_release(&arena);
    return OVR_OK;
}

ovr_status ovr_profile_measure(const ovr_profile *profile,
                               ovr_profile_numbers *numbers, ovr_error *err)
{
    if (!profile)
        return ovr_fail_null(err, __func__);
    ovr_profile_numbers made = {0};
    ovr_status status = ovr_check_output_argument(numbers,
                                                  "ovr_profile_numbers", err);
    part w;
    if (status)
        return status;
    status = whole(profile, err);
    if (!status) {
        measure_lengths(profile, &made);
        w = find_part(profile, &made);
        measure_heights(&w, &made);
        measure_peaks(&w, &made);
        made.dq = rms_slope(&w);
        status = measure_core(&w, &profile->arena.allocator, &made, err);
    }
    *numbers = made;
    return status;
}

double ovr_profile_cutoff(double length)
{
    static const double series[] = {8e-3, 2.5e-3, 0.8e-3, 0.25e-3, 0.08e-3};
    for (size_t k = 0; k < sizeof series / sizeof series[0]; k++)
        if (SECTIONS * series[k] <= length * (1 + EPS))
            return series[k];
    return NAN;
}

/* ------------------------------------------------------------------ waves */

/*
 * Spectrum of the profile without its regression line, interpolated at N = 2^m
 * equidistant points and multiplied by the Hann window w: |F_k|^2 for k waves
 * in N steps. A cosine of amplitude A gives a peak of height A sum(w)/2, three
 * bins wide. The position of a peak is refined by the ratio of its higher
 * neighbour (exact for Hann):
 *
 *     delta = (2 a - 1)/(a + 1), a = |F_{k+-1}|/|F_k|.
 */
typedef struct spectrum {
    size_t n;
    size_t finest; /* wave number above which the spectrum is an artefact of the
                    * spline */
    double step;
    double *power; /* n/2 elements */
} spectrum;

static ovr_status transform(const ovr_profile *p, spectrum *s, ovr_arena *arena,
                            ovr_error *err)
{
    size_t points = p->view.n;
    double length = p->x[points - 1] - p->x[0];
    double *z, *at, *work;
    ovr_status status;
    for (s->n = 64; s->n < points && s->n < 1 << 20;)
        s->n *= 2;
    z = ovr_arena_take(arena, s->n, sizeof *z, err);
    at = ovr_arena_take(arena, s->n, sizeof *at, err);
    work = ovr_arena_take(arena, s->n, 3 * sizeof *work, err);
    s->power = ovr_arena_take(arena, s->n / 2, sizeof(double), err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    s->finest = points / 2 < s->n / 2 - 1 ? points / 2 : s->n / 2 - 1;
    s->step = length / (double)s->n;
    for (size_t i = 0; i < s->n; i++)
        at[i] = p->x[0] + ((double)i + 0.5) * s->step;
    status = ovr_spline_resample(&(ovr_points){points, p->x, p->z}, s->n, at,
                                 &arena->allocator, z, err);
    if (status)
        return status;
    ovr_level(s->n, at, z, 1, work);
    for (size_t i = 0; i < s->n; i++)
        z[i] *= 0.5 -
                0.5 * cos(6.283185307179586 * ((double)i + 0.5) / (double)s->n);
    gsl_fft_real_radix2_transform(z, 1, s->n);
    for (size_t k = 1; k < s->n / 2; k++)
        s->power[k] = z[k] * z[k] + z[s->n - k] * z[s->n - k];
    return OVR_OK;
}

static size_t strongest(const spectrum *s)
{
    size_t best = 0;
    for (size_t k = 2; k < s->finest; k++)
        if (s->power[k] > s->power[best] && s->power[k] >= s->power[k - 1] &&
            s->power[k] >= s->power[k + 1])
            best = k;
    return best;
}

static ovr_profile_wave wave_at(const spectrum *s, size_t k, double total)
{
    double left = s->power[k - 1], right = s->power[k + 1];
    double a = sqrt(fmax(left, right) / s->power[k]);
    double shift = (2 * a - 1) / (a + 1) * (right > left ? 1 : -1);
    double sum = 0, length = (double)s->n * s->step;
    for (size_t j = k > 2 ? k - 2 : 1; j <= k + 2 && j < s->n / 2; j++)
        sum += s->power[j];
    /* Power of a cosine under the window: N^2 A^2 3/32 in all. */
    return (ovr_profile_wave){length / ((double)k + shift),
                              sqrt(sum * 32 / 3) / (double)s->n, sum / total};
}

ovr_status ovr_profile_waves(const ovr_profile *profile, size_t maximum,
                             ovr_profile_wave *waves, size_t *found,
                             ovr_error *err)
{
    if (!profile || !waves || !found)
        return ovr_fail_null(err, __func__);
    ovr_arena arena = ovr_arena_make(&profile->arena.allocator);
    spectrum s = {0};
    double total = 0;
    ovr_status status = whole(profile, err);
    *found = 0;
    if (!status)
        status = transform(profile, &s, &arena, err);
    for (size_t k = 1; !status && k < s.n / 2; k++)
        total += s.power[k];
    while (!status && *found < maximum && total > 0) {
        size_t k = strongest(&s);
        if (!k || s.power[k] < 1e-3 * total)
            break; /* no further peak, or less than 0.1 % of the power */
        waves[(*found)++] = wave_at(&s, k, total);
        for (size_t j = k > 2 ? k - 2 : 1; j <= k + 2 && j < s.n / 2; j++)
            s.power[j] = 0;
    }
    ovr_arena_release(&arena);
    return status;
}
