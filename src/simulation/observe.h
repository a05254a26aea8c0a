/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The observed numbers of a state: film, pressure, flow, friction, extremes. */
#ifndef OVR_SIMULATION_OBSERVE_H
#define OVR_SIMULATION_OBSERVE_H

#include <stdbool.h>
#include <stddef.h>

#include "simulation/internal.h"

/* Finds where a curve is smallest and largest between its nodes, and which of
 * its maxima stand out. */

/* A maximum stands out when it is more than this above the lowest value
 * between it and the maximum before it (in ph). */
#define OVR_PROMINENCE 1e-3

/* The vertex of the parabola through nodes i-1, i, i+1, node i being an
 * extreme: its place, and *value.  Where the vertex
 * would be further than a mesh away, or differ from the node by more than 5 %
 * of the node's value, the mesh does not carry it: the node itself. */
double ovr_vertex(const double *X, const double *v, size_t i, double *value);

/* The number of maxima that stand out; *last is the last of them.  Of those
 * that do not stand out from each other the highest is taken. */
int ovr_prominent_maxima(size_t n, const double *P, size_t *last);

/* The scheme's own mass flow at the half node i + 1/2; Cu = um/um0. */
double ovr_flux(const ovr_simulation *sim, double Cu, size_t i);

/* Upstream value of a content q at i + 1/2 in the scheme; what flows
 * there beside the film's own (physics.h). */
double ovr_upstream(const ovr_simulation *sim, const double *q, size_t i);
double ovr_flow_of_physics(const ovr_simulation *sim, size_t i, bool mean);

/* Relative error of the mass balance over the step just made. */
double ovr_mass_balance(const ovr_simulation *sim);

/* Friction of the film that was read last (friction.c), its coefficients and
 * powers; shear stress in the film at a surface, at half nodes. */
void ovr_observe_friction(ovr_simulation *sim, ovr_observation *o);

/* Returns 0 for a sliding force that is rounding; otherwise the force. */
double ovr_sliding_force(double force, double rolling);

/* Computes forces, coefficients and power_in from F_slide, F_roll and the
 * forces on slopes. */
void ovr_friction_forces(const ovr_simulation *sim, ovr_observation *o);
const double *ovr_wall_stress(const ovr_simulation *sim, int surface,
                              double *workspace);

/* Points the public state at the solution. */
void ovr_publish_state(ovr_simulation *sim);

/* Adds an observation to the extremes and means of the run; none of them
 * is known; where one of them is. */
void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first);
void ovr_statistics_unknown(ovr_statistics *s);
double *ovr_kept_number(const ovr_extreme *which, ovr_statistics *of);

/* Film, pressure, mass flow and friction of the line that `now` holds. */
void ovr_observe_line(ovr_simulation *sim, ovr_observation *o);

/* Fills the state's fields and the observation from the finest level. */
void ovr_observe(ovr_simulation *sim, double dT, const ovr_outcome *outcome);

#endif
