/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mathematics/draws.h"

#include <math.h>

#include <gsl/gsl_cdf.h>

uint64_t ovr_text_hash(const char *text)
{
    uint64_t h = 14695981039346656037u;
    for (; *text; text++)
        h = (h ^ (unsigned char)*text) * 1099511628211u;
    return h;
}

/* Returns the last step of splitmix64, a bijection that mixes all bits. */
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

/* Returns the random stream of a key for one of several uses. */
static uint64_t stream_of(const char *key, const char *use)
{
    return mixed(ovr_text_hash(key)) ^ ovr_text_hash(use);
}

/* --------------------------------------------------------- Latin hypercube */

static unsigned bit_length(uint64_t n)
{
    unsigned bits = 0;
    for (; n; n >>= 1)
        bits++;
    return bits;
}

/* Returns the image of i under a random permutation of 0..n-1: "swap or not"
 * (Hoang, Morris & Rogaway 2012), with about 6 log2(n) + 24 rounds. */
static uint64_t permuted(uint64_t seed, uint64_t stream, uint64_t n, uint64_t i)
{
    const unsigned rounds = 6 * bit_length(n) + 24;
    for (unsigned r = 0; r < rounds; r++) {
        uint64_t key = bits_at(seed, stream, r);
        uint64_t other = (key % n + n - i) % n;
        uint64_t larger = i > other ? i : other;
        if (mixed(key ^ mixed(larger)) & 1)
            i = other;
    }
    return i;
}

static double latin(const ovr_sampling *how, const char *key, size_t i)
{
    uint64_t stratum = permuted(how->seed, stream_of(key, "order"), how->draws,
                                i);
    return ((double)stratum +
            ovr_uniform_at(how->seed, ovr_text_hash(key), i)) /
           (double)how->draws;
}

/* ------------------------------------------------------------------- Sobol */

/* A primitive polynomial modulo 2, its coefficients as bits, and the first
 * odd numbers of its sequence (Bratley & Fox 1988). */
typedef struct sobol_dimension {
    unsigned polynomial, first[8];
} sobol_dimension;

static const sobol_dimension dimensions[OVR_SOBOL_MAX] = {
    {1, {1}},
    {3, {1}},
    {7, {1, 1}},
    {11, {1, 3, 7}},
    {13, {1, 1, 5}},
    {19, {1, 3, 1, 1}},
    {25, {1, 1, 3, 7}},
    {37, {1, 3, 3, 9, 9}},
    {59, {1, 3, 7, 13, 3}},
    {47, {1, 1, 5, 11, 27}},
    {61, {1, 3, 5, 1, 15}},
    {55, {1, 1, 7, 3, 29}},
    {41, {1, 3, 7, 7, 21}},
    {67, {1, 1, 1, 9, 23, 37}},
    {97, {1, 3, 3, 5, 19, 33}},
    {91, {1, 1, 3, 13, 11, 7}},
    {109, {1, 1, 7, 13, 25, 5}},
    {103, {1, 3, 5, 11, 7, 11}},
    {115, {1, 1, 1, 3, 13, 39}},
    {131, {1, 3, 1, 15, 17, 63, 13}},
    {193, {1, 1, 5, 5, 1, 27, 33}},
    {137, {1, 3, 3, 3, 25, 17, 115}},
    {145, {1, 1, 3, 15, 29, 15, 41}},
    {143, {1, 3, 1, 7, 3, 23, 79}},
    {241, {1, 3, 7, 9, 31, 29, 17}},
    {157, {1, 1, 5, 13, 11, 3, 29}},
    {185, {1, 3, 1, 9, 5, 21, 119}},
    {167, {1, 1, 3, 1, 23, 13, 75}},
    {229, {1, 3, 3, 11, 27, 31, 73}},
    {171, {1, 1, 7, 7, 19, 25, 105}},
    {213, {1, 3, 5, 5, 21, 9, 7}},
    {191, {1, 1, 1, 15, 5, 49, 59}},
    {253, {1, 1, 1, 1, 1, 33, 65}},
    {203, {1, 3, 5, 15, 17, 19, 21}},
    {211, {1, 1, 7, 11, 13, 29, 3}},
    {239, {1, 3, 7, 5, 7, 11, 113}},
    {247, {1, 1, 5, 3, 15, 19, 61}},
    {285, {1, 3, 1, 1, 9, 27, 89, 7}},
    {369, {1, 1, 3, 7, 31, 15, 45, 23}},
    {299, {1, 3, 3, 9, 9, 25, 107, 39}},
};

enum { SOBOL_BITS = 30 };

/* Returns direction number m_j, j >= degree, from the `degree` numbers before
 * it, m_(j-degree) first. */
static unsigned next_direction(const unsigned *before, unsigned degree,
                               unsigned polynomial)
{
    unsigned next = *before;
    for (unsigned i = 1; i <= degree; i++)
        if (polynomial >> (degree - i) & 1)
            next ^= before[degree - i] << i;
    return next;
}

/* Returns coordinate `k` of point n, which is 0 for n = 0; the points are in
 * the order of the Gray code of n (Antonov & Saleev 1979). */
static double sobol(size_t k, uint64_t n)
{
    const sobol_dimension *d = &dimensions[k];
    const unsigned degree = bit_length(d->polynomial) - 1;
    const uint64_t gray = n ^ (n >> 1);
    unsigned m[SOBOL_BITS] = {0}, point = 0;
    for (unsigned j = 0; j < SOBOL_BITS && gray >> j; j++) {
        if (k == 0)
            m[j] = 1;
        else if (j < degree)
            m[j] = d->first[j];
        else
            m[j] = next_direction(m + j - degree, degree, d->polynomial);
        if (gray >> j & 1)
            point ^= m[j] << (SOBOL_BITS - 1 - j);
    }
    return (double)point * 0x1p-30;
}

/* Clamps u away from 0 and 1, where the inverse normal distribution is
 * infinite. */
static double clamp_open_unit_interval(double u)
{
    return u < 0x1p-54 ? 0x1p-54 : u > 1 - 0x1p-53 ? 1 - 0x1p-53 : u;
}

static double shifted_sobol(const ovr_sampling *how, size_t k, size_t i)
{
    double shift = ovr_uniform_at(how->seed, stream_of(how->key[k], "shift"),
                                  i % how->shifts);
    return clamp_open_unit_interval(fmod(sobol(k, i / how->shifts) + shift, 1));
}

/* ------------------------------------------------------------------ draws */

ovr_status ovr_sampling_check(const ovr_sampling *how, ovr_error *err)
{
    if (how->design != OVR_SOBOL || how->keys <= OVR_SOBOL_MAX)
        return OVR_OK;
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%zu keys are random, but Sobol' points have at most %d "
                    "dimensions; use design = lhs",
                    how->keys, OVR_SOBOL_MAX);
}

double ovr_draw_at(const ovr_sampling *how, size_t k, size_t i)
{
    switch (how->design) {
    case OVR_SOBOL: return shifted_sobol(how, k, i);
    case OVR_LHS: return latin(how, how->key[k], i);
    case OVR_PLAIN: break;
    }
    return ovr_uniform_at(how->seed, ovr_text_hash(how->key[k]), i);
}

/* ---------------------------------------------------------- distributions */

const char *ovr_distribution_wrong(const ovr_distribution *d)
{
    if (d->law == OVR_NORMAL && !(d->b > 0))
        return "its standard deviation must be above 0";
    if (d->law == OVR_LOGNORMAL && !(d->a > 0 && d->b > 0))
        return "mean and standard deviation must be above 0";
    if (d->law == OVR_UNIFORM && !(d->a < d->b))
        return "its lower limit must be below the upper limit";
    if (d->law == OVR_TRIANGULAR &&
        !(d->a <= d->b && d->b <= d->c && d->a < d->c))
        return "minimum, mode and maximum must be in ascending order";
    if (!(d->low < d->high))
        return "within: the lower limit must be below the upper limit";
    return NULL;
}

/* Returns sigma of the logarithm for a lognormal number with this mean and
 * standard deviation: mu = ln mean - sigma^2/2, sigma^2 = ln(1 +
 * (sd/mean)^2). */
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
