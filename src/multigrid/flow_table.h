/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A flow law's table (contact/flow_law.h) for whole vectors: ln Phi and its
 * slopes by ln s_N and ln g, or ln(a/s_N).
 */
#ifndef OVR_MULTIGRID_FLOW_TABLE_H
#define OVR_MULTIGRID_FLOW_TABLE_H

#include "contact/flow_law.h"
#include "multigrid/power.h"

/* Where in the table: interval and place in it, by s_N and by g; d asinh s/d
 * ln s of both. */
typedef struct law_place {
    ivec corner; /* of the 16 coefficients */
    vec t[2], chain[2];
} law_place;

/* Least s_N: its square is nothing beside 1, and slopes by ln s_N have digits
 * that can be divided by s_N. */
#define OVR_LAW_LEAST 1e-4

/* asinh x times PER for x >= 0 with the slope of asinh by ln x; `log`: the
 * table of PER ln x. */
static inline vec law_asinh(const log_table *log, vec x, vec *chain)
{
    vec z = smaller(x, all(1e100)), whole = fused(z, z, all(1));
    vec y = inverse_root(whole), sum = fused(whole, y, z);
    *chain = z * y;
    return scaled_log2(log, choose(x > 1e100, 2 * x, sum));
}

/* Interval of `at` among n, as a number. */
static inline vec law_interval(vec at, int n)
{
    const double shift = 0x1p52; /* leaves the whole part as last bits */
    vec inside = smaller(at, all(n - 0.5));
    vec whole = (inside + shift) - shift; /* rounded */
    return choose(whole > inside, whole - 1, whole);
}

static inline law_place law_find(const log_table *log, vec s_N, vec g)
{
    law_place p;
    vec x = larger(g, -g), at[2], k[2];
    at[0] = law_asinh(log, s_N, &p.chain[0]);
    at[1] = law_asinh(log, smaller(x, all(300)), &p.chain[1]);
    at[1] = larger(at[1], all(0));
    k[0] = law_interval(at[0], OVR_LAW_SLIDES);
    k[1] = law_interval(at[1], OVR_LAW_GRADIENTS);
    p.t[0] = at[0] - k[0];
    p.t[1] = at[1] - k[1];
    vec corner = fused(k[0], all(OVR_LAW_ROW), k[1]);
    for (int l = 0; l < VEC; l++)
        p.corner[l] = (int64_t)corner[l];
    return p;
}

static inline vec law_gather(const double *table, ivec at)
{
#if defined(__AVX512F__)
    return (vec)_mm512_i64gather_pd((__m512i)at, table, 8);
#else
    vec found;
    for (int l = 0; l < VEC; l++)
        found[l] = table[at[l]];
    return found;
#endif
}

static inline void law_weights(vec t, vec b[4], vec d[4])
{
    vec r = 1 - t, s = t * t;
    b[0] = r * r * r * (1. / 6);
    b[3] = s * t * (1. / 6);
    b[1] = (4 - 6 * s + 3 * s * t) * (1. / 6);
    b[2] = 1 - b[0] - b[1] - b[3];
    d[0] = -0.5 * r * r;
    d[3] = 0.5 * s;
    d[1] = t * (1.5 * t - 2);
    d[2] = -d[0] - d[1] - d[3];
}

/* The spline at p; slope[0] by ln s_N, slope[1] by ln g.  Straight beyond the
 * last s_N. */
static inline vec law_at(const double *table, const law_place *p, vec slope[2])
{
    vec b[2][4], d[2][4], value = all(0), by_s = all(0), by_g = all(0);
    vec inside = smaller(p->t[0], all(1));
    law_weights(inside, b[0], d[0]);
    law_weights(p->t[1], b[1], d[1]);
    for (int m = 0; m < 4; m++) {
        vec row = all(0), along = all(0);
        for (int k = 0; k < 4; k++) {
            vec c = law_gather(table + m * OVR_LAW_ROW + k, p->corner);
            row = fused(b[1][k], c, row);
            along = fused(d[1][k], c, along);
        }
        value = fused(b[0][m], row, value);
        by_s = fused(d[0][m], row, by_s);
        by_g = fused(b[0][m], along, by_g);
    }
    value = fused(by_s, p->t[0] - inside, value);
    slope[0] = OVR_LAW_PER * p->chain[0] * by_s;
    slope[1] = OVR_LAW_PER * p->chain[1] * by_g;
    return value;
}

#endif
