/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The coarsest grid: Reynolds equation, film and force balance solved
 * together by Newton's method with the full Jacobian matrix,
 *
 *     sum_j J_ij dP_j + J_i0 dH0 = r_i    at nodes in play
 *     dP_i = 0                            at held nodes: dry, not rising
 *     D sum_j dP_j = force - D sum_j P_j
 *
 * With mass-conserving cavitation no node is held; the unknowns are the
 * pressures of pressurized nodes and the contents of cavitated nodes
 * (content.h).  H0 changes nowhere else.
 */
#ifndef OVR_MULTIGRID_COARSEST_H
#define OVR_MULTIGRID_COARSEST_H

#include "multigrid/hierarchy.h"

/* The number of coarsest levels that it solves: two, of mass-conserving
 * cavitation three (the supply is reduced there). */
int ovr_newton_levels(const ovr_hierarchy *grids);

/* Memory for steps on them. */
ovr_status ovr_newton_prepare(ovr_hierarchy *grids, ovr_arena *arena,
                              ovr_error *err);

/* Space for the deformation's kernel of n nodes. */
double *ovr_newton_kernel(size_t n, ovr_arena *arena, ovr_error *err);

/* The deformation's kernel of those levels, once their grids are known. */
void ovr_newton_fill(ovr_hierarchy *grids);

/* One step with |dP| <= limit and |dH0| <= 2/3 limit max(1, H_cen).  Film and
 * properties of the level must be up to date before and are not after.  False
 * when the matrix is singular. */
bool ovr_newton_step(ovr_hierarchy *grids, ovr_level *level, double limit);

#endif
