/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of kernels compared on the same grid and fields. */
#ifndef TESTS_SUPPORT_KERNELS_H
#define TESTS_SUPPORT_KERNELS_H

#include <stdint.h>

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"

/* Returns table k of kernels for this machine, of which table 0 is the plain
 * one; NULL if there is no table k. */
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

/* Selects means between nodes by the gap in place of arithmetic means. */
void test_grid_gap(test_grid *grid);

/* Selects means by the gap that are logarithmic in 1/eta. */
void test_grid_logarithmic(test_grid *grid);

/* Sets an Eyring model. */
void test_grid_thin(test_grid *grid, double Sigma0, double sliding);

/* Adds a flow skewed by temperatures. */
void test_grid_skew(test_grid *grid);

/* Computes film thickness and lubricant properties, also at half nodes, from
 * gap, deformation and pressure. */
void test_grid_film(const test_grid *grid, const ovr_fields *f);

/* Fills the arrays of a plain grid: a pressure with a full-film region, a
 * cavitated end and a small disturbance; a film thickness without deformation;
 * a right-hand side; properties and residual of these. */
void test_grid_fill(const test_grid *grid, uint64_t seed);

/* Copies all arrays of a plain grid. */
void test_grid_copy(const test_grid *plain, const test_grid *to);

/* Returns an array of the grid in the order of the nodes, until the next call.
 */
const double *test_grid_read(const test_grid *grid, const double *x);

#endif
