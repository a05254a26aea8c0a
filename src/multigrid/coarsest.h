/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The coarsest grid: Reynolds equation, film and force balance solved together
 * by Newton's method with the full Jacobian matrix,
 *
 *     sum_j J_ij dP_j + J_i0 dH0 = r_i    at nodes in play
 *     dP_i = 0                            at constrained (cavitated) nodes
 *     D sum_j dP_j = force - D sum_j P_j
 *
 * With mass-conserving cavitation no node is constrained; the unknowns are the
 * pressures of pressurized nodes and the contents of cavitated nodes
 * (content.h).  H0 is constant on all other levels.
 */
#ifndef OVR_MULTIGRID_COARSEST_H
#define OVR_MULTIGRID_COARSEST_H

#include "multigrid/hierarchy.h"

/* Number of coarsest levels solved by Newton's method: two, or three with
 * mass-conserving cavitation, where the lubricant supply is reduced on these
 * levels. */
int ovr_newton_levels(const ovr_hierarchy *grids);

/* Allocates the memory for Newton steps on these levels. */
ovr_status ovr_newton_prepare(ovr_hierarchy *grids, ovr_arena *arena,
                              ovr_error *err);

/* Allocates space for the deformation kernel of n nodes. */
double *ovr_newton_kernel(size_t n, ovr_arena *arena, ovr_error *err);

/* Computes the deformation kernel of these levels from their mesh sizes. */
void ovr_newton_fill(ovr_hierarchy *grids);

/* One Newton step with |dP| <= limit and |dH0| <= 2/3 limit max(1, H_cen). The
 * level's film and properties must be up to date before the call and are out of
 * date after it. Returns false if the matrix is singular. */
bool ovr_newton_step(ovr_hierarchy *grids, ovr_level *level, double limit);

#endif
