/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Vectors as wide as the instruction set a kernel file is compiled for.
 *
 * GCC's vector extension (gcc and clang, any machine).  Every operation is
 * elementwise and none is fused, so all instruction sets give the same bits.
 * Arrays come from ovr_field (level.h): aligned, with room for one vector
 * before the first and after the last element.
 */
#ifndef OVR_MULTIGRID_VECTOR_H
#define OVR_MULTIGRID_VECTOR_H

#include <stddef.h>
#include <stdint.h>

#if defined(__AVX512F__)
#define VEC 8
#elif defined(__AVX__)
#define VEC 4
#else
#define VEC 2
#endif

typedef double vec __attribute__((vector_size(VEC * 8)));
typedef int64_t ivec __attribute__((vector_size(VEC * 8)));
typedef double loose_vec
    __attribute__((vector_size(VEC * 8), aligned(8), may_alias));

static inline vec load(const double *x)
{
    return *(const loose_vec *)x;
}

static inline void store(double *x, vec v)
{
    *(loose_vec *)x = v;
}

static inline vec all(double x)
{
    return x - (vec){0};
}

/* mask ? a : b, for a mask made by a comparison */
static inline vec choose(ivec mask, vec a, vec b)
{
    return (vec)((mask & (ivec)a) | (~mask & (ivec)b));
}

static inline vec larger(vec a, vec b)
{
    return choose(a > b, a, b);
}

static inline vec smaller(vec a, vec b)
{
    return choose(a < b, a, b);
}

/*
 * exp(x).  1. n = round(x/ln 2) by adding 1.5 2^52; 2. r = x - n ln 2 with
 * ln 2 in two parts, |r| < 0.347; 3. Taylor polynomial of degree 13 in Horner
 * form, truncation below 5e-18; 4. n is added to the exponent.
 * Error below 2 ulp for |x| <= 700; x is clamped to that range.
 */
static inline vec exponential(vec x)
{
    static const double c[] = {1. / 6227020800, 1. / 479001600, 1. / 39916800,
                               1. / 3628800,    1. / 362880,    1. / 40320,
                               1. / 5040,       1. / 720,       1. / 120,
                               1. / 24,         1. / 6,         1. / 2};
    const vec shift = all(0x1.8p52);
    vec t, n, r, p = all(c[0]);
    x = smaller(larger(x, all(-700)), all(700));
    t = x * 0x1.71547652b82fep0 + shift;
    n = t - shift;
    r = x - n * 0x1.62e42fefa38p-1;
    r = r - n * 0x1.ef35793c7673p-45;
    for (int k = 1; k < 12; k++)
        p = p * r + c[k];
    p = p * r * r + r + 1.0;
    return (vec)((ivec)p + ((ivec)t << 52));
}

/*
 * log(x) for x >= 1.  1. x = 2^k m with m in [0.7071, 1.4142); 2. s =
 * (m - 1)/(m + 1), log m = 2 (s + s^3/3 + ... + s^21/21), truncation below
 * 1e-17; 3. + k ln 2 in two parts.  Error below 2 ulp.
 */
static inline vec logarithm(vec x)
{
    const int64_t half_root = 0x3fe6a09e667f3bcd; /* bits of sqrt(1/2) */
    const ivec whole = (ivec)all(0x1p52);
    ivec bits = (ivec)x;
    ivec k = (bits - half_root) >> 52;
    vec m = (vec)(bits - (k << 52));
    vec kd = (vec)(k | whole) - 0x1p52;
    vec s = (m - 1.0) / (m + 1.0), s2 = s * s, p = all(1. / 21);
    for (int j = 19; j >= 3; j -= 2)
        p = p * s2 + 1. / j;
    return kd * 0x1.62e42fefa38p-1 +
           (2 * s + (2 * s * s2 * p + kd * 0x1.ef35793c7673p-45));
}

#endif
