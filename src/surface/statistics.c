/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a profile measures: heights, slopes, waves. */
#include <gsl/gsl_fft_real.h>
#include <math.h>

#include "surface/condition.h"
#include "surface/profile.h"
#include "surface/spline.h"

enum { FEW = 50 }; /* too few points for five parts */

static ovr_status whole(const ovr_profile *p, ovr_error *err)
{
    size_t missing = 0;
    for (size_t i = 0; i < p->view.n; i++)
        missing += isnan(p->z[i]) ? 1 : 0;
    return missing ? ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%zu heights are missing: fill them first",
                                 missing)
                   : OVR_OK;
}

/* ---------------------------------------------------------------- numbers */

static void measure_lengths(const ovr_profile *p, ovr_profile_numbers *r)
{
    size_t n = r->n = p->view.n;
    r->length = p->x[n - 1] - p->x[0];
    r->spacing = r->length / (double)(n - 1);
    r->spacing_least = r->spacing_most = p->x[1] - p->x[0];
    for (size_t i = 1; i < n; i++) {
        double d = p->x[i] - p->x[i - 1];
        r->spacing_least = fmin(r->spacing_least, d);
        r->spacing_most = fmax(r->spacing_most, d);
    }
}

static void measure_heights(const ovr_profile *p, ovr_profile_numbers *r)
{
    double m1 = 0, m2 = 0, m3 = 0, m4 = 0;
    r->mean = 0;
    for (size_t i = 0; i < r->n; i++)
        r->mean += p->z[i] * ovr_share(r->n, p->x, i) / r->length;
    for (size_t i = 0; i < r->n; i++) {
        double w = ovr_share(r->n, p->x, i) / r->length;
        double z = p->z[i] - r->mean;
        m1 += w * fabs(z);
        m2 += w * z * z;
        m3 += w * z * z * z;
        m4 += w * z * z * z * z;
        r->Rp = fmax(r->Rp, z);
        r->Rv = fmax(r->Rv, -z);
    }
    r->Ra = m1;
    r->Rq = sqrt(m2);
    r->Rt = r->Rp + r->Rv;
    r->Rsk = m2 > 0 ? m3 / m2 / r->Rq : NAN;
    r->Rku = m2 > 0 ? m4 / m2 / m2 : NAN;
}

/* Highest minus lowest height in each of five equal parts, their mean. */
static double mean_of_five(const ovr_profile *p, double length)
{
    double top[5], bottom[5], sum = 0;
    size_t parts = 0;
    for (int k = 0; k < 5; k++)
        top[k] = -INFINITY, bottom[k] = INFINITY;
    for (size_t i = 0; i < p->view.n; i++) {
        int k = (int)fmin(4, 5 * (p->x[i] - p->x[0]) / length);
        top[k] = fmax(top[k], p->z[i]);
        bottom[k] = fmin(bottom[k], p->z[i]);
    }
    for (int k = 0; k < 5; k++)
        if (top[k] >= bottom[k])
            sum += top[k] - bottom[k], parts++;
    return parts ? sum / (double)parts : 0;
}

static double rms_slope(const ovr_profile *p, double length)
{
    double sum = 0;
    for (size_t i = 1; i < p->view.n; i++) {
        double d = p->x[i] - p->x[i - 1], rise = p->z[i] - p->z[i - 1];
        sum += rise * rise / d;
    }
    return sqrt(sum / length);
}

ovr_status ovr_profile_measure(const ovr_profile *profile,
                               ovr_profile_numbers *numbers, ovr_error *err)
{
    ovr_status status = whole(profile, err);
    *numbers = (ovr_profile_numbers){0};
    if (status)
        return status;
    measure_lengths(profile, numbers);
    measure_heights(profile, numbers);
    numbers->Rz = numbers->n < FEW ? numbers->Rt
                                   : mean_of_five(profile, numbers->length);
    numbers->Rdq = rms_slope(profile, numbers->length);
    return OVR_OK;
}

/* ------------------------------------------------------------------ waves */

/*
 * The profile, its line taken off, goes to N = 2^m equal distances and under
 * the Hann window w; |F_k|^2 at k waves in N steps.  A cosine of amplitude A
 * gives a peak of height A sum(w)/2, three bins wide.  The place of a peak is
 * refined by the ratio of its higher neighbour (exact for Hann):
 * delta = (2 a - 1)/(a + 1), a = |F_{k+-1}|/|F_k|.
 */
typedef struct spectrum {
    size_t n;
    size_t finest; /* beyond it the spline made it up */
    double step;
    double *power; /* n/2 */
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
    if (!z || !at || !work || !s->power)
        return OVR_NO_MEMORY;
    s->finest = points / 2 < s->n / 2 - 1 ? points / 2 : s->n / 2 - 1;
    s->step = length / (double)s->n;
    for (size_t i = 0; i < s->n; i++)
        at[i] = p->x[0] + ((double)i + 0.5) * s->step;
    status = ovr_spline_resample(points, p->x, p->z, s->n, at,
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

ovr_status ovr_profile_waves(const ovr_profile *profile, size_t most,
                             ovr_profile_wave *waves, size_t *found,
                             ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&profile->arena.allocator);
    spectrum s = {0};
    double total = 0;
    ovr_status status = whole(profile, err);
    *found = 0;
    if (!status)
        status = transform(profile, &s, &arena, err);
    for (size_t k = 1; !status && k < s.n / 2; k++)
        total += s.power[k];
    while (!status && *found < most && total > 0) {
        size_t k = strongest(&s);
        if (!k || s.power[k] < 1e-3 * total)
            break; /* none, or less than a tenth of a percent */
        waves[(*found)++] = wave_at(&s, k, total);
        for (size_t j = k > 2 ? k - 2 : 1; j <= k + 2 && j < s.n / 2; j++)
            s.power[j] = 0;
    }
    ovr_arena_release(&arena);
    return status;
}

double ovr_wave_reduction(double M, double L, double wavelength)
{
    double r = wavelength * pow(M, 0.75) / sqrt(L);
    return L > 0 ? 1 / (1 + r * (0.17 + 0.03 * r)) : 0;
}
