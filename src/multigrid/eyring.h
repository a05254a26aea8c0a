/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A, B and sinh g/g of Eyring's law (flow.h) for whole vectors.
 *
 * From e^x, x = |g| <= 200, with one division: d = 1/(e^x x (e^2x - 1)).
 * cosh x - sinh x/x loses 3/x^2 roundings to cancellation: below x = 1/4 series
 *     sinh x/x = 1 + x^2/6 + x^4/120 + ...,  A = 1 + x^2/10 + x^4/280 + ...
 *     B = 1 - x^2/6 + 7 x^4/360 - ..., and one step of Newton for 1/(sinh x/x)
 * Errors below 2e-14.
 */
#ifndef OVR_MULTIGRID_EYRING_H
#define OVR_MULTIGRID_EYRING_H

#include "multigrid/power.h"

typedef struct eyring {
    vec A, B, shc; /* shc: sinh g/g */
    vec square;    /* g^2 */
} eyring;

static inline void eyring_small(vec square, eyring *f)
{
    static const double shc[] = {1, 1. / 6, 1. / 120, 1. / 5040, 1. / 362880};
    static const double A[] = {1, 1. / 10, 1. / 280, 1. / 15120, 1. / 1330560};
    static const double B[] = {1, -1. / 6, 7. / 360, -31. / 15120,
                               127. / 604800};
    f->shc = polynomial(4, shc, square);
    f->A = polynomial(4, A, square);
    f->B = polynomial(4, B, square);
    f->B = fused(f->B, less(all(1), f->shc, f->B), f->B);
}

/* `growth` is the table of 2^y. */
static inline eyring eyring_at(const exp_table *growth, vec g)
{
    const double log2_e = 0x1.71547652b82fep0;
    eyring small, f;
    vec x = smaller(larger(g, -g), all(200));
    vec u = scaled_exp2(growth, log2_e * x), v = fused(u, u, all(-1));
    vec d = 1 / (u * x * v), inv_x = d * u * v, inv_u = d * x * v;
    f.square = x * x;
    eyring_small(f.square, &small);
    f.shc = 0.5 * (u - inv_u) * inv_x;
    f.A = 3 * (0.5 * (u + inv_u) - f.shc) * (inv_x * inv_x);
    f.B = 2 * d * (u * u) * f.square;
    ivec near = x < 0.25;
    f.shc = choose(near, small.shc, f.shc);
    f.A = choose(near, small.A, f.A);
    f.B = choose(near, small.B, f.B);
    return f;
}

/* scale asinh y for y >= 0: by the logarithm (of 2 y beyond 1e100), or by the
 * series where the logarithm would lose all digits */
static inline vec arsinh(const log_table *ln, double scale, vec y)
{
    vec z = smaller(y, all(1e100)), square = z * z, whole = square + 1;
    vec sum = choose(y > 1e100, 2 * y, z + whole * inverse_root(whole));
    vec series = y * (1 - square / 6 + square * square * (3. / 40));
    return choose(y < 1e-3, scale * series, scaled_log2(ln, sum));
}

#endif
