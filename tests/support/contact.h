/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The contact of the reference values, by Moes' numbers. */
#ifndef TESTS_SUPPORT_CONTACT_H
#define TESTS_SUPPORT_CONTACT_H

#include "overroll/simulation.h"

typedef struct test_contact {
    ovr_contact contact;
    ovr_lubricant lubricant;
} test_contact;

/* alpha = 1.7e-8 1/Pa, p0 = 1.98e8 Pa, z = 0.68, as in the paper. */
test_contact test_contact_make(double M, double L);

/* The state that truths are of, whatever the program's defaults: [-4, 1.5],
 * second order, upstream wedge and BDF2. */
ovr_options test_options(void);

/* A simulation of it, or the test fails. */
ovr_simulation *test_simulation(double M, double L, const ovr_options *options);

/* Features of the reference runs, an ovr_heights:
 *   'l'  A 10^(-10 xi^2) cos(2 pi xi), xi = (X - start - u T)/width
 *   's'  the same, growing by quintic smoothstep over `grow`
 *   'w'  A s(T/grow) cos(2 pi (X - u T)/width) */
typedef struct test_feature {
    char kind;
    double A, width, start, u, grow;
} test_feature;
void test_feature_heights(void *feature, double T, size_t n, const double *X,
                          double *S);

#endif
