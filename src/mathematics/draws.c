/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mathematics/draws.h"

#include <math.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>

uint64_t ovr_text_hash(const char *text)
{
    uint64_t h = 14695981039346656037u;
    for (; *text; text++)
        h = (h ^ (unsigned char)*text) * 1099511628211u;
    return h;
}

/* The last step of splitmix64: a bijection that leaves no bit alone. */
static uint64_t mixed(uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static uint64_t bits_at(uint64_t seed, uint64_t stream, uint64_t i)
{
    const uint64_t golden = 0x9e3779b97f4a7c15u;
    uint64_t state = mixed(mixed(seed + golden) ^ stream);
    return mixed(state + (i + 1) * golden);
}

double ovr_uniform_at(uint64_t seed, uint64_t stream, uint64_t i)
{
    return ((double)(bits_at(seed, stream, i) >> 11) + 0.5) * 0x1p-53;
}

/* Streams of one key for different uses. */
static uint64_t stream_of(const char *key, const char *use)
{
    return mixed(ovr_text_hash(key)) ^ ovr_text_hash(use);
}

static void fill_plain(const ovr_sampling *how, const char *key, double *u)
{
    for (size_t i = 0; i < how->draws; i++)
        u[i] = ovr_uniform_at(how->seed, ovr_text_hash(key), i);
}

static ovr_status fill_lhs(const ovr_sampling *how, const char *key, double *u,
                           ovr_arena *arena, ovr_error *err)
{
    size_t n = how->draws,
           *place = ovr_arena_take(arena, n, sizeof *place, err);
    uint64_t order = stream_of(key, "order");
    if (!place)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++)
        place[i] = i;
    for (size_t i = n; i-- > 1;) { /* Fisher & Yates */
        size_t j = (size_t)(ovr_uniform_at(how->seed, order, i) *
                            (double)(i + 1));
        size_t kept = place[i];
        place[i] = place[j];
        place[j] = kept;
    }
    for (size_t i = 0; i < n; i++)
        u[i] = ((double)place[i] +
                ovr_uniform_at(how->seed, ovr_text_hash(key), i)) /
               (double)n;
    return OVR_OK;
}

/* Off the ends of (0, 1), where normal numbers are infinite. */
static double inside(double u)
{
    return u < 0x1p-54 ? 0x1p-54 : u > 1 - 0x1p-53 ? 1 - 0x1p-53 : u;
}

static ovr_status fill_sobol(const ovr_sampling *how, double *u,
                             ovr_arena *arena, ovr_error *err)
{
    unsigned count = (unsigned)how->keys;
    double point[OVR_SOBOL_MAX] = {0};
    const gsl_qrng_type *sobol = gsl_qrng_sobol;
    void *state;
    if (count > OVR_SOBOL_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%u keys are random, and the points of Sobol' have %d "
                        "dimensions at most: take design = lhs",
                        count, OVR_SOBOL_MAX);
    /* gsl_qrng_alloc is not called: it ends the program where memory ends. */
    state = ovr_arena_take(arena, 1, sobol->state_size(count), err);
    if (!state)
        return OVR_NO_MEMORY;
    sobol->init_state(state, count);
    for (size_t i = 0; i < how->draws; i++) {
        size_t replicate = i % how->shifts;
        if (i >= how->shifts && replicate == 0)
            sobol->get(state, count, point);
        for (size_t k = 0; k < count; k++) {
            double shift = ovr_uniform_at(
                how->seed, stream_of(how->key[k], "shift"), replicate);
            u[k * how->draws + i] = inside(fmod(point[k] + shift, 1));
        }
    }
    return OVR_OK;
}

ovr_status ovr_draws(const ovr_sampling *how, double *u, ovr_arena *arena,
                     ovr_error *err)
{
    ovr_status status = OVR_OK;
    if (how->design == OVR_SOBOL && how->keys)
        return fill_sobol(how, u, arena, err);
    for (size_t k = 0; !status && k < how->keys; k++)
        if (how->design == OVR_LHS)
            status = fill_lhs(how, how->key[k], u + k * how->draws, arena, err);
        else
            fill_plain(how, how->key[k], u + k * how->draws);
    return status;
}

/* ---------------------------------------------------------- distributions */

const char *ovr_distribution_wrong(const ovr_distribution *d)
{
    if (d->law == OVR_NORMAL && !(d->b > 0))
        return "its standard deviation must be above 0";
    if (d->law == OVR_LOGNORMAL && !(d->a > 0 && d->b > 0))
        return "mean and standard deviation must be above 0";
    if (d->law == OVR_UNIFORM && !(d->a < d->b))
        return "its first end must be below the second";
    if (d->law == OVR_TRIANGULAR &&
        !(d->a <= d->b && d->b <= d->c && d->a < d->c))
        return "least, likeliest and most must be in order";
    if (!(d->low < d->high))
        return "within: the first end must be below the second";
    return NULL;
}

/* A lognormal number with this mean and deviation has a logarithm with mu = ln
 * mean - sigma^2/2, sigma^2 = ln(1 + (sd/mean)^2). */
static double log_sigma(const ovr_distribution *d)
{
    return sqrt(log1p(pow(d->b / d->a, 2)));
}

static double log_mean(const ovr_distribution *d)
{
    return log(d->a) - 0.5 * pow(log_sigma(d), 2);
}

static double probability(const ovr_distribution *d, double x)
{
    double range = d->c - d->a;
    switch (d->law) {
    case OVR_NORMAL: return gsl_cdf_gaussian_P(x - d->a, d->b);
    case OVR_LOGNORMAL:
        return x > 0 ? gsl_cdf_lognormal_P(x, log_mean(d), log_sigma(d)) : 0;
    case OVR_UNIFORM: return fmin(fmax((x - d->a) / (d->b - d->a), 0), 1);
    case OVR_TRIANGULAR:
        if (x <= d->a || x >= d->c)
            return x > d->a;
        return x < d->b ? pow(x - d->a, 2) / (range * (d->b - d->a))
                        : 1 - pow(d->c - x, 2) / (range * (d->c - d->b));
    }
    return NAN;
}

static double whole_inverse(const ovr_distribution *d, double u)
{
    double range = d->c - d->a;
    switch (d->law) {
    case OVR_NORMAL: return d->a + gsl_cdf_gaussian_Pinv(u, d->b);
    case OVR_LOGNORMAL:
        return gsl_cdf_lognormal_Pinv(u, log_mean(d), log_sigma(d));
    case OVR_UNIFORM: return d->a + u * (d->b - d->a);
    case OVR_TRIANGULAR:
        return u * range < d->b - d->a
                   ? d->a + sqrt(u * range * (d->b - d->a))
                   : d->c - sqrt((1 - u) * range * (d->c - d->b));
    }
    return NAN;
}

double ovr_distribution_inverse(const ovr_distribution *d, double u)
{
    double from = 0, to = 1;
    if (isinf(d->low) && isinf(d->high))
        return whole_inverse(d, u);
    from = isinf(d->low) ? 0 : probability(d, d->low);
    to = isinf(d->high) ? 1 : probability(d, d->high);
    return fmin(fmax(whole_inverse(d, from + u * (to - from)), d->low),
                d->high);
}
