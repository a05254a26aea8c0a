/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The paper's hybrid relaxation (section 5 of Venner, ten Napel & Bosma 1990).
 *
 * One sweep in order of X, film and properties fixed:
 *   where eps/D^2 > switch_value, Gauss-Seidel:
 *     P_i <- max(0, P_i + relax_seidel r_i / A_ii)     at once;
 *   elsewhere, Jacobi dipole: P_i changes by delta_i and P_{i-1} by -delta_i,
 *     delta_i = relax_dipole r_i / (A_ii - A_{i,i-1})  when the sweep is done.
 * eps of the switch is the mean used in the row, (eps_{i-1} + 2 eps_i +
 * eps_{i+1})/4: with the node's own eps, a row with strong diffusion at a jump
 * of eps would be relaxed by the dipole, which reduces its error only by 0.8
 * per sweep. A_ij is the derivative given in line.h.  The kernel scales with D,
 * so that the switch eps/D^2 is independent of the grid; the paper's 0.01 on
 * eps/D belongs to its model problem (9) on its grids.
 *
 * The algorithm of the paper alone stalls or diverges here. It was changed as
 * follows:
 *  1. Cavitated nodes that do not want to rise are held, with allowance for
 *     rounding (line.h).  The residual of a coarse cavitated node is rounding
 *     error, whose sign made it pressurized at random: a limit cycle of the
 *     last pressurized nodes.
 *  2. A pointwise sweep moves the end of the film by a node, a coarse grid by
 *     several.  So each sweep ends with a few line solves (tridiagonal, film
 *     fixed, projected) of the last rows before the end.
 *  3. How many rows: a solve with fixed film over a length l is stable only
 *     while diffusion, eps (pi/l)^2, outweighs the elastic response of the
 *     wedge, of order 1.  The rows taken have l^2 < 3 eps at the first of
 *     them.  Fewer do, more diverge: at M = 20, L = 2.5 a window 56 nodes
 *     long failed, and the more surely the more often it was solved.
 *  4. The switch.  Gauss-Seidel on the second-order wedge amplifies what
 *     travels downstream where eps/D^2 is 0.4 to 2; it is slow (1.25 a cycle
 *     at M = 50, L = 10, level 12, X = 0.75), but fine grids have wide zones
 *     of such eps.  3 instead of 0.3 ended that.
 *  5. V(2,2): with one sweep after the coarse grid what the correction leaves
 *     at the spike came back in the next one (M = 50, L = 15, level 10).
 */
#ifndef OVR_MULTIGRID_HYBRID_H
#define OVR_MULTIGRID_HYBRID_H

#include "multigrid/smoother.h"

ovr_relax ovr_relax_hybrid;

/*
 * The coarsest grid as the paper treats it: sweeps of the hybrid relaxation,
 * each followed by H0 <- H0 - c (force - D sum P), c = 0.02.  The pressures
 * follow H0 slowly, so that few sweeps with a large c make the load swing for
 * dozens of cycles (10 sweeps, c = 0.05: R falls tenfold in 30 V-cycles at
 * M = 20, L = 10, level 8).  100 sweeps a visit in V-cycles; in W-cycles,
 * which come by 2^(levels) times as often, 20.
 */
void ovr_coarsest_paper(ovr_hierarchy *grids, ovr_level *level,
                        const ovr_smoothing *how, int cycle_index);

#endif
