/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Fourth order by deferred correction: the truncation error of the second-order
 * equations is evaluated with the present solution and added to the right-hand
 * sides of the finest grid. This is repeated until the solution does not
 * change.
 *
 *     F = F0 - m dN(P, q, eps),   gap = gap0 + g(w)
 *
 * F0 and gap0 are the values without correction. Smoothers, coarse grids and
 * force balance do not change. Convergence is measured by the residual of the
 * corrected equations.
 *
 * Film. A pressure that is constant between half nodes has, for a wave e^(ikX),
 * the deformation (by Poisson's summation formula)
 *     w + (D^2/24) w'' + C D^3 P'' + O(D^4),
 *     C = eta(3)/(2 pi^3),  eta(3) = 1 - 1/8 + 1/27 - ... = 0.90154...
 * (the term of third order comes from the kernel's singularity), hence
 *     g_i = delta2 w_i/24 + C D delta2 P_i,  delta2 f_i = f_{i-1} - 2 f_i +
 * f_{i+1}, at cavitated nodes too.  A pressure that is linear between nodes has
 *     w + (D^2/12) w'' + C D^3 P'',  C = zeta(3)/(4 pi^3),
 * and 1/12 and this C are used in g.  Both sums are over the aliases with wave
 * numbers n/D; with elastic layers, each alias is weighted by its compliance
 * (influence.h).
 *
 * Poiseuille flow, conservative, at half nodes:
 *     p_i = [27 (P_{i+1} - P_i) - (P_{i+2} - P_{i-1})]/(24 D)
 *     f_i = eps_{i+1/2} p_i
 *     dN  = [27 (f_i - f_{i-1}) - (f_{i+1} - f_{i-2})]/(24 D) - second order
 * eps grows exponentially in the inlet, so for X < 0 the logarithm of eps_{i +
 * 1/2} is the cubic through four nodes; for X > 0 eps itself is the cubic,
 * limited to within 40 % of the two-node mean of the second-order equation
 * (faces.h). Without the limit, or with a jump to the mean, the iteration ends
 * in a limit cycle at the spike. Rheological models have their own correction
 * (fourth_thinning.h).  Where the mean between nodes is logarithmic and the
 * film Newtonian and cold, f for X > 0 is the slope of the reduced pressure R,
 * dR = m dP, m = eps/(rho H^3):
 *     R_{i+1} - R_i = L (P_{i+1} - P_i) (1 - b),  L the logarithmic mean of m,
 *     b = [(ln m)'_{i+1} - (ln m)'_i] (P_{i+1} - P_i)/12,  |b| < 0.3
 *     r_i = R_{i+1} - R_i
 *     f_i = (rho H^3)_{i+1/2} [r_i - (r_{i-1} - 2 r_i + r_{i+1})/24]/D
 * The second difference is limited to 40 % of r_i, and rho H^3 to within 40 %
 * of the two-node mean.  R is smooth at the flank of a pressure spike, where
 * eps changes by e to e^7 in a mesh size.  For X < 0 features can cause
 * such spikes too. There the slope of R has the share min(max(s - 1, 0), 1):
 *     s = |e_{i-1} - 2 e_i + e_{i+1}| + |e_i - 2 e_{i+1} + e_{i+2}|,
 *     e = ln eps
 * Without it narrow dents leave spikes in the film that corrections amplify
 * from step to step.  In smooth inlets s < 1.
 *
 * Wedge, biased upstream, less the second-order one:
 *     dN -= Cu (3 q_{i+1} + 10 q_i - 18 q_{i-1} + 6 q_{i-2} - q_{i-3})/(12 D)
 *           - Cu (1.5 q_i - 2 q_{i-1} + 0.5 q_{i-2})/D
 *
 * m is 1 where P_{i-1..i+1} > 0 and no end is near, else 0.  f = 0 in the
 * cavitated film, so that stencils may extend into it. A wider mask (three
 * nodes) would exclude much of a poorly resolved constriction (D/H^(2/3) > 0.1:
 * errors of H_min 2e-2 instead of 2e-3).  Only the three corrections together
 * yield fourth order.  The steady equation of the characteristic scheme is that
 * of upstream2, so the correction is the same for both.
 */
#ifndef OVR_MULTIGRID_FOURTH_ORDER_H
#define OVR_MULTIGRID_FOURTH_ORDER_H

#include "multigrid/full.h"

/* Destination of the correction: the finest grid's right-hand sides, in lanes.
 */
typedef struct ovr_correction {
    double *F, *gap;
    double *mask;     /* m */
    double *gap_only; /* the gap without correction */
} ovr_correction;

ovr_status ovr_correction_prepare(ovr_hierarchy *grids, ovr_correction *c,
                                  ovr_arena *arena, ovr_error *err);

/* Computes F and gap for the present film, and the mask from its pressures:
 * Poiseuille flow and, for Cu > 0, the wedge. `backward`: the inlet is on the
 * right. */
void ovr_fourth_evaluate(const ovr_hierarchy *grids, const ovr_correction *c,
                         double Cu, bool backward);

/*
 * Improves a second-order solution on the finest grid (F = 0) to fourth order
 * by alternating cycles and corrections. The mask is computed by the first
 * three corrections and then kept; recomputing it each time can cause a limit
 * cycle. The residual falls to a third per cycle, because the wedge is
 * corrected by a factor of 4/3 at the shortest wavelength. Returns false if
 * eight corrections do not reduce the residual by a third (limit cycle; slow
 * convergence if D/H^(2/3) > 0.3), or if the tolerance is not reached. F, gap
 * and pressures are then invalid. Adds to the number of cycles.
 */
bool ovr_fourth_solve(ovr_hierarchy *grids, const ovr_correction *c,
                      const ovr_full *how, ovr_defect *d, int *cycles);

#endif
