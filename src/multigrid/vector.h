/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Vectors as wide as the instruction set a kernel file is compiled for.
 *
 * GCC's vector extension (gcc and clang, any machine).  Operations are
 * elementwise and fused only where fused() says so, on the machines that can:
 * one machine always gives the same bits, instruction sets agree to rounding.
 * Arrays come from ovr_field (field.h): aligned, with room for some vectors
 * before the first and after the last element.
 */
#ifndef OVR_MULTIGRID_VECTOR_H
#define OVR_MULTIGRID_VECTOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#ifdef __x86_64__
#include <immintrin.h>
#endif

#if defined(__AVX512F__)
#define VEC 8
#elif defined(__AVX__)
#define VEC 4
#else
#define VEC 2
#endif

typedef double vec __attribute__((vector_size(VEC * 8)));
typedef int64_t ivec __attribute__((vector_size(VEC * 8)));
typedef uint64_t uvec __attribute__((vector_size(VEC * 8)));
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

/* Whether a comparison held anywhere. */
static inline bool any(ivec mask)
{
#if defined(__AVX512F__)
    return _mm512_test_epi64_mask((__m512i)mask, (__m512i)mask) != 0;
#elif defined(__AVX__)
    return _mm256_movemask_pd((__m256d)mask) != 0;
#else
    return (mask[0] | mask[1]) != 0;
#endif
}

/* a b + c, in one rounding where the machine has an instruction for it */
static inline vec fused(vec a, vec b, vec c)
{
#if defined(__AVX512F__)
    return (vec)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif defined(__FMA__)
    return (vec)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#else
    return a * b + c;
#endif
}

/* c - a b */
static inline vec less(vec c, vec a, vec b)
{
    return fused(-a, b, c);
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define SHUFFLE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#endif
#endif
#ifndef SHUFFLE
#define SHUFFLE(a, b, ...) __builtin_shuffle(a, b, (ivec){__VA_ARGS__})
#endif

/* Steps of a transposition: a pair of vectors exchange halves of their
 * fours, pairs and single values. */
#if VEC == 8
#define FOURS(a, b)                                                            \
    EXCHANGE(a, b, (0, 1, 2, 3, 8, 9, 10, 11), (4, 5, 6, 7, 12, 13, 14, 15))
#define PAIRS(a, b)                                                            \
    EXCHANGE(a, b, (0, 1, 8, 9, 4, 5, 12, 13), (2, 3, 10, 11, 6, 7, 14, 15))
#define SINGLES(a, b)                                                          \
    EXCHANGE(a, b, (0, 8, 2, 10, 4, 12, 6, 14), (1, 9, 3, 11, 5, 13, 7, 15))
#elif VEC == 4
#define PAIRS(a, b) EXCHANGE(a, b, (0, 1, 4, 5), (2, 3, 6, 7))
#define SINGLES(a, b) EXCHANGE(a, b, (0, 4, 2, 6), (1, 5, 3, 7))
#else
#define SINGLES(a, b) EXCHANGE(a, b, (0, 2), (1, 3))
#endif
#define LIST(...) __VA_ARGS__
/* NOLINTBEGIN(bugprone-macro-parentheses): a and b are assigned to */
#define EXCHANGE(a, b, low, high)                                              \
    do {                                                                       \
        vec both = SHUFFLE(a, b, LIST low);                                    \
        b = SHUFFLE(a, b, LIST high);                                          \
        a = both;                                                              \
    } while (0)
/* NOLINTEND(bugprone-macro-parentheses) */

/* v[i][l] <-> v[l][i]; written out, for registers. */
static inline void transpose(vec v[VEC])
{
#if VEC == 8
    vec a = v[0], b = v[1], c = v[2], d = v[3];
    vec e = v[4], f = v[5], g = v[6], h = v[7];
    FOURS(a, e);
    FOURS(b, f);
    FOURS(c, g);
    FOURS(d, h);
    PAIRS(a, c);
    PAIRS(b, d);
    PAIRS(e, g);
    PAIRS(f, h);
    SINGLES(a, b);
    SINGLES(c, d);
    SINGLES(e, f);
    SINGLES(g, h);
    v[0] = a, v[1] = b, v[2] = c, v[3] = d;
    v[4] = e, v[5] = f, v[6] = g, v[7] = h;
#elif VEC == 4
    vec a = v[0], b = v[1], c = v[2], d = v[3];
    PAIRS(a, c);
    PAIRS(b, d);
    SINGLES(a, b);
    SINGLES(c, d);
    v[0] = a, v[1] = b, v[2] = c, v[3] = d;
#else
    SINGLES(v[0], v[1]);
#endif
}

/* {a_0, b_0, b_1, ...} and {a_1, a_2, ..., b_last} */
static inline vec lanes_up(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 0, 8, 9, 10, 11, 12, 13, 14);
#elif VEC == 4
    return SHUFFLE(a, b, 0, 4, 5, 6);
#else
    return SHUFFLE(a, b, 0, 2);
#endif
}

static inline vec lanes_down(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 1, 2, 3, 4, 5, 6, 7, 15);
#elif VEC == 4
    return SHUFFLE(a, b, 1, 2, 3, 7);
#else
    return SHUFFLE(a, b, 1, 3);
#endif
}

/* Loops of few constant turns, in full. */
#ifdef __clang__
#define UNROLL _Pragma("unroll")
#else
#define UNROLL _Pragma("GCC unroll 32")
#endif

/* b where either is not a number */
static inline vec larger(vec a, vec b)
{
#if defined(__AVX512F__)
    return (vec)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
    return (vec)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    return choose(a > b, a, b);
#endif
}

static inline vec smaller(vec a, vec b)
{
#if defined(__AVX512F__)
    return (vec)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
    return (vec)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
    return choose(a < b, a, b);
#endif
}

/* c[0] + c[1] x + ... + c[degree] x^degree by Horner's rule */
static inline vec polynomial(int degree, const double c[], vec x)
{
    vec sum = all(c[degree]);
    for (int k = degree - 1; k >= 0; k--)
        sum = fused(sum, x, all(c[k]));
    return sum;
}

/*
 * exp(x), |x| <= 700 (not checked).  1. n = round(x/ln 2) by adding 1.5 2^52;
 * 2. r = x - n ln 2 with ln 2 in two parts, |r| < 0.347; 3. exp r = 1 + r +
 * r^2 p(r), p of degree 9 by interpolation at Chebyshev's nodes, error of
 * exp r below 2e-17; 4. n is added to the exponent.  Error below 2 ulp.
 */
static inline vec exponential(vec x)
{
    static const double p[] = {0x1.0000000000001p-1,  0x1.5555555555556p-3,
                               0x1.5555555553d68p-5,  0x1.11111111109b5p-7,
                               0x1.6c16c17889ef1p-10, 0x1.a01a01a7c2efep-13,
                               0x1.a019b9149a41cp-16, 0x1.71de0db2f6b19p-19,
                               0x1.28917c89a43a7p-22, 0x1.af389ecfc4b9cp-26};
    const vec shift = all(0x1.8p52);
    vec t = fused(x, all(0x1.71547652b82fep0), shift), n = t - shift;
    vec r = fused(n, all(-0x1.62e42fefa38p-1), x);
    r = fused(n, all(-0x1.ef35793c7673p-45), r);
    vec e = fused(r * r, polynomial(9, p, r), r) + 1.0;
    return (vec)((ivec)e + ((ivec)t << 52));
}

/* x = 2^k m with m in [0.7071, 1.4142), for x >= 0.7072 */
static inline vec mantissa(vec x, vec *k)
{
    const uint64_t half_root = 0x3fe6a09e667f3bcd; /* bits of sqrt(1/2) */
    const uvec whole = (uvec)all(0x1p52);
    uvec bits = (uvec)x, exponent = (bits - half_root) >> 52;
    *k = (vec)(exponent + whole) - 0x1p52;
    return (vec)(bits - (exponent << 52));
}

/*
 * log(2^k m) from s = (m - 1)/(m + 1), |s| < 0.1716, the division left to the
 * caller: 2 s (1 + s^2 p(s^2)) with p of degree 6 by interpolation at
 * Chebyshev's nodes, error below 5e-18, + k ln 2 in two parts.  Error below
 * 2 ulp.
 */
static inline vec logarithm(vec k, vec s)
{
    static const double p[] = {0x1.5555555555558p-2, 0x1.99999999952e2p-3,
                               0x1.2492492df148dp-3, 0x1.c71c62e5800a1p-4,
                               0x1.7462b4ab2ef6bp-4, 0x1.39fe606542ddep-4,
                               0x1.2b584aae78a57p-4};
    vec s2 = s * s, twice = s + s;
    vec small = fused(twice * s2, polynomial(6, p, s2),
                      k * 0x1.ef35793c7673p-45);
    return fused(k, all(0x1.62e42fefa38p-1), twice + small);
}

#endif
