/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contact and lubricant of the reference values, for Moes' numbers M and L. */
#ifndef TESTS_SUPPORT_CONTACT_H
#define TESTS_SUPPORT_CONTACT_H

#include "overroll/simulation.h"

typedef struct test_contact {
    ovr_contact contact;
    ovr_lubricant lubricant;
} test_contact;

/* alpha = 1.7e-8 1/Pa, p0 = 1.98e8 Pa, z = 0.68, as in the paper. */
test_contact test_contact_make(double M, double L);

/* Returns the options of the reference values, which do not depend on the
 * program's defaults: [-4, 1.5], second order, upstream2. */
ovr_options test_options(void);

/* Creates a simulation, or fails the test. */
ovr_simulation *test_simulation(double M, double L, const ovr_options *options);

/* Feature of the reference runs; test_feature_heights is an ovr_heights.
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
