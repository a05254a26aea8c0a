/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady contact with mass-conserving cavitation (content.h).
 *
 * Flooded: the pressure satisfies the Reynolds equation, and the whole flow
 * continues downstream of the film.  Starved: the supply is reduced from the
 * flooded flow by halves at most, on the finest of the levels that are solved
 * by Newton's method, then refined level by level.
 *
 * A coarse grid's flooded flow is not the finest's (half of it at M = 200 and
 * 225 nodes), so the supply of a level is the same share of its own flooded
 * flow, q_l = q (1 - c 4^-l), c by the flows of the coarsest and the finest.
 * Where that fails, just below the flooded flow, the last tenth of the supply
 * is added on the finest level, in steps.
 */
#ifndef OVR_MULTIGRID_STARVED_H
#define OVR_MULTIGRID_STARVED_H

#include "multigrid/full.h"

/* Cycles until the film of a level is solved or given up, with more sweeps and
 * a finer coarsest grid where they stall. */
ovr_defect ovr_content_cycles(ovr_hierarchy *grids, const ovr_full *how,
                              ovr_level *level, int *cycles);

/* Begins with the flooded pressure of the Reynolds equation on the finest
 * level: makes its contents, and cycles until it is solved. */
ovr_defect ovr_flooded(ovr_hierarchy *grids, const ovr_full *how, int *cycles);

/* The flow that passes the contact: q of the last node, where nothing but Cu
 * moves. */
double ovr_content_leaving(const ovr_level *level);

/* Continues from the flooded solution on the finest level to the solution with
 * the supply q, smaller than the present outflow. */
ovr_defect ovr_starve(ovr_hierarchy *grids, const ovr_full *how, double q,
                      int *cycles);

#endif
