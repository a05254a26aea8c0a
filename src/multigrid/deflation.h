/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Coarse correction of the preconditioner B of tripoles.h.  B neglects the
 * deformation of distant tripoles, which smooth steps have.  Each of some n/50
 * eigenvalues of A B^-1 far from 1 costs GMRES a product.  They are deflated:
 *
 *     v -> Q v + B^-1 (v - A Q v),   Q = P (R A P)^-1 R
 *
 * P has piecewise linear steps with a node in every `stride` nodes, and dH0.
 * R sums rows with the same weights and has the force.  The columns A P are
 * stored.  They follow from the influence of a hat, a function of the distance.
 *
 * Source: Nabben and Vuik 2006 (A-DEF1).
 */
#ifndef OVR_MULTIGRID_DEFLATION_H
#define OVR_MULTIGRID_DEFLATION_H

#include "multigrid/kernels.h"
#include "multigrid/tripoles.h"

/* Allocates memory for n nodes; count = 0 if n is too small. */
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
