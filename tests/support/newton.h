/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dense reference solution: Newton's method with a full Jacobian by differences
 * and GSL's LU, on the discrete equations programmed separately from the solver
 * of the library. O(n^3): small n only. */
#ifndef TESTS_SUPPORT_NEWTON_H
#define TESTS_SUPPORT_NEWTON_H

#include "contact.h"
#include "overroll/simulation.h"

typedef struct dense {
    test_contact contact;
    size_t n;
    double D, X_a;
    double w[3], first[2]; /* weights of the wedge term; in row 1 */
    double cT;             /* factor of q in the time derivative */
    bool in_line;          /* harmonic mean of H^3, otherwise arithmetic mean */
    bool logarithmic;      /* and the logarithmic mean of 1/eta */
    bool backward;         /* um < 0: wedge term upstream in -x, times |Cu| */
    double force;          /* required value of D sum P */
    double *X, *gap, *F;   /* gap X^2/2 - S, history term */
    double *P, *H, *q;     /* solution */
    double *rho, *eta;
    double H0;
    double *kernel;                 /* K/pi at distances 0..n-1 D */
    double (*thickening)(double H); /* factor on the viscosity, or NULL */
    bool primal_dual; /* select cavitated nodes by P and r, without clipping,
                       * for meniscus positions that move far (Hintermueller,
                       * Ito & Kunisch 2002) */
} dense;

dense *dense_make(double M, double L, int level, ovr_scheme scheme);
void dense_free(dense *d);

/* Sets the end of the domain; must be called before a surface is set. */
void dense_outlet(dense *d, double X_b);

/* Sets gap = X^2/2 - S. */
void dense_surface(dense *d, const double *S);

/* Solves from the present P and H0; fails the test if it does not converge. */
void dense_solve(dense *d);

/* Solves with at most `maximum` steps; returns true if it converged. */
bool dense_converges(dense *d, int maximum);

#endif
