/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Full approximation scheme between a level and the next coarser one (c):
 *
 *     P_c   = restricted P             full weighting where the three nodes
 *                                      are wet, else injection
 *     gap_c = injected (H - H0) + w_c(P_c)
 *     F_c   = N_c(P_c, H_c) + restricted r,  zero residual at cavitated nodes
 *     force_c = D_c sum P_c + (force - D sum P)
 *
 * so that a solved fine grid leaves the coarse grid at rest.  Then
 *     P <- max(0, P + interpolated (P_c - P_c at entry))  in wet nodes only:
 * the coarse grid cannot know where exactly the fine film ends.
 */
#ifndef OVR_MULTIGRID_FAS_H
#define OVR_MULTIGRID_FAS_H

#include "multigrid/hierarchy.h"

/* Fills the coarser level's P, gap, F and force, its film and properties
 * included; the fine level's film, properties and residual are up to date. */
void ovr_fas_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                      ovr_level *coarse);

/* Adds `factor` times the coarse correction to the fine P. */
void ovr_fas_correct(const ovr_hierarchy *grids, const ovr_level *coarse,
                     ovr_level *fine, double factor);

/* P of the next finer level by cubic interpolation: the start of full
 * multigrid on a new level. */
void ovr_fas_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                    ovr_level *fine);

#endif
