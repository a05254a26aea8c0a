/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Power dissipated by the pressure flow, consistent with the Reynolds equation.
 *
 * At a node this power is p_i = sum w_j s_j (H P_X/2) u_z,j with P_X by central
 * differences (cross_film.h).  On the flank of a pressure spike the viscosity
 * changes by a large factor between two nodes.  The sum of p_i D then differs
 * from the power of the discrete flow by up to several times, on any grid.  The
 * temperature depended on the position of the flank between the nodes, and
 * there were several steady solutions.
 *
 * The heat source is therefore changed to the power at half nodes.  With P_X =
 * (P_{i+1} - P_i)/D, E of flow.h, and q s of skew.h,
 *
 *     p_{i+1/2} = (H_i + H_{i+1})/(q_i + q_{i+1}) Q P_X,  Q = E P_X - q s
 *     p_i <- p_i (c_{i-1/2} + c_{i+1/2})/2
 *     c_{i+1/2} = 2 p_{i+1/2}/(p_i + p_{i+1})
 *
 * The sum over the nodes is that over the half nodes.
 *
 * If the viscosity changes by more than a factor of e, the density changes too
 * much for the upstream differences of the wedge.  Q would be wrong by up to a
 * tenth. There it follows from the mass flow rate F of the last half node
 * upstream with a smaller factor:
 *
 *     Q <- (1 - f) Q + f [Cu (q_i + q_{i+1})/2 - F]
 *     F = Cu (q_i + q_{i+1})/2 - Q
 *
 * The fraction f increases from 0 to 1 between factors of e and e^2.  In time
 * steps with surface features, whose flow rate is not constant, f is 0.
 */
#ifndef OVR_PHYSICS_HEAT_FLOW_POWER_H
#define OVR_PHYSICS_HEAT_FLOW_POWER_H

#include "simulation/internal.h"

/* Allocates the powers. */
ovr_status ovr_heat_flow_power_take(ovr_simulation *sim, ovr_error *err);

/* Changes the heat source of the film last read. */
void ovr_heat_flow_power(ovr_simulation *sim);

#endif
