/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's hybrid relaxation (section 5 of Venner, ten Napel & Bosma 1990).
 *
 * One sweep in order of X, with fixed film and properties:
 *   where eps/D^2 > switch_value, Gauss-Seidel:
 *     P_i <- max(0, P_i + relax_seidel r_i / A_ii)     immediately;
 *   elsewhere, Jacobi dipole: P_i changes by delta_i and P_{i-1} by -delta_i,
 *     delta_i = relax_dipole r_i / (A_ii - A_{i,i-1})  after the sweep.
 *
 * A_ij is the derivative given in line.h. eps of the switch is the mean used in
 * the row, (eps_{i-1} + 2 eps_i + eps_{i+1})/4. With the node's own eps, a row
 * with strong diffusion at a jump of eps would be relaxed by the dipole, which
 * reduces its error only by 0.8 per sweep. The kernel scales with D, so that
 * the switch eps/D^2 is independent of the grid. The paper's 0.01 on eps/D
 * belongs to its model problem (9) on its grids.
 *
 * The algorithm of the paper alone stalls or diverges here. It was changed as
 * follows:
 *  1. Cavitated nodes keep P = 0 unless their residual, with allowance for
 *     rounding (line.h), would make P positive. The residual of a coarse
 *     cavitated node is rounding error. Its sign would make nodes pressurized
 *     at random and cause a limit cycle of the last pressurized nodes.
 *  2. A pointwise sweep moves the cavitation boundary by one node, a coarse
 *     grid by several. Each sweep therefore ends with a few line solves
 *     (tridiagonal, film fixed, projected) of the last rows before it.
 *  3. Number of rows: a solve with fixed film over a length l is stable only
 *     if diffusion, eps (pi/l)^2, exceeds the elastic response of the wedge,
 *     which is of order 1. The rows therefore have l^2 < 3 eps at the first
 *     of them. Longer windows diverge: at M = 20, L = 2.5 a window of 56
 *     nodes failed, and repeated solves increased its error.
 *  4. The switch value is 3 instead of 0.3. Gauss-Seidel on the second-order
 *     wedge amplifies disturbances that travel downstream where eps/D^2 is
 *     0.4 to 2. The growth is slow (1.25 a cycle at M = 50, L = 10, level 12,
 *     X = 0.75), but fine grids have wide zones with such eps.
 *  5. V(2,2) cycles: with one sweep after the coarse-grid correction, the
 *     error that the correction leaves at the spike returned in the next
 *     cycle (M = 50, L = 15, level 10).
 */
#ifndef OVR_MULTIGRID_HYBRID_H
#define OVR_MULTIGRID_HYBRID_H

#include "multigrid/smoother.h"

ovr_relax ovr_relax_hybrid;

/*
 * The coarsest grid as the paper treats it: sweeps of the hybrid relaxation,
 * each followed by H0 <- H0 - c (force - D sum P), c = 0.02. The pressures
 * follow H0 slowly. With few sweeps and a large c, the load therefore
 * oscillates for dozens of cycles (10 sweeps, c = 0.05: R falls tenfold in 30
 * V-cycles at M = 20, L = 10, level 8). A visit has 100 sweeps in V-cycles. In
 * W-cycles, which visit the coarsest grid 2^(levels) times as often, it has 20.
 */
void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level,
                        const ovr_smoothing *how, int cycle_index);

#endif
