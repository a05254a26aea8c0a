/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Full approximation scheme between a level and the next coarser one (c):
 *
 *     P_c   = restricted P             full weighting where the three nodes
 *                                      have P > 0, else injection
 *     gap_c = injected (H - H0) + w_c(P_c)
 *     F_c   = N_c(P_c, H_c) + restricted r,  zero residual at cavitated nodes
 *     force_c = D_c sum P_c + (force - D sum P)
 *
 * so that the coarse grid is not corrected if the fine grid is solved. Then
 *     P <- max(0, P + interpolated (P_c - P_c at entry))
 * at pressurized nodes only, because the coarse grid does not resolve the
 * position of the cavitation boundary.
 */
#ifndef OVR_MULTIGRID_FAS_H
#define OVR_MULTIGRID_FAS_H

#include "multigrid/hierarchy.h"

/* Computes P, gap, F and force of the coarser level, and its film and
 * properties. Film, properties and residual of the fine level must be up to
 * date. */
void ovr_fas_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                      ovr_level *coarse);

/* Adds `factor` times the coarse correction to the fine P. */
void ovr_fas_correct(const ovr_hierarchy *grids, const ovr_level *coarse,
                     ovr_level *fine, double factor);

/* Interpolates P to the next finer level by cubics: the initial guess of full
 * multigrid there. */
void ovr_fas_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                    ovr_level *fine);

#endif
