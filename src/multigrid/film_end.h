/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Ends of the film that move outwards, in time.
 *
 * Sweeps move the end of a film by a node each, and corrections enter wet
 * nodes only: an end that moves many nodes in a step would creep.  Behind each
 * end whose next node wants to rise, 32 dry nodes at most, with the film H as
 * it is, are a tridiagonal problem with P >= 0 whose matrix is an M-matrix:
 *
 *     G_i P_i - L_i P_{i-1} - U_i P_{i+1} = -r_i + (the same of P as it is)
 *     L_i = (eps_{i-1} + eps_i)/(2 D^2) - a1 dq_{i-1}
 *     U_i = (eps_i + eps_{i+1})/(2 D^2)
 *     G_i = (eps_{i-1} + 2 eps_i + eps_{i+1})/(2 D^2) + a0 dq_i
 *
 * solved in one pass after Brennan and Schwartz: eliminated from the wet side,
 * put in from the dry one.  P <= 0.05, and wet nodes stay: their film would
 * have to follow.
 */
#ifndef OVR_MULTIGRID_FILM_END_H
#define OVR_MULTIGRID_FILM_END_H

#include "multigrid/hierarchy.h"

/* Whether P has changed: film and residual are those of before then. */
bool ovr_film_ends(const ovr_hierarchy *grids, const ovr_level *level);

#endif
