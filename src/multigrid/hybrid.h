/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's hybrid relaxation (section 5 of Venner, ten Napel & Bosma 1990).
 *
 * One sweep in order of X, film and properties fixed:
 *   where eps/D^2 > switch_value, Gauss-Seidel:
 *     P_i <- max(0, P_i + relax_seidel r_i / A_ii)     at once;
 *   elsewhere, Jacobi dipole: P_i changes by delta_i and P_{i-1} by -delta_i,
 *     delta_i = relax_dipole r_i / (A_ii - A_{i,i-1})  when the sweep is done.
 * A_ij is the derivative given in line.h.  The kernel scales with D, so
 * eps/D^2 is the switch that does not depend on the grid; the paper's 0.01 on
 * eps/D belongs to its model problem (9) on its grids.
 */
#ifndef OVR_MULTIGRID_HYBRID_H
#define OVR_MULTIGRID_HYBRID_H

#include "multigrid/hierarchy.h"

ovr_relax ovr_relax_hybrid;

/* The coarsest grid as the paper treats it: sweeps of the hybrid relaxation,
 * each followed by H0 <- H0 - c (force - D sum P). */
void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level);

#endif
