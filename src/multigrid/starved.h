/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady contact with mass-conserving cavitation (content.h).
 *
 * Flooded: the pressure satisfies the Reynolds equation, and the mass flow is
 * continuous into the cavitated region. Starved: the supply is reduced from the
 * flooded flow rate in steps by at most a half, on the finest level that is
 * solved by Newton's method. The solution is then refined level by level.
 *
 * The flooded flow rate of a coarse grid differs from that of the finest grid
 * (by half at M = 200 and 225 nodes). Therefore the supply of a level is the
 * same fraction of its own flooded flow rate, q_l = q (1 - c 4^-l), with c from
 * the flow rates of the coarsest and finest grids. If this fails (just below
 * the flooded flow rate), the last tenth of the supply reduction is made on the
 * finest level, in steps.
 */
#ifndef OVR_MULTIGRID_STARVED_H
#define OVR_MULTIGRID_STARVED_H

#include "multigrid/full.h"

/* Performs cycles until the level is solved or the attempt fails. If cycles
 * stall, continues with more sweeps and a finer coarsest grid. */
ovr_defect ovr_content_cycles(ovr_hierarchy *grids, const ovr_full *how,
                              ovr_level *level, int *cycles);

/* Starts from the flooded pressure of the Reynolds equation on the finest
 * level: computes the contents, and performs cycles until the level is solved.
 */
ovr_defect ovr_flooded(ovr_hierarchy *grids, const ovr_full *how, int *cycles);

/* Mass flow rate that leaves the contact: q of the last node, where the only
 * flow is Cu q. */
double ovr_content_leaving(const ovr_level *level);

/* Continues from the flooded solution on the finest level to the solution with
 * supply q, which is smaller than the present outflow. */
ovr_defect ovr_starve(ovr_hierarchy *grids, const ovr_full *how, double q,
                      int *cycles);

#endif
