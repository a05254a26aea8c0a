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
    double w[3], first[2]; /* wedge weights, and in row 1 */
    double cT;             /* of q in the time derivative */
    bool in_line;          /* gaps H^3 of two nodes in line, else both meant */
    bool logarithmic;      /* and the logarithmic mean of 1/eta */
    bool backward;         /* um < 0: the wedge from the right, times |Cu| */
    double force;          /* asked for D sum P */
    double *X, *gap, *F;   /* gap X^2/2 - S, history term */
    double *P, *H, *q;     /* solution */
    double *rho, *eta;
    double H0;
    double *kernel;                 /* K/pi at distances 0..n-1 D */
    double (*thickening)(double H); /* factor on the viscosity, or NULL */
    /* cavitated nodes are chosen by P and r together, without clipping, for
     * film ends that move far (Hintermueller, Ito & Kunisch 2002) */
    bool primal_dual;
} dense;

dense *dense_make(double M, double L, int level, ovr_scheme scheme);
void dense_free(dense *d);

/* Another end of the domain; before a surface is set. */
void dense_outlet(dense *d, double X_b);

/* Sets gap = X^2/2 - S. */
void dense_surface(dense *d, const double *S);

/* Newton from the P and H0 it has; fails the test if it does not converge. */
void dense_solve(dense *d);

/* Whether so many steps of it are enough. */
bool dense_converges(dense *d, int maximum);

#endif
