/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Logarithms and powers of two of whole vectors, by tables of 16 and short
 * polynomials, without division.
 *
 *     z log2 x = z k + z log2(1/c) + z log2(1 + r),   x = 2^k m,  r = m c - 1
 *     s 2^y    = 2^n (s 2^(j/16)) 2^f,                y = n + j/16 + f
 *
 * with c = 1/(1 + (j + 1/2)/16) for the j that the first four bits of m after
 * the point are: |r| <= 1/33.  The factors z and s cost nothing, because they
 * are included in tables computed before the loop.
 *
 * The polynomials are interpolated at Chebyshev's nodes, in 60 digits: log2(1 +
 * r)/r by degree 7, error of log2 below 3e-17; (2^f - 1)/f, |f| <= 1/32, by
 * degree 5, error of 2^f below 2e-17.  Rounding errors are therefore dominant:
 * below 2 ulp of z k for z log2 x, and below 1 ulp for 2^y.  2^0 is 1.
 */
#ifndef OVR_MULTIGRID_POWER_H
#define OVR_MULTIGRID_POWER_H

#include "multigrid/vector.h"

/* Both tables are aligned like a vector, so that no lookup spans two cache
 * lines. */
typedef struct table16 {
    _Alignas(64) double value[16];
} table16;

typedef struct log_table {
    table16 center;        /* z log2(1/c) */
    double coefficient[8]; /* polynomial coefficients of z log2(1 + r)/r */
    double z;
} log_table;

/* value[j mod 16] */
static inline vec lookup(const table16 *table, uvec j)
{
#if defined(__AVX512F__)
    return (vec)_mm512_permutex2var_pd(_mm512_load_pd(table->value), (__m512i)j,
                                       _mm512_load_pd(table->value + 8));
#else
    vec found;
    j &= 15;
    for (int l = 0; l < VEC; l++)
        found[l] = table->value[j[l]];
    return found;
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

/* x = 2^k m, 1 <= m < 2, for normal x > 0 */
static inline vec exponent(vec x)
{
#if defined(__AVX512F__)
    return (vec)_mm512_getexp_pd((__m512d)x);
#else
    const double whole = 0x1p52; /* adding it leaves the integer part in the
                                  * last bits */
    return (vec)(((uvec)x >> 52) | (uvec)all(whole)) - (whole + 1023);
#endif
}

static inline vec mantissa(vec x)
{
#if defined(__AVX512F__)
    return (vec)_mm512_getmant_pd((__m512d)x, _MM_MANT_NORM_1_2,
                                  _MM_MANT_SIGN_zero);
#else
    return (vec)((uvec)x << 12 >> 12 | (uvec)all(1));
#endif
}

static const table16 log_inverse = {
    {0x1.f07c1f07c1f08p-1, 0x1.d41d41d41d41dp-1, 0x1.bacf914c1badp-1,
     0x1.a41a41a41a41ap-1, 0x1.8f9c18f9c18fap-1, 0x1.7d05f417d05f4p-1,
     0x1.6c16c16c16c17p-1, 0x1.5c9882b931057p-1, 0x1.4e5e0a72f0539p-1,
     0x1.4141414141414p-1, 0x1.3521cfb2b78c1p-1, 0x1.29e4129e4129ep-1,
     0x1.1f7047dc11f7p-1, 0x1.15b1e5f75270dp-1, 0x1.0c9714fbcda3bp-1,
     0x1.041041041041p-1}};

static inline void make_log_table(double z, log_table *table)
{
    static const table16 center = {
        {0x1.6bad3758efd81p-5, 0x1.08c588cda79e5p-3, 0x1.acf5e2db4ec91p-3,
         0x1.24407ab0e073ap-2, 0x1.6e221cd9d0cddp-2, 0x1.b47ebf73882a1p-2,
         0x1.f7a8568cb06cep-2, 0x1.1bf311e95d00ep-1, 0x1.3abb3faa02168p-1,
         0x1.5848226989d34p-1, 0x1.74b1fd64e0754p-1, 0x1.900e6160002cep-1,
         0x1.aa708f58014d4p-1, 0x1.c3e9ca2e1a055p-1, 0x1.dc899ab3ff56cp-1,
         0x1.f45e08bcf0656p-1}};
    static const double coefficient[8] = {
        0x1.71547652b82fap0,   -0x1.71547652b82f7p-1, 0x1.ec709dc428eccp-2,
        -0x1.715476533332dp-2, 0x1.2776b9b451c56p-2,  -0x1.ec70895383881p-3,
        0x1.a6b1e4e0d254fp-3,  -0x1.71df85ce2f7f8p-3};
    for (int j = 0; j < 16; j++)
        table->center.value[j] = z * center.value[j];
    for (int k = 0; k < 8; k++)
        table->coefficient[k] = z * coefficient[k];
    table->z = z;
}

/* z log2 x, for normal x > 0 */
static inline vec scaled_log2(const log_table *table, vec x)
{
    uvec j = (uvec)x >> 48;
    vec r = fused(mantissa(x), lookup(&log_inverse, j), all(-1));
    vec whole = fused(exponent(x), all(table->z), lookup(&table->center, j));
    return fused(r, polynomial(7, table->coefficient, r), whole);
}

/* s 2^(j/16) for scaled_exp2, minus j at the bits to which n + j/16 is added:
 * the exponent and the four bits below it. */
typedef table16 exp_table;
static inline void make_exp_table(double s, exp_table *table)
{
    static const table16 root = {
        {0x1p0, 0x1.0b5586cf9890fp0, 0x1.172b83c7d517bp0, 0x1.2387a6e756238p0,
         0x1.306fe0a31b715p0, 0x1.3dea64c123422p0, 0x1.4bfdad5362a27p0,
         0x1.5ab07dd485429p0, 0x1.6a09e667f3bcdp0, 0x1.7a11473eb0187p0,
         0x1.8ace5422aa0dbp0, 0x1.9c49182a3f09p0, 0x1.ae89f995ad3adp0,
         0x1.c199bdd85529cp0, 0x1.d5818dcfba487p0, 0x1.ea4afa2a490dap0}};
    for (int j = 0; j < 16; j++) {
        union {
            double number;
            uint64_t bits;
        } entry = {s * root.value[j]};
        entry.bits -= (uint64_t)j << 48;
        table->value[j] = entry.number;
    }
}

/* s 2^y if the result is a normal number (not checked); for s = 0 at most 2^y
 * times the smallest normal number */
static inline vec scaled_exp2(const exp_table *table, vec y)
{
    static const double p[6] = {0x1.62e42fefa39f3p-1,  0x1.ebfbdff82c59p-3,
                                0x1.c6b08d6f2a289p-5,  0x1.3b2ab6fb41213p-7,
                                0x1.5d897e525c216p-10, 0x1.430a1d08ec681p-13};
    const vec shift = all(0x1.8p48); /* leaves 16 y, rounded, in the last bits
                                      */
    vec shifted = y + shift, f = y - (shifted - shift);
    uvec j = (uvec)shifted;
    vec root = (vec)((uvec)lookup(table, j) + (j << 48));
    return fused(root * f, polynomial(5, p, f), root);
}

#endif
