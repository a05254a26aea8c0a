/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Distributive line relaxation: the default smoother.
 *
 * One quasi-Newton step of the whole line with the Jacobian matrix A
 * (reynolds_row.h) cut to a band.  The term d eps/dH is left out on purpose: it
 * changes the sign of the elastic coefficient where H exceeds 1.5 times the
 * film thickness of the contact, and the relaxation diverges there.
 *
 * The kernel k decays too slowly to be truncated. Therefore the unknowns are
 * distributed changes delta_j, which change P_{j-1}, P_j, P_{j+1} by (minus, 1,
 * plus) delta_j with zero or nearly zero sum (reynolds.h). The deformation of
 * such a change is local, and truncating the band only adds damping.  The
 * system
 *     b_d = A_d + minus A_{d-1} + plus A_{d+1},  d = -2..2
 * is pentadiagonal.  Then P <- max(0, P + clipped change).
 *
 * In transient steps the truncated b_{-3} = -plus_{i-3} a2 rho'_{i-2} H_{i-2}
 * grows as 1/D; without it, waves of about nine nodes are amplified. It is
 * included by delta_{i-3} = 2 delta_{i-2} - delta_{i-1}, which reduces the
 * largest convergence factor of a V(1,1) cycle from 1.6 to 0.06 (for rho'
 * H/(rho D) from 3 to 30 and cT D from 0.2 to 3).
 *
 * P_{n-1} stays 0: in transient steps column n - 2 is (minus, 1, 0) if that
 * node is pressurized.
 *
 * Cavitated nodes stay constrained to P = 0 unless their residual would make P
 * positive (reynolds_row.h).
 *
 * Cost O(n), one deformation and one evaluation of properties a sweep.
 */
#ifndef OVR_MULTIGRID_LINE_H
#define OVR_MULTIGRID_LINE_H

#include "multigrid/smoother.h"

ovr_relax ovr_relax_line;

#endif
