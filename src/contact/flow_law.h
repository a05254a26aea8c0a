/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Table of the exact integrals of a rheological model over the film, for laws f
 * without closed integrals (gamma = (tau0/eta) f(tau/tau0), f odd, f'(0) = 1):
 *
 *     (1/2) int_-1^1 f(a + g s) ds = s_N          a: mean stress
 *     Phi = (3/(2 g)) int_-1^1 s f(a + g s) ds    E = eps Phi
 *
 * ln Phi and ln(a/s_N), both even in s_N and g, are computed with 64 Gauss
 * points and Newton's method for a at asinh s_N = i/4 and asinh g = j/4, and
 * interpolated by bicubic B-splines. From the splines the table gets values and
 * slopes with respect to s_N, g and both at 1 + s_N and 1 + g = 2^k (1, 5/4,
 * 3/2, 7/4). Finding such a cell needs no logarithm. Interpolation in the table
 * is bicubic with continuous slopes; g is limited to 255, and the continuation
 * beyond s_N = 2^30 is linear in its logarithm. The error of Phi is below 1e-3,
 * and 1e-4 on average (unit/flow_test). The solver uses the table everywhere.
 *
 * Carreau-Yasuda, in the textbook's form or solved for the rate:
 *     rate    tau = eta gamma (1 + (eta gamma/tau0)^a)^((n - 1)/a)
 *     stress  f(x) = x (1 + x^a)^((1/n - 1)/a)
 */
#ifndef OVR_CONTACT_FLOW_LAW_H
#define OVR_CONTACT_FLOW_LAW_H

#include "base/arena.h"
#include "overroll/contact.h"

/* Octaves of 1 + s_N and 1 + g, with four cells each; nodes per row. */
enum {
    OVR_LAW_SLIDES = 4 * 30,
    OVR_LAW_GRADIENTS = 4 * 8,
    OVR_LAW_ROW = OVR_LAW_GRADIENTS + 1,
    OVR_LAW_SIZE = 4 * (OVR_LAW_SLIDES + 1) * OVR_LAW_ROW
};

/* Largest 1 + s_N and 1 + g inside the table. */
#define OVR_LAW_MAX_SLIDE 0x1.fffffffffffffp29
#define OVR_LAW_MAX_GRADIENT 0x1.fffffffffffffp7

/* Table of f: ln f and d ln f/d ln x at ln x = MIN + STEP k, cubic between them
 * (error below 1e-8); Newtonian below the table, a power law beyond it. */
#define OVR_CURVE_MIN (-13.8)
#define OVR_CURVE_STEP 0.02
enum { OVR_CURVE_POINTS = 2073 };

typedef struct ovr_curve {
    double value[OVR_CURVE_POINTS], slope[OVR_CURVE_POINTS];
} ovr_curve;

/* f and its derivative for any x. */
double ovr_curve_at(const ovr_curve *f, double x, double *by_x);

/* Node (i, j) starts at index 4 (i OVR_LAW_ROW + j): value, slope with respect
 * to s_N, to g, and to both. */
struct ovr_flow_law {
    ovr_arena arena;
    double flow[OVR_LAW_SIZE];   /* for ln Phi */
    double stress[OVR_LAW_SIZE]; /* for ln(a/s_N) */
    ovr_curve f;
};

#endif
