/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A flow law by the table of its exact integrals over the film, for laws f that
 * have no closed ones (gamma = (tau0/eta) f(tau/tau0), f odd, f'(0) = 1):
 *
 *     (1/2) int_-1^1 f(a + g s) ds = s_N          a: mean stress
 *     Phi = (3/(2 g)) int_-1^1 s f(a + g s) ds    E = eps Phi
 *
 * ln Phi and ln(a/s_N), both even in s_N and g, at asinh s_N = i/4 up to s_N =
 * 1e9 and asinh g = j/4 up to g = 300, by 64 points of Gauss and Newton's
 * method in a; between them bicubic B-splines, beyond s_N linear in its
 * logarithm.  Error of Phi below 1e-3, 1e-4 in the mean (unit/flow_test): the
 * table is the law.
 *
 * Carreau-Yasuda, in the textbook's form or solved for the rate:
 *     rate    tau = eta gamma (1 + (eta gamma/tau0)^a)^((n - 1)/a)
 *     stress  f(x) = x (1 + x^a)^((1/n - 1)/a)
 */
#ifndef OVR_CONTACT_FLOW_LAW_H
#define OVR_CONTACT_FLOW_LAW_H

#include "base/arena.h"
#include "overroll/contact.h"

/* Nodes of the table a unit of asinh; intervals; coefficients a row, one more
 * on both sides. */
enum {
    OVR_LAW_PER = 4,
    OVR_LAW_SLIDES = 86,
    OVR_LAW_GRADIENTS = 26,
    OVR_LAW_ROW = OVR_LAW_GRADIENTS + 3,
    OVR_LAW_SIZE = (OVR_LAW_SLIDES + 3) * OVR_LAW_ROW
};

/* f itself: ln f and d ln f/d ln x at ln x = LEAST + STEP k, cubic between them
 * (error below 1e-8); Newtonian below, a power beyond. */
#define OVR_CURVE_LEAST (-13.8)
#define OVR_CURVE_STEP 0.02
enum { OVR_CURVE_POINTS = 2073 };

typedef struct ovr_curve {
    double value[OVR_CURVE_POINTS], slope[OVR_CURVE_POINTS];
} ovr_curve;

/* f and its derivative at any x. */
double ovr_curve_at(const ovr_curve *f, double x, double *by_x);

/* Coefficients of the B-splines, [(i + 1) OVR_LAW_ROW + j + 1]. */
struct ovr_flow_law {
    ovr_arena arena;
    double flow[OVR_LAW_SIZE];   /* of ln Phi */
    double stress[OVR_LAW_SIZE]; /* of ln(a/s_N) */
    ovr_curve f;
};

/* Weights of a cubic B-spline at t in [0, 1] between its second and third
 * coefficient, and their derivatives. */
static inline void ovr_law_weights(double t, double b[4], double d[4])
{
    double r = 1 - t;
    b[0] = r * r * r / 6;
    b[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
    b[2] = (1 + 3 * t + 3 * t * t - 3 * t * t * t) / 6;
    b[3] = t * t * t / 6;
    d[0] = -0.5 * r * r;
    d[1] = t * (1.5 * t - 2);
    d[2] = 0.5 + t - 1.5 * t * t;
    d[3] = 0.5 * t * t;
}

#endif
