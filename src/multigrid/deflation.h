/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Coarse correction of the preconditioner of tripoles.h.  The band leaves out
 * the deformation of distant tripoles, so smooth steps are not solved by it:
 * some n/50 eigenvalues of the preconditioned matrix A B^-1 are far from 1, and
 * each costs GMRES a product.  They are deflated (Nabben and Vuik 2006,
 * A-DEF1):
 *
 *     v -> Q v + B^-1 (v - A Q v),   Q = P (R A P)^-1 R
 *
 * P: piecewise linear steps with a node in every `stride` nodes, and dH0.
 * R: sums of rows with the same weights, and the force.  A P follows from the
 * influence of a hat, which depends on the distance alone, and is kept.
 */
#ifndef OVR_MULTIGRID_DEFLATION_H
#define OVR_MULTIGRID_DEFLATION_H

#include "multigrid/kernels.h"
#include "multigrid/tripoles.h"

/* Takes memory for n nodes; count = 0 if there are too few of them. */
ovr_status ovr_deflation_take(ovr_deflation *d, size_t n, ovr_arena *arena,
                              ovr_error *err);

/* Makes A P from the rows and factors R A P.  kernel: k(0) of the influence,
 * known up to a distance of n.  False: R A P is singular. */
bool ovr_deflation_factor(ovr_deflation *d, const ovr_kernels *run,
                          const ovr_newton_row *row, size_t n, double D,
                          const double *kernel);

/* Solves the coarse system of the right-hand side v (rows 1..n-2, force) and
 * writes v - A Q v to u. */
void ovr_deflation_apply(ovr_deflation *d, const ovr_kernels *run, size_t n,
                         double D, const double *v, double *u);

/* Adds Q v, which was found last, to a step (dP of n nodes, dH0). */
void ovr_deflation_add(const ovr_deflation *d, size_t n, double *step);

#endif
