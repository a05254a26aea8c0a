/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips of the contact of the reference values, on [-4, 1.5]. */
#ifndef TESTS_SUPPORT_STRIP_H
#define TESTS_SUPPORT_STRIP_H

#include "strip/strip.h"

/* Periodic surface feature at (x + u T, y): S = A exp(-r^2/width^2), where r is
 * the distance along x or, if round, in both directions; or, if along or across
 * is not 0, a wave A cos(2 pi (along x + across y)). */
typedef struct test_bump {
    double A, width, x, y, u;
    bool round;
    double along, across; /* waves per unit length */
    double grow;          /* time of growth; 0: constant height */
} test_bump;

typedef struct test_strip {
    ovr_arena arena;
    ovr_strip strip;
    double M, L, period;
    int bumps;
    test_bump bump[48];
} test_strip;

/* Makes a strip with a set of kernels; NULL: the fastest one. */
test_strip *test_strip_make(double M, double L, ovr_strip_shape shape,
                            const char *set);
void test_strip_free(test_strip *s);

/* Shape of n x lines nodes with width 2 and 33 nodes on the coarsest grid. */
ovr_strip_shape test_strip_shape(size_t n, size_t lines);

/* Computes the gap with the bumps, as an ovr_strip_gap. */
void test_strip_gap(void *strip, double T, const ovr_strip_grid *grid,
                    ptrdiff_t from, size_t n, double *gap);

/* Solves at T = 0 with at most 40 cycles, or fails the test. */
void test_strip_solve(test_strip *s, double tolerance);

const ovr_strip_level *test_strip_finest(const test_strip *s);
double test_strip_at(const test_strip *s, const double *x, size_t i, size_t j);
double test_strip_smallest(const test_strip *s, const double *x);
double test_strip_largest(const test_strip *s, const double *x);

#endif
