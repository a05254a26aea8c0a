/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A step of Newton's method on a fine grid without its full matrix.
 *
 *     row i:  sum_m e_m (w_{i+m} - dH0) + sum_m l_m dP_{i+m} = r_i, m = -2..1
 *     D sum_j dP_j = missing force,   w = k * dP,  dP = 0 at both ends
 *
 * w is summed by MLMI, so that a product takes O(n).  The system is solved by
 * GMRES (Saad and Schultz 1986), preconditioned from the right: unknowns are
 * tripoles, dP_j = q_j - (q_{j-1} + q_{j+1})/2, whose deformation falls with
 * the square of the distance; the part beyond OVR_BAND mesh sizes is omitted,
 * and the band is factored. H0 and the force balance are added as a border. For
 * smooth steps this approximation is poor; they are deflated (below). Rows are
 * scaled by their largest element.
 */
#ifndef OVR_MULTIGRID_TRIPOLES_H
#define OVR_MULTIGRID_TRIPOLES_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "multigrid/hierarchy.h"
#include "multigrid/kernels.h"

enum { OVR_TRIPOLE_PRODUCTS = 60 };

/* A row of the linear system of Newton's method. */
typedef struct ovr_newton_row {
    double e[4], local[4], r;
} ovr_newton_row;

/* Banded linear systems, by Gaussian elimination with column pivoting: A_ij = 0
 * for |i - j| > OVR_BAND. */

/* WIDTH: entries of a row, including fill-in by pivoting. */
enum { OVR_BAND = 8, OVR_BAND_WIDTH = 3 * OVR_BAND + 1 };

typedef struct ovr_banded {
    double *row;    /* A_ij at i WIDTH + j - i + BAND; after factoring the upper
                     * factor, with the inverse of its diagonal */
    double *factor; /* lower factor, BAND entries per column */
    size_t *pivot;
} ovr_banded;

/*
 * Coarse correction of the preconditioner B.  B neglects the deformation of
 * distant tripoles, which is large for smooth steps. About n/50 eigenvalues of
 * A B^-1 are far from 1, and each costs a GMRES iteration. These are deflated:
 *
 *     v -> Q v + B^-1 (v - A Q v),   Q = P (R A P)^-1 R
 *
 * The columns of P are piecewise linear steps on a coarse grid with every
 * `stride`-th node, and dH0. R sums rows with the same weights and contains the
 * force balance. The columns of A P are stored; they are computed from the
 * deformation by a hat function, which depends on the distance only.
 *
 * Source: Nabben and Vuik 2006 (A-DEF1).
 */
typedef struct ovr_deflation {
    size_t stride, count;
    double *hat;     /* deformation by a hat function at each distance, see
                      * hats_on */
    double *columns; /* A P, stored by rows */
    double *matrix;  /* LU factors of R A P */
    double *value;   /* coefficients of P: steps, then dH0 */
    size_t *pivot;
    double of; /* the kernel for which `hat` was computed */
} ovr_deflation;

typedef struct ovr_tripoles {
    ovr_newton_row *row; /* row of a node, written by the caller */
    ovr_banded band;
    double *basis;  /* basis vectors of the subspace, one after the other */
    double *column; /* solution of the band matrix for the column of H0 */
    double *q, *w, *u;
    ovr_deflation smooth;
    bool deflated; /* `smooth` is factored */
    double triangle[OVR_TRIPOLE_PRODUCTS][OVR_TRIPOLE_PRODUCTS + 1];
} ovr_tripoles;

ovr_tripoles *ovr_tripoles_take(size_t n, ovr_arena *arena, ovr_error *err);

/* Computes a Newton step, dP of all nodes followed by dH0, from the rows in
 * grids->touch and the force error. Overwrites the level's w. Returns false if
 * no step was found. If GMRES fails with the elastic band, the local band is
 * used, also in the next 1, 2, 4, ... steps of this solve. */
bool ovr_tripoles_solve(ovr_hierarchy *grids, const ovr_level *level,
                        double missing, double *step);

/* Allocates memory for n nodes; count = 0 if n is too small. */
ovr_status ovr_deflation_take(ovr_deflation *d, size_t n, ovr_arena *arena,
                              ovr_error *err);

/* Adapts the coarse grid to a smaller number of nodes n. */
void ovr_deflation_fit(ovr_deflation *d, size_t n);

/* Computes A P from the rows and factors R A P. kernel: influence k up to a
 * distance of n. Returns false if R A P is singular. */
bool ovr_deflation_factor(ovr_deflation *d, const ovr_kernels *run,
                          const ovr_newton_row *row, size_t n, double D,
                          const double *kernel);

/* Solves the coarse system for the right-hand side v (rows 1..n-2, force) and
 * writes v - A Q v to u. */
void ovr_deflation_apply(ovr_deflation *d, const ovr_kernels *run, size_t n,
                         double D, const double *v, double *u);

/* Adds the last Q v to a step (dP of n nodes, dH0). */
void ovr_deflation_add(const ovr_deflation *d, size_t n, double *step);

#endif
