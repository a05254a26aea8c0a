/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The discrete Reynolds equation, steady or transient, any scheme.
 *
 *     N_i = [ (eps_{i-1} + eps_i)(P_{i-1} - P_i)
 *           + (eps_i + eps_{i+1})(P_{i+1} - P_i) ]/(2 D^2)
 *           - a0 q_i - a1 q_{i-1} - a2 q_{i-2},        q = rho H
 *     N_i = F_i where P_i > 0;   P_i = 0 where N_i <= F_i
 *     a0 = Cu w0/D + cT,  a1 = Cu w1/D,  a2 = Cu w2/D
 *
 *     scheme          w             cT        F (history, finest grid)
 *     upstream1       1, -1, 0      1/dT      -q^{k-1}/dT
 *     upstream2       1.5, -2, 0.5  b0/dT     (b1 q^{k-1} + b2 q^{k-2})/dT
 *     characteristic  0, 0, 0       b0/dT     the same at the departure points
 * of the characteristic
 *
 * Steady is cT = 0, F = 0.  Row 1 has no q_{-1}: its wedge is first order. BDF2
 * with steps dT after dT_old, s = dT/dT_old: b0 = (1 + 2s)/(1 + s), b1 = -(1 +
 * s), b2 = s^2/(1 + s).
 *
 * The residual is r = F - N: if r < 0, the node's pressure is too low. The norm
 * of the residual is the relative mass flow imbalance
 *     R = D sum rho_i / H_cen,
 *     rho_i = |r_i|                if r_i < 0 (P_i too low)
 *             min(r_i, P_i d_i)    if r_i > 0,
 *             d_i = (eps_{i-1} + 2 eps_i + eps_{i+1})/(2 D^2)
 * (the second form because a nearly cavitated node with r_i > 0 is solved by
 * setting P_i = 0).
 *
 * Source: equations 1, 3 of Venner, ten Napel & Bosma 1990, with time after
 * Venner & Lubrecht.
 */
#ifndef OVR_MULTIGRID_REYNOLDS_H
#define OVR_MULTIGRID_REYNOLDS_H

#include <stdbool.h>

#include "multigrid/kernels.h"

/* Coefficients of wedge and time derivative, the same on every grid. */
typedef struct ovr_operator {
    double w[3];       /* wedge weights times Cu */
    double w_first[2]; /* wedge weights in row 1 */
    double cT;         /* coefficient of q_i in the time derivative, 1/T */
    double speed;      /* Cu */
    bool transient;
    bool characteristic;
    double limited[2]; /* with limiters (content.h): outflow and time
                        * derivative; otherwise zero */
} ovr_operator;

/* Sets w and w_first to the upstream wedge of first or second order for speed
 * Cu; row 1 has no q_{-1} and is of first order. */
void ovr_reynolds_wedge(ovr_operator *op, bool second_order, double Cu);

/* Weights on a grid of mesh size D. */
ovr_weights ovr_reynolds_weights(const ovr_operator *op, double D);

/* Distribution of a change delta_j of the line relaxation to P_{j-1}, P_j,
 * P_{j+1}: (minus, 1, plus). theta = 1/(1 + (tau/0.2)^2), tau = cT D/Cu: a
 * dipole (-1, 1, 0) if steady, a tripole (-1/2, 1, -1/2) if the time derivative
 * dominates, and with the characteristic scheme. */
ovr_shares ovr_reynolds_shares(const ovr_operator *op, double D);

#endif
