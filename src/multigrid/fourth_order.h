/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth order by deferred correction: what the discrete equations of second
 * order lack, evaluated with the solution so far and added to the right-hand
 * sides of the finest grid, until nothing changes any more.
 *
 *     F = F0 - m dN(P, q, eps),   gap = gap0 + g(w)
 *
 * F0, gap0 without correction; smoothers, coarse grids and the force balance
 * stay as they are, and the residual of the corrected equations is the measure
 * of convergence as before.
 *
 * Film.  A pressure that is constant from half node to half node has the
 * deformation, of a wave e^(ikX) by Poisson's summation,
 *     w + (D^2/24) w'' + C D^3 P'' + O(D^4),
 *     C = eta(3)/(2 pi^3),  eta(3) = 1 - 1/8 + 1/27 - ... = 0.90154...
 * (the term of third order comes from the kernel's singularity), hence
 *     g_i = delta2 w_i/24 + C D delta2 P_i,  delta2 f_i = f_{i-1} - 2 f_i +
 * f_{i+1}, at cavitated nodes too.  One that is linear between the nodes has
 *     w + (D^2/12) w'' + C D^3 P'',  C = zeta(3)/(4 pi^3),
 * and 1/12 and this C are used in g.  Both sums are of the waves of n/D that a
 * mesh takes for the wave itself; with layers each counts by its softness
 * (influence.h).
 *
 * Poiseuille flow, conservative, at half nodes:
 *     p_i = [27 (P_{i+1} - P_i) - (P_{i+2} - P_{i-1})]/(24 D)
 *     f_i = eps_{i+1/2} p_i
 *     dN  = [27 (f_i - f_{i-1}) - (f_{i+1} - f_{i-2})]/(24 D) - second order
 * eps grows exponentially in the inlet, so for X < 0 the logarithm of eps_{i +
 * 1/2} is the cubic through four nodes; behind it eps itself is, held within
 * 40 % of the mean of the two nodes that the equation of second order has
 * (faces.h): at the spike the cubic would leave a limit cycle, and so would a
 * jump to the mean.  A flow law has its own
 * (fourth_thinning.h).  Where the mean between nodes is logarithmic and the
 * film Newtonian and cold, f is the slope of the reduced pressure R behind
 * X = 0, dR = m dP, m = eps/(rho H^3):
 *     R_{i+1} - R_i = L (P_{i+1} - P_i) (1 - b),  L the logarithmic mean of m,
 *     b = [(ln m)'_{i+1} - (ln m)'_i] (P_{i+1} - P_i)/12,  |b| < 0.3
 *     r_i = R_{i+1} - R_i
 *     f_i = (rho H^3)_{i+1/2} [r_i - (r_{i-1} - 2 r_i + r_{i+1})/24]/D
 * the second difference held within 40 % of r_i, rho H^3 within 40 % of the
 * mean of the two nodes.  R is smooth at the flank of a pressure spike, where
 * eps changes by e to e^7 in a mesh size.
 *
 * Wedge, biased upstream, less the second-order one:
 *     dN -= Cu (3 q_{i+1} + 10 q_i - 18 q_{i-1} + 6 q_{i-2} - q_{i-3})/(12 D)
 *           - Cu (1.5 q_i - 2 q_{i-1} + 0.5 q_{i-2})/D
 *
 * m is 1 where P_{i-1..i+1} > 0 and no end is near, else 0.  f = 0 in the dry
 * film, so that stencils may reach into it; a mask three nodes wide leaves out
 * much of a constriction that is hardly resolved (D/H^(2/3) > 0.1: errors of
 * H_min 2e-2 instead of 2e-3).  All three together
 * are of fourth order, each alone leaves the second.  The steady equation of
 * the characteristic scheme is that of upstream2, so it serves both.
 */
#ifndef OVR_MULTIGRID_FOURTH_ORDER_H
#define OVR_MULTIGRID_FOURTH_ORDER_H

#include "multigrid/full.h"

/* The correction is added to the finest grid's right-hand sides, in lanes. */
typedef struct ovr_correction {
    double *F, *gap;
    double *mask;     /* m */
    double *gap_only; /* the gap without correction */
} ovr_correction;

ovr_status ovr_correction_prepare(ovr_hierarchy *grids, ovr_correction *c,
                                  ovr_arena *arena, ovr_error *err);

/* F and gap of the film as it is, with the mask of its pressures: Poiseuille
 * flow and, for Cu > 0, the wedge.  The inlet is on the right where `backward`.
 */
void ovr_fourth_evaluate(const ovr_hierarchy *grids, const ovr_correction *c,
                         double Cu, bool backward);

/*
 * Improves a second-order solution on the finest grid, F = 0, to fourth order:
 * cycle, correct, cycle, ...  The mask is set by the first three corrections
 * and stays (set again by each it can leave a limit cycle).  The residual falls
 * by a third a cycle, as the wedge at the shortest wave is corrected by 4/3.
 * False when eight corrections do not gain a third (so a limit cycle does not,
 * while D/H^(2/3) above 0.3 may fall by as little as 0.9 a cycle), or the
 * tolerance is not reached: F, gap and the pressures are then worth nothing.
 * Adds to the number of cycles.
 */
bool ovr_fourth_solve(ovr_hierarchy *grids, const ovr_correction *c,
                      const ovr_full *how, ovr_defect *d, int *cycles);

#endif
