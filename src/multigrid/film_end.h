/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Moves the cavitation boundary in transient runs.
 *
 * A relaxation sweep moves the boundary by at most one node, and coarse-grid
 * corrections are applied to pressurized nodes only.  A boundary that moves
 * many nodes in one time step would converge slowly.  For a fixed film
 * thickness H, the pressure near the boundary solves a tridiagonal
 * complementarity problem with an M-matrix:
 *
 *     G_i P_i - L_i P_{i-1} - U_i P_{i+1} = -r_i + (the same of P as it is)
 *     L_i = (eps_{i-1} + eps_i)/(2 D^2) - a1 dq_{i-1}
 *     U_i = (eps_i + eps_{i+1})/(2 D^2)
 *     G_i = (eps_{i-1} + 2 eps_i + eps_{i+1})/(2 D^2) + a0 dq_i
 *
 * It is solved in one pass (Brennan and Schwartz): elimination starts on the
 * pressurized side, back substitution on the cavitated side.  It is solved
 *
 *  - upstream and downstream of the contact, where eps > 2000 a0 K(0) D^2/pi.
 *    There the pressures that move the film are too small to deform it.  The
 *    zone extends from the contact to the last film end; isolated film patches
 *    beyond it are left to the sweeps.  The solution is used only if the
 *    cavitated nodes contribute a tenth of R, because a long zone is not quite
 *    rigid (for a length m D, a0 (m D/pi)^3 must be small relative to eps), and
 *    because it increases a residual that is due to a rough surface.  If the
 *    film is thick everywhere (M below 1), the zone is the whole domain; a
 *    solution that increases R by a factor of three is discarded;
 *  - at each film end whose next node must become pressurized, for at most 32
 *    cavitated nodes and P <= 0.05.  Pressurized nodes do not change.
 */
#ifndef OVR_MULTIGRID_FILM_END_H
#define OVR_MULTIGRID_FILM_END_H

#include "multigrid/hierarchy.h"

/* Film and residual of the level must be up to date before the call, and are up
 * to date after it. */
void ovr_move_cavitation_boundary(const ovr_hierarchy *grids, ovr_level *level);

#endif
