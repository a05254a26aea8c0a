/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Random roughness with a given spectrum, from a seed.
 *
 *   1. z_i = sum_k sqrt(C_k) (a_k cos(2 pi k i/N) + b_k sin(2 pi k i/N)),
 *      k = 1 .. length/shortest; a_k, b_k Gaussian (GSL's MT19937, polar
 *      method), C_k the spectrum of profile.h; by GSL's radix-2 transform.
 *      N is the power of two with at least 8 points in the shortest wave.
 *   2. Heights are scaled to Rq exactly; the mean is exactly zero (k >= 1).
 *   3. Skewness and kurtosis: the heights are replaced, rank by rank, by those
 *      of g(q) = q + c (q^2 - 1) + d q^3 at the N normal quantiles q (Fleishman
 *      1978). Newton's method yields c and d for the moments of these N
 *      numbers. Ranks and spectrum are restored alternately (Schreiber &
 *      Schmitz 1996), ranks last: the moments are exact, the spectrum is
 *      approximate.
 *
 * Areal roughness is periodic in length x width. Its waves (k, l) have
 * k^2/length^2 + l^2/width^2 <= 1/shortest^2, with 4 points in the shortest
 * wave. The axes u and v are rotated by the angle of the lay. The spectrum is a
 * function of kappa^2 = k_u^2 + (k_v/peklenik)^2. It is 1 below 2 pi/rolloff
 * and kappa^(-2 - 2 hurst) beyond, or (1 + (kappa correlation)^2)^(-3/2).
 *
 * Only +, *, sqrt, log, sin and cos are used, so that machines agree to
 * rounding.
 */
#include "overroll/profile.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_complex.h>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sort.h>
#include <math.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/areal.h"
#include "surface/profile.h"

enum { MAX = 1 << 20, ITERATIONS = 25, AREAL_ITERATIONS = 10 };

typedef struct random_surface {
    const ovr_roughness *form;
    double longest, shortest, correlation;
    size_t n, waves;
    double *z, *size; /* heights, amplitude of each wave */
    double *target;   /* sorted heights with the specified distribution */
    double *normal;   /* quantiles */
    size_t *rank;
} random_surface;

/* ------------------------------------------------------------ 1. spectrum */

static double spectrum(const random_surface *s, double wavelength)
{
    double v;
    if (s->form->spectrum == OVR_EXPONENTIAL) {
        v = 6.283185307179586 * s->correlation / wavelength;
        return 1 / (1 + v * v);
    }
    v = s->longest / wavelength;
    return v <= 1 ? 1 : pow(v, -1 - 2 * s->form->hurst);
}

static ovr_status draw(random_surface *s, ovr_arena *arena, ovr_error *err)
{
    const gsl_rng_type *type = gsl_rng_mt19937;
    gsl_rng rng = {type, ovr_arena_take(arena, type->size, 1, err)};
    if (!rng.state)
        return OVR_NO_MEMORY;
    gsl_rng_set(&rng, (unsigned long)s->form->seed);
    for (size_t k = 1; k <= s->waves; k++) {
        s->size[k] = sqrt(spectrum(s, s->form->length / (double)k));
        s->z[k] = s->size[k] * gsl_ran_gaussian(&rng, 1);
        s->z[s->n - k] = s->size[k] * gsl_ran_gaussian(&rng, 1);
    }
    gsl_fft_halfcomplex_radix2_backward(s->z, 1, s->n);
    return OVR_OK;
}

/* --------------------------------------------------------------- 2. scale */

/* Scales to zero mean and unit variance; returns skewness and kurtosis. */
static void standardize(size_t n, double *z, double *skewness, double *kurtosis)
{
    double mean = 0, square = 0, m3 = 0, m4 = 0, sigma;
    for (size_t i = 0; i < n; i++)
        mean += z[i] / (double)n;
    for (size_t i = 0; i < n; i++)
        square += (z[i] - mean) * (z[i] - mean) / (double)n;
    sigma = sqrt(square);
    for (size_t i = 0; i < n; i++) {
        double v = z[i] = (z[i] - mean) / sigma;
        m3 += v * v * v / (double)n;
        m4 += v * v * v * v / (double)n;
    }
    *skewness = m3;
    *kurtosis = m4;
}

/* ------------------------------------------------------------- 3. moments */

static void moments_of(random_surface *s, double c, double d, double *skewness,
                       double *kurtosis)
{
    for (size_t i = 0; i < s->n; i++) {
        double q = s->normal[i];
        s->target[i] = q + c * (q * q - 1) + d * q * q * q;
    }
    standardize(s->n, s->target, skewness, kurtosis);
}

/* Solves for c and d with the specified skewness and kurtosis by Newton's
 * method with difference quotients and limited steps. */
static bool find_target(random_surface *s, double skewness, double kurtosis)
{
    const double e = 1e-6;
    double c = 0, d = 0, s0, k0, s1, k1, s2, k2;
    for (size_t i = 0; i < s->n; i++)
        s->normal[i] = gsl_cdf_ugaussian_Pinv(((double)i + 0.5) / (double)s->n);
    for (int step = 0; step < 100; step++) {
        double det, dc, dd, size;
        moments_of(s, c + e, d, &s1, &k1);
        moments_of(s, c, d + e, &s2, &k2);
        moments_of(s, c, d, &s0, &k0);
        if (fabs(s0 - skewness) < 1e-10 && fabs(k0 - kurtosis) < 1e-9) {
            gsl_sort(s->target, 1, s->n);
            return true;
        }
        det = ((s1 - s0) * (k2 - k0) - (s2 - s0) * (k1 - k0)) / e;
        dc = ((skewness - s0) * (k2 - k0) - (kurtosis - k0) * (s2 - s0)) / det;
        dd = ((kurtosis - k0) * (s1 - s0) - (skewness - s0) * (k1 - k0)) / det;
        size = fmax(fabs(dc), fabs(dd));
        if (!isfinite(size))
            return false;
        c += dc * fmin(1, 0.1 / size);
        d += dd * fmin(1, 0.1 / size);
    }
    return false;
}

static void restore_ranks(random_surface *s)
{
    gsl_sort_index(s->rank, s->z, 1, s->n);
    for (size_t i = 0; i < s->n; i++)
        s->z[s->rank[i]] = s->target[i];
}

/* Restores the amplitude of each wave and keeps its phase. */
static void restore_spectrum(random_surface *s)
{
    gsl_fft_real_radix2_transform(s->z, 1, s->n);
    s->z[0] = s->z[s->n / 2] = 0;
    for (size_t k = 1; k < s->n / 2; k++) {
        double size = hypot(s->z[k], s->z[s->n - k]);
        double by = k <= s->waves && size > 0 ? s->size[k] / size : 0;
        s->z[k] *= by;
        s->z[s->n - k] *= by;
    }
    gsl_fft_halfcomplex_radix2_backward(s->z, 1, s->n);
}

static ovr_status no_heights(const ovr_roughness *f, double skewness,
                             double kurtosis, ovr_error *err)
{
    return ovr_fail_about(err, isnan(f->kurtosis) ? "skewness" : "kurtosis",
                          "roughness: skewness = %g and kurtosis = %g cannot "
                          "be combined; kurtosis must be above about 1.9 + "
                          "1.7 skewness^2",
                          skewness, kurtosis);
}

static ovr_status shape_heights(random_surface *s, ovr_error *err)
{
    const ovr_roughness *f = s->form;
    double skewness = isnan(f->skewness) ? 0 : f->skewness;
    double kurtosis = isnan(f->kurtosis) ? 3 + 1.5 * skewness * skewness
                                         : f->kurtosis;
    if (isnan(f->skewness) && isnan(f->kurtosis))
        return OVR_OK;
    if (!find_target(s, skewness, kurtosis))
        return no_heights(f, skewness, kurtosis, err);
    /* The amplitudes remain as drawn, so that realizations are random. */
    gsl_fft_real_radix2_transform(s->z, 1, s->n);
    for (size_t k = 1; k <= s->waves; k++)
        s->size[k] = hypot(s->z[k], s->z[s->n - k]);
    gsl_fft_halfcomplex_radix2_backward(s->z, 1, s->n);
    for (int k = 0; k < ITERATIONS; k++) {
        restore_ranks(s);
        restore_spectrum(s);
    }
    restore_ranks(s);
    return OVR_OK;
}

/* Returns the multiplications, about, of n drawn heights and their transform,
 * and of `rounds` alternations between ranks and spectrum. */
static double work_of(const random_surface *s, int rounds)
{
    const double height = 50, transform = 4; /* 4 n log2 n */
    double n = (double)s->n, once = transform * n * log2(n);
    if (isnan(s->form->skewness) && isnan(s->form->kurtosis))
        rounds = 0;
    return height * n + once + 3 * rounds * once;
}

/* ----------------------------------------------------- checks of the form */

static ovr_status bad(ovr_error *err, const char *key, double value,
                      const char *right)
{
    return ovr_fail_about(err, key, "roughness: %s = %g must be %s", key, value,
                          right);
}

static double or_else(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

static ovr_status check(random_surface *s, ovr_error *err)
{
    const ovr_roughness *f = s->form;
    s->longest = or_else(f->rolloff, f->length / 8);
    s->shortest = or_else(f->shortest, f->length / 256);
    s->correlation = or_else(f->correlation, f->length / 32);
    if (isnan(f->Rq) || isnan(f->length))
        return ovr_fail_about(err, isnan(f->Rq) ? "Rq" : "length",
                              "a roughness needs %s",
                              isnan(f->Rq) ? "Rq" : "length");
    if (!(f->Rq >= 0) || isinf(f->Rq))
        return bad(err, "Rq", f->Rq, "zero or positive");
    if (!(f->length > 0) || isinf(f->length))
        return bad(err, "length", f->length, "positive");
    if (!(f->hurst >= 0 && f->hurst <= 1))
        return bad(err, "hurst", f->hurst, "from 0 to 1");
    if (!(s->longest > 0))
        return bad(err, "rolloff", s->longest, "positive");
    if (!(s->correlation > 0))
        return bad(err, "correlation", s->correlation, "positive");
    if (!(s->shortest > f->length * 8 / MAX && s->shortest <= f->length))
        return bad(err, "shortest", s->shortest,
                   "at most the length and above 1/131072 of it");
    if (f->seed < 0)
        return bad(err, "seed", f->seed, "zero or positive");
    if (f->spectrum != OVR_SELF_AFFINE && f->spectrum != OVR_EXPONENTIAL)
        return bad(err, "spectrum", f->spectrum, "a valid name");
    return OVR_OK;
}

static ovr_status reserve(random_surface *s, ovr_arena *arena, ovr_error *err)
{
    s->waves = (size_t)(s->form->length / s->shortest * (1 + 1e-12));
    for (s->n = 16; s->n < 8 * s->waves;)
        s->n *= 2;
    s->z = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->size = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->target = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->normal = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->rank = ovr_arena_take(arena, s->n, sizeof(size_t), err);
    return ovr_arena_status(arena);
}

/* Copies one period and repeats its first point at the end. */
static ovr_status hand_over(const random_surface *s, ovr_profile *p,
                            ovr_error *err)
{
    size_t n = s->n + 1;
    ovr_status status = ovr_profile_reserve(p, n, err);
    if (status)
        return status;
    ovr_profile_regular(p, n, 0, s->form->length / (double)s->n);
    for (size_t i = 0; i < n; i++)
        p->z[i] = s->form->Rq * s->z[i % s->n];
    p->view.scaled_x = p->view.scaled_z = true;
    p->view.format = "roughness";
    p->work = work_of(s, ITERATIONS);
    ovr_profile_note(p,
                     "random roughness, seed %d: %zu waves with wavelengths "
                     "of %g b to %g b, Rq = %g b^2/R",
                     s->form->seed, s->waves, s->form->length, s->shortest,
                     s->form->Rq);
    return ovr_profile_finish(p, n, err);
}

static ovr_status synthesize(random_surface *s, ovr_profile *p, ovr_error *err)
{
    double skewness, kurtosis;
    ovr_arena work = ovr_arena_make(&p->arena.allocator);
    ovr_status status = reserve(s, &work, err);
    if (!status)
        status = draw(s, &work, err);
    if (!status) {
        standardize(s->n, s->z, &skewness, &kurtosis);
        status = shape_heights(s, err);
    }
    if (!status)
        status = hand_over(s, p, err);
    ovr_arena_release(&work);
    return status;
}

ovr_profile *ovr_profile_random(const ovr_roughness *form,
                                const ovr_allocator *allocator, ovr_error *err)
{
    ovr_roughness own;
    random_surface s = {.form = &own};
    ovr_profile *p;
    if (OVR_TAKE(ovr_roughness, &own, form, err) || check(&s, err))
        return NULL;
    p = ovr_profile_new("roughness", allocator, err);
    if (p && !synthesize(&s, p, err))
        return p;
    ovr_profile_free(p);
    return NULL;
}

/* -------------------------------------------------------- areal roughness */

typedef struct areal_waves {
    random_surface s; /* heights of all points; amplitudes of the waves */
    double width, sine, cosine;
    size_t nx, ny;
    double *wave; /* complex, nx ny elements, by rows */
} areal_waves;

/* Returns the spectrum of wave k along x and l across. */
static double areal_spectrum(const areal_waves *a, double k, double l)
{
    const ovr_roughness *f = a->s.form;
    double x = k / f->length, y = l / a->width;
    double u = x * a->cosine + y * a->sine;
    double v = (y * a->cosine - x * a->sine) / f->peklenik, w = hypot(u, v);
    if (f->spectrum == OVR_EXPONENTIAL) {
        w *= 6.283185307179586 * a->s.correlation;
        return pow(1 + w * w, -1.5);
    }
    w *= a->s.longest;
    return w <= 1 ? 1 : pow(w, -2 - 2 * f->hurst);
}

static void transform(const areal_waves *a, bool back)
{
    for (size_t k = 0; k < a->nx + a->ny; k++) {
        bool row = k < a->ny;
        double *at = a->wave + 2 * (row ? k * a->nx : k - a->ny);
        size_t stride = row ? 1 : a->nx, n = row ? a->nx : a->ny;
        if (back)
            gsl_fft_complex_radix2_backward(at, stride, n);
        else
            gsl_fft_complex_radix2_forward(at, stride, n);
    }
}

/* Computes heights from the waves by inverse FFT. */
static void sum_waves(const areal_waves *a)
{
    transform(a, true);
    for (size_t i = 0; i < a->s.n; i++)
        a->s.z[i] = a->wave[2 * i];
}

/* Computes waves from the heights by FFT. */
static void find_waves(const areal_waves *a)
{
    for (size_t i = 0; i < a->s.n; i++) {
        a->wave[2 * i] = a->s.z[i];
        a->wave[2 * i + 1] = 0;
    }
    transform(a, false);
}

/* Draws wave (k, l) and its conjugate, so that heights are real. */
static void draw_wave(const areal_waves *a, const gsl_rng *rng, long k, long l)
{
    const ovr_roughness *f = a->s.form;
    double x = (double)k / f->length, y = (double)l / a->width;
    double real = gsl_ran_gaussian(rng, 1), other = gsl_ran_gaussian(rng, 1);
    if (hypot(x, y) * a->s.shortest > 1 + 1e-12)
        return;
    double size = sqrt(areal_spectrum(a, (double)k, (double)l));
    for (int sign = 1; sign >= -1; sign -= 2) {
        size_t i = (size_t)(sign * k + (k * sign < 0 ? (long)a->nx : 0));
        size_t j = (size_t)(sign * l + (l * sign < 0 ? (long)a->ny : 0));
        a->wave[2 * (j * a->nx + i)] = size * real;
        a->wave[2 * (j * a->nx + i) + 1] = sign * size * other;
    }
}

static ovr_status draw_areal(areal_waves *a, ovr_arena *arena, ovr_error *err)
{
    const gsl_rng_type *type = gsl_rng_mt19937;
    gsl_rng rng = {type, ovr_arena_take(arena, type->size, 1, err)};
    long K = (long)(a->s.form->length / a->s.shortest * (1 + 1e-12));
    long L = (long)(a->width / a->s.shortest * (1 + 1e-12));
    if (!rng.state)
        return OVR_NO_MEMORY;
    gsl_rng_set(&rng, (unsigned long)a->s.form->seed);
    for (long k = 0; k <= K; k++)
        for (long l = k ? -L : 1; l <= L; l++)
            draw_wave(a, &rng, k, l);
    sum_waves(a);
    return OVR_OK;
}

/* Changes the heights so that they have the specified skewness and kurtosis. */
static ovr_status shape_areal(areal_waves *a, ovr_error *err)
{
    random_surface *s = &a->s;
    double skewness = or_else(s->form->skewness, 0);
    double kurtosis = or_else(s->form->kurtosis, 3 + 1.5 * skewness * skewness);
    if (isnan(s->form->skewness) && isnan(s->form->kurtosis))
        return OVR_OK;
    if (!find_target(s, skewness, kurtosis))
        return no_heights(s->form, skewness, kurtosis, err);
    find_waves(a);
    for (size_t i = 0; i < s->n; i++)
        s->size[i] = hypot(a->wave[2 * i], a->wave[2 * i + 1]);
    for (int k = 0; k < AREAL_ITERATIONS; k++) {
        restore_ranks(s);
        find_waves(a);
        for (size_t i = 0; i < s->n; i++) {
            double size = hypot(a->wave[2 * i], a->wave[2 * i + 1]);
            double by = size > 0 ? s->size[i] / size / (double)s->n : 0;
            a->wave[2 * i] *= by;
            a->wave[2 * i + 1] *= by;
        }
        sum_waves(a);
    }
    restore_ranks(s);
    return OVR_OK;
}

static ovr_status reserve_areal(areal_waves *a, ovr_arena *arena,
                                ovr_error *err)
{
    random_surface *s = &a->s;
    for (a->nx = 16; (double)a->nx < 4 * s->form->length / s->shortest;)
        a->nx *= 2;
    for (a->ny = 16; (double)a->ny < 4 * a->width / s->shortest;)
        a->ny *= 2;
    s->n = a->nx * a->ny;
    if (s->n > 1 << 22)
        return bad(
            err, "shortest", s->shortest,
            "longer, because length x width may contain 4 million points, "
            "4 per shortest wave");
    a->wave = ovr_arena_take(arena, 2 * s->n, sizeof(double), err);
    s->z = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->size = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->target = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->normal = ovr_arena_take(arena, s->n, sizeof(double), err);
    s->rank = ovr_arena_take(arena, s->n, sizeof(size_t), err);
    return ovr_arena_status(arena);
}

/* Copies one period and repeats its first row and column at the end. */
static ovr_status fill_map(const areal_waves *a, ovr_profile *p, ovr_error *err)
{
    const ovr_roughness *f = a->s.form;
    ovr_status status = ovr_areal_reserve(p, a->nx + 1, a->ny + 1,
                                          f->length / (double)a->nx,
                                          a->width / (double)a->ny, err);
    if (status)
        return status;
    for (size_t j = 0; j <= a->ny; j++)
        for (size_t i = 0; i <= a->nx; i++)
            p->map.z[j * (a->nx + 1) + i] =
                f->Rq * a->s.z[j % a->ny * a->nx + i % a->nx];
    p->map.scaled_x = p->map.scaled_z = true;
    p->map.format = "roughness";
    p->map.notes = p->notes;
    p->map.owner = p;
    p->work = work_of(&a->s, AREAL_ITERATIONS);
    ovr_profile_note(p,
                     "random, seed %d: waves down to %g b, period %g x %g b, "
                     "Peklenik number %g, Sq %g b^2/R",
                     f->seed, a->s.shortest, f->length, a->width, f->peklenik,
                     f->Rq);
    return OVR_OK;
}

static ovr_status synthesize_areal(areal_waves *a, ovr_profile *p,
                                   ovr_error *err)
{
    double skewness, kurtosis;
    ovr_arena work = ovr_arena_make(&p->arena.allocator);
    ovr_status status = reserve_areal(a, &work, err);
    if (!status)
        status = draw_areal(a, &work, err);
    if (!status) {
        standardize(a->s.n, a->s.z, &skewness, &kurtosis);
        status = shape_areal(a, err);
    }
    if (!status)
        status = fill_map(a, p, err);
    ovr_arena_release(&work);
    return status;
}

ovr_areal *ovr_areal_random(const ovr_roughness *form, double width,
                            double angle, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_roughness own;
    areal_waves a = {.s = {.form = &own},
                     .width = width,
                     .sine = sin(angle),
                     .cosine = cos(angle)};
    if (OVR_TAKE(ovr_roughness, &own, form, err) || check(&a.s, err))
        return NULL;
    if (!(own.peklenik > 0) || isinf(own.peklenik)) {
        bad(err, "peklenik", own.peklenik, "positive");
        return NULL;
    }
    ovr_profile *p = ovr_profile_new("roughness", allocator, err);
    if (p && !synthesize_areal(&a, p, err))
        return &p->map;
    ovr_profile_free(p);
    return NULL;
}
