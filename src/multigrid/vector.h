/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Vector type of the width of the instruction set for which a kernel file is
 * compiled.
 *
 * GCC's vector extension (gcc and clang, any machine).  Operations are
 * elementwise and fused only in fused(), if the machine has such an
 * instruction: results on one machine are always bit-identical, and instruction
 * sets agree to rounding. Arrays come from ovr_field (field.h): aligned, with
 * space for some vectors before the first and after the last element.
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
typedef vec num; /* see scalar.h */
typedef ivec truth;
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

/* x with another first element */
static inline vec with_first(vec x, double first)
{
    x[0] = first;
    return x;
}

/* mask ? a : b, for a mask made by a comparison */
static inline vec choose(ivec mask, vec a, vec b)
{
    return (vec)((mask & (ivec)a) | (~mask & (ivec)b));
}

/* True if the mask is true in any element. */
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

/* x_0 + x_1 + ..., in this order */
static inline double sum_of_lanes(vec x)
{
    double sum = x[0];
    for (int l = 1; l < VEC; l++)
        sum += x[l];
    return sum;
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

/* Steps of a transposition: two vectors exchange halves, pairs or single
 * values. */
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

/* v[i][l] <-> v[l][i]; unrolled so that all vectors stay in registers. */
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

/* Vector J of an array in lanes (lanes.h). */
static inline vec at(const double *x, ptrdiff_t J)
{
    return load(x + J * VEC);
}

static inline void put(double *x, ptrdiff_t J, vec v)
{
    store(x + J * VEC, v);
}

/* Vector J of a set of nodes (kernels.h) as a mask, and back. */
static inline ivec in_set(const unsigned char *set, ptrdiff_t J)
{
#if VEC == 8
    return (ivec)_mm512_movm_epi64(set[J]);
#elif VEC == 4
#define LANES(m)                                                               \
    {                                                                          \
        -((m)&1), -((m) >> 1 & 1), -((m) >> 2 & 1), -((m) >> 3)                \
    }
    static const ivec masks[16] = {LANES(0),  LANES(1),  LANES(2),  LANES(3),
                                   LANES(4),  LANES(5),  LANES(6),  LANES(7),
                                   LANES(8),  LANES(9),  LANES(10), LANES(11),
                                   LANES(12), LANES(13), LANES(14), LANES(15)};
#undef LANES
    return masks[set[J]];
#else
    static const ivec masks[4] = {{0, 0}, {-1, 0}, {0, -1}, {-1, -1}};
    return masks[set[J]];
#endif
}

static inline void put_set(unsigned char *set, ptrdiff_t J, ivec mask)
{
#if VEC == 8
    set[J] = _mm512_movepi64_mask((__m512i)mask);
#elif VEC == 4
    set[J] = (unsigned char)_mm256_movemask_pd((__m256d)mask);
#elif defined __SSE2__
    set[J] = (unsigned char)_mm_movemask_pd((__m128d)mask);
#else
    set[J] = (unsigned char)((mask[0] & 1) | (mask[1] & 2));
#endif
}

/* The integer part of numbers from 0 to 2^31, as table indices. */
typedef uvec cell;

static inline cell whole_part(vec x)
{
    vec whole = x + 0x1p52 - 0x1p52; /* rounded to nearest */
    whole -= (vec)((ivec)all(1) & (whole > x));
    return (uvec)(whole + 0x1p52) & 0xffffffff;
}

static inline vec from_whole(cell k)
{
    return (vec)(k | (uvec)all(0x1p52)) - 0x1p52;
}

static inline vec gather(const double *x, cell k)
{
    vec found;
    for (int l = 0; l < VEC; l++)
        found[l] = x[k[l]];
    return found;
}

/* Copies the ends of lanes of S nodes into `halo` vectors on both sides; values
 * beyond the ends of the grid do not change. */
static inline void repeat_ends(double *x, ptrdiff_t S, ptrdiff_t halo)
{
    for (ptrdiff_t J = -halo; J < 0; J++)
        put(x, J, lanes_up(at(x, J), at(x, S + J)));
    for (ptrdiff_t J = S; J < S + halo; J++)
        put(x, J, lanes_down(at(x, J - S), at(x, J)));
}

/* INLINE unrolls functions for constant arguments at their callers. */
#define INLINE inline __attribute__((always_inline))

/* Loops of few constant passes, unrolled. */
#ifdef __clang__
#define UNROLL _Pragma("unroll")
#else
#define UNROLL _Pragma("GCC unroll 32")
#endif

/* 1/sqrt(x) of normal x > 0, to some 2 ulp */
static inline vec inverse_root(vec x)
{
#if defined(__AVX512F__)
    vec y = (vec)_mm512_rsqrt14_pd((__m512d)x), half = 0.5 * x;
    y *= less(all(1.5), half * y, y);
    return y * less(all(1.5), half * y, y);
#elif defined(__AVX__)
    return 1 / (vec)_mm256_sqrt_pd((__m256d)x);
#elif defined(__SSE2__)
    return 1 / (vec)_mm_sqrt_pd((__m128d)x);
#else
    return 1 / (vec){__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}

/* maximum of a and b; b if either is NaN */
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

/* For arrays of n >= VEC elements in the order of the nodes, where the last
 * vector overlaps the one before: start of the vector at i, and its new
 * elements. */
static inline size_t start_of(size_t i, size_t n)
{
    return i + VEC <= n ? i : n - VEC;
}

static inline ivec new_elements(size_t i, size_t n)
{
    ivec lane;
    for (int l = 0; l < VEC; l++)
        lane[l] = l;
    return lane >= (int64_t)(i - start_of(i, n)) - (ivec){0};
}

#endif
