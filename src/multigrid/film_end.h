/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ends of the film that move, in time.
 *
 * Sweeps move the end of a film by a node each, and corrections enter wet
 * nodes only: an end that moves many nodes in a step would creep.  With the
 * film H as it is, nodes in a row are a tridiagonal problem with P >= 0 whose
 * matrix is an M-matrix:
 *
 *     G_i P_i - L_i P_{i-1} - U_i P_{i+1} = -r_i + (the same of P as it is)
 *     L_i = (eps_{i-1} + eps_i)/(2 D^2) - a1 dq_{i-1}
 *     U_i = (eps_i + eps_{i+1})/(2 D^2)
 *     G_i = (eps_{i-1} + 2 eps_i + eps_{i+1})/(2 D^2) + a0 dq_i
 *
 * solved in one pass after Brennan and Schwartz: eliminated from the wet side,
 * put in from the dry one.  It is solved
 *
 *  - beyond the contact, on both sides, as far as eps > 2000 a0 K(0) D^2/pi:
 *    the pressures that move the film there do not deform it, so that the
 *    problem is all there is.  From the contact to the end of the film behind
 *    which it stays dry; patches beyond stay with the sweeps.  But only where
 *    what dry nodes lack is a tenth of R: a long zone is not quite rigid (for m
 *    meshes a0 (m D/pi)^3 must be small beside eps), and where R is something
 *    else's, a rough surface's, this solution makes it larger.  Where the film
 *    is thick all over (M below 1) the zone is the whole domain, and what makes
 *    R three times as large is taken back;
 *  - behind each end of a film whose next node wants to rise, for 32 cavitated
 *    nodes at most and P <= 0.05; wet nodes stay: their film would have to
 *    follow.
 */
#ifndef OVR_MULTIGRID_FILM_END_H
#define OVR_MULTIGRID_FILM_END_H

#include "multigrid/hierarchy.h"

/* Film and residual of the level must be up to date, and are afterwards. */
void ovr_film_ends(const ovr_hierarchy *grids, ovr_level *level);

#endif
