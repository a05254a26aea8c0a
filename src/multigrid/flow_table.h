/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Interpolation in the table of a rheological model (contact/flow_law.h) for
 * whole vectors: ln Phi or ln(a/s_N) and the slopes with respect to s_N and g.
 * The leading bits of 1 + s_N and 1 + g determine the cell; the values at its
 * corners are stored next to each other in pairs.
 */
#ifndef OVR_MULTIGRID_FLOW_TABLE_H
#define OVR_MULTIGRID_FLOW_TABLE_H

#include <string.h>

#include "contact/flow_law.h"
#include "multigrid/power.h"

/* A cell along s_N or g: its number; the weights of value and slope at its
 * first and second node. The same for the derivative. */
typedef struct law_cell {
    uvec number;
    vec b[4], d[4];
} law_cell;

/* Cell of x = 1 + s within the table. */
static inline law_cell law_cell_of(vec x)
{
    const uint64_t one = 1023, octave = 0x7ffULL << 52, part = 1ULL << 50;
    uvec bits = (uvec)x, power = bits & octave;
    vec width = (vec)(power - (2ULL << 52)); /* 2^k/4 */
    vec inverse = (vec)((2048ULL << 52) - power);
    vec t = (x - (vec)(bits & ~(part - 1))) * inverse, r = 1 - t;
    vec rise = t * (6 * r) * inverse, far = width * t * r;
    law_cell c = {.number = (bits >> 50) - 4 * one};
    c.b[2] = t * t * less(all(3), all(2), t);
    c.b[0] = 1 - c.b[2];
    c.b[1] = far * r;
    c.b[3] = -far * t;
    c.d[0] = -rise;
    c.d[1] = r * less(all(1), all(3), t);
    c.d[2] = rise;
    c.d[3] = t * less(all(-2), all(-3), t);
    return c;
}

/* Loads the table values at the corners at both ends of a cell along g. */
static inline void law_corners(const double *table, uvec place, vec v[8])
{
    int64_t at[VEC];
    memcpy(at, &place, sizeof at);
    UNROLL
    for (int k = 0; k < 8; k += VEC) {
        for (int l = 0; l < VEC; l++)
            v[k + l] = load(table + at[l] + k);
        transpose(v + k);
    }
}

static inline vec law_sum(const vec w[4], vec a, vec by_a, vec b, vec by_b)
{
    return fused(w[3], by_b, fused(w[2], b, fused(w[1], by_a, w[0] * a)));
}

/* A table value and its slopes with respect to s_N and g; s_N and |g| limited
 * to the table, and the excess of s_N beyond the table. */
typedef struct law_value {
    vec value, by_s, by_g, s, g, beyond;
} law_value;

static inline law_value law_at(const double *table, vec s_N, vec g)
{
    /* limits the argument to the table, also if it is NaN (films of failed or
     * crossing iterates) */
    vec x = smaller(larger(s_N, all(0)) + 1, all(OVR_LAW_MAX_SLIDE));
    vec y = smaller(larger(g, -g) + 1, all(OVR_LAW_MAX_GRADIENT));
    law_cell by_s = law_cell_of(x), by_g = law_cell_of(y);
    uvec row = (by_s.number << 5) + by_s.number + by_g.number;
    vec along[2], rise[2], slope[2], cross_film[2];
    for (int k = 0; k < 2; k++) {
        vec v[8];
        law_corners(table, (row + (uint64_t)(k * OVR_LAW_ROW)) << 2, v);
        along[k] = law_sum(by_g.b, v[0], v[2], v[4], v[6]);
        rise[k] = law_sum(by_g.b, v[1], v[3], v[5], v[7]);
        slope[k] = law_sum(by_g.d, v[0], v[2], v[4], v[6]);
        cross_film[k] = law_sum(by_g.d, v[1], v[3], v[5], v[7]);
    }
    return (law_value){
        law_sum(by_s.b, along[0], rise[0], along[1], rise[1]),
        law_sum(by_s.d, along[0], rise[0], along[1], rise[1]),
        law_sum(by_s.b, slope[0], cross_film[0], slope[1], cross_film[1]),
        x - 1,
        y - 1,
        larger(s_N * (1 / (OVR_LAW_MAX_SLIDE - 1)), all(1))};
}

/* e^value; a power of s_N beyond the last table entry. */
static inline vec law_power(const exp_table *growth, const log_table *log2,
                            const law_value *at)
{
    const double log2_e = 0x1.71547652b82fep0;
    vec power = log2_e * at->value;
    if (any(at->beyond > 1))
        power = fused(at->s * at->by_s, scaled_log2(log2, at->beyond), power);
    return scaled_exp2(growth, power);
}

#endif
