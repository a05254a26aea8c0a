/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A flow law by the table of its exact integrals over the film, for laws f that
 * have no closed ones (gamma = (tau0/eta) f(tau/tau0), f odd, f'(0) = 1):
 *
 *     (1/2) int_-1^1 f(a + g s) ds = s_N          a: mean stress
 *     Phi = (3/(2 g)) int_-1^1 s f(a + g s) ds    E = eps Phi
 *
 * ln Phi and ln(a/s_N), both even in s_N and g: by 64 points of Gauss and
 * Newton's method in a, at asinh s_N = i/4 and asinh g = j/4 with bicubic
 * B-splines between them.  From these the table has values and slopes by s_N,
 * by g and by both at 1 + s_N and 1 + g = 2^k (1, 5/4, 3/2, 7/4), whose cells
 * need no logarithm to find: bicubic between them, with continuous slopes; g
 * held at 255, beyond s_N = 2^30 linear in its logarithm.  Error of Phi below
 * 1e-3, 1e-4 in the mean (unit/flow_test): the table is the law.
 *
 * Carreau-Yasuda, in the textbook's form or solved for the rate:
 *     rate    tau = eta gamma (1 + (eta gamma/tau0)^a)^((n - 1)/a)
 *     stress  f(x) = x (1 + x^a)^((1/n - 1)/a)
 */
#ifndef OVR_CONTACT_FLOW_LAW_H
#define OVR_CONTACT_FLOW_LAW_H

#include "base/arena.h"
#include "overroll/contact.h"

/* Octaves of 1 + s_N and 1 + g, in four cells each; nodes a row. */
enum {
    OVR_LAW_SLIDES = 4 * 30,
    OVR_LAW_GRADIENTS = 4 * 8,
    OVR_LAW_ROW = OVR_LAW_GRADIENTS + 1,
    OVR_LAW_SIZE = 4 * (OVR_LAW_SLIDES + 1) * OVR_LAW_ROW
};

/* The last 1 + s_N and 1 + g within. */
#define OVR_LAW_MAX_SLIDE 0x1.fffffffffffffp29
#define OVR_LAW_MAX_GRADIENT 0x1.fffffffffffffp7

/* f itself: ln f and d ln f/d ln x at ln x = LEAST + STEP k, cubic between them
 * (error below 1e-8); Newtonian below, a power beyond. */
#define OVR_CURVE_MIN (-13.8)
#define OVR_CURVE_STEP 0.02
enum { OVR_CURVE_POINTS = 2073 };

typedef struct ovr_curve {
    double value[OVR_CURVE_POINTS], slope[OVR_CURVE_POINTS];
} ovr_curve;

/* f and its derivative at any x. */
double ovr_curve_at(const ovr_curve *f, double x, double *by_x);

/* Node (i, j) begins at 4 (i OVR_LAW_ROW + j) with its value, then come slopes
 * by s_N, by g and by both. */
struct ovr_flow_law {
    ovr_arena arena;
    double flow[OVR_LAW_SIZE];   /* of ln Phi */
    double stress[OVR_LAW_SIZE]; /* of ln(a/s_N) */
    ovr_curve f;
};

#endif
