/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of kernels compared on the same grid and fields. */
#ifndef TESTS_SUPPORT_KERNELS_H
#define TESTS_SUPPORT_KERNELS_H

#include <stdint.h>

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"

/* Returns a table of kernels for this machine: 0 is the plain one, then the
 * vector kernels; NULL past the last. */
const ovr_kernels *test_kernels(int k);

/* Arrays of a grid in the layout of a table of kernels. */
typedef struct test_grid {
    ovr_arena arena;
    const ovr_kernels *run;
    size_t n;
    ovr_lanes lanes;
    double D;
    ovr_fluid fluid;
    ovr_weights weights;
    ovr_mlmi mlmi;
    ovr_fields f;
    ovr_band band;
    double *gap, *w, *ordered, k[6];
} test_grid;

test_grid test_grid_make(const ovr_kernels *run, size_t n);

/* Means between nodes by the gap, else they are arithmetic. */
void test_grid_gap(test_grid *grid);

/* Means by the gap that are logarithmic in 1/eta. */
void test_grid_logarithmic(test_grid *grid);

/* Sets an Eyring model. */
void test_grid_thin(test_grid *grid, double Sigma0, double sliding);

/* Adds a flow skewed by temperatures. */
void test_grid_skew(test_grid *grid);

/* Computes film thickness and lubricant properties, also at half nodes, from
 * gap, deformation and pressure. */
void test_grid_film(const test_grid *grid, const ovr_fields *f);

/* A pressure with a wet part, a dry end and a small disturbance, a film without
 * deformation, a right-hand side; the properties and the residual that belong
 * to them.  For the plain kernels. */
void test_grid_fill(const test_grid *grid, uint64_t seed);

/* All arrays of a plain one. */
void test_grid_copy(const test_grid *plain, const test_grid *to);

/* One of its arrays in the order of the nodes, until the next call. */
const double *test_grid_read(const test_grid *grid, const double *x);

#endif
