/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic deformation of arrays in the order of the nodes (not in lanes). */
#ifndef TESTS_SUPPORT_DEFORMATION_H
#define TESTS_SUPPORT_DEFORMATION_H

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"

typedef struct test_deformation {
    ovr_mlmi plan;
    ovr_lanes lanes;
    const ovr_kernels *kernels;
    double *P, *w; /* in lanes */
} test_deformation;

/* Plans the deformation with the named kernels (NULL: the fastest), or fails
 * the test. */
test_deformation test_deformation_plan(const char *kernels, size_t n, double D,
                                       int order, int range, ovr_arena *arena);

/* Computes the deformation w of a pressure P, n values each. */
void test_deform(const test_deformation *plan, const double *P, double *w);

/* Computes w = K P/pi by direct summation, O(n^2). */
void test_deform_directly(size_t n, double D, const double *P, double *w);

#endif
