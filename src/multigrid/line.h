/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Distributive line relaxation: the default smoother.
 *
 * One quasi-Newton step of the whole line with the Jacobian matrix cut to a
 * band.  Row i, by columns d = j - i of P:
 *     elastic  a0 rho_i k(d) + a1 rho_{i-1} k(d+1) + a2 rho_{i-2} k(d+2)
 *     local    d = -2: -a2 rho'_{i-2} H_{i-2}
 *              d = -1: [eps_{i-1} + eps_i + eps'_{i-1} (P_{i-1} - P_i)]/(2 D^2)
 *                      - a1 rho'_{i-1} H_{i-1}
 *              d =  0: -[eps_{i-1} + 2 eps_i + eps_{i+1}
 *                      - eps'_i (P_{i-1} - 2 P_i + P_{i+1})]/(2 D^2)
 *                      - a0 rho'_i H_i
 *              d = +1: [eps_i + eps_{i+1} + eps'_{i+1} (P_{i+1} - P_i)]/(2 D^2)
 * with eps' = d eps/dP at fixed H.  The term d eps/dH is left out on purpose:
 * it makes the elastic coefficient change sign where H > 1.5 times the film of
 * the contact, and the relaxation diverges there.
 *
 * The kernel k decays too slowly to be cut as it stands.  So the unknowns are
 * delta_j that change P_{j-1}, P_j, P_{j+1} by (minus, 1, plus) delta_j with
 * zero or nearly zero sum (reynolds.h): the deformation of such a change is
 * local, and cutting the band only adds damping.  The system
 *     b_d = A_d + minus A_{d-1} + plus A_{d+1},  d = -2..2
 * is pentadiagonal.  Then P <- max(0, P + clipped change).
 *
 * Dry nodes (P = 0 and r_i/A_i <= 1e-10: not wanting to rise, with room for
 * rounding, whose sign would otherwise pick wet or dry at random) are held.
 *
 * Cost O(n), one deformation and one evaluation of properties a sweep.
 */
#ifndef OVR_MULTIGRID_LINE_H
#define OVR_MULTIGRID_LINE_H

#include "multigrid/smoother.h"

ovr_relax ovr_relax_line;

#endif
