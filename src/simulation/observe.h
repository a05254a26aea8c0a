/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Observation of a state: film thickness, pressure, flow, friction, extremes.
 */
#ifndef OVR_SIMULATION_OBSERVE_H
#define OVR_SIMULATION_OBSERVE_H

#include <stdbool.h>
#include <stddef.h>

#include "simulation/internal.h"

/* Finds the extremes of a curve between its nodes, and its prominent maxima. */

/* A maximum is prominent if it exceeds the lowest value between it and the
 * previous maximum by more than this (in p_h). */
#define OVR_PROMINENCE 1e-3

/* Vertex of the parabola through nodes i-1, i, i+1, where node i is an extreme:
 * returns its position and sets *value. If the vertex is more than D away or
 * differs from the nodal value by more than 5 %, the mesh does not resolve it,
 * and the node itself is returned. */
double ovr_vertex(const double *X, const double *v, size_t i, double *value);

/* Returns the number of prominent maxima; *last is the last of them. If
 * neighbouring maxima are not separated by a sufficient minimum, only the
 * highest counts. */
int ovr_prominent_maxima(size_t n, const double *P, size_t *last);

/* Mass flow of the discrete scheme at half node i + 1/2; Cu = um/um0. */
double ovr_flux(const ovr_simulation *sim, double Cu, size_t i);

/* Upstream value of a content q at i + 1/2 in the scheme; and the flow there
 * contributed by physical models (physics.h). */
double ovr_upstream(const ovr_simulation *sim, const double *q, size_t i);
double ovr_flow_of_physics(const ovr_simulation *sim, size_t i, bool mean);

/* Relative mass balance error of the last step. */
double ovr_mass_balance(const ovr_simulation *sim);

/* Computes friction coefficients and powers of the film last read (friction.c).
 */
void ovr_observe_friction(ovr_simulation *sim, ovr_observation *o);

/* Returns 0 for a sliding force that is rounding; otherwise the force. */
double ovr_sliding_force(double force, double rolling);

/* Computes forces, coefficients and power_in from F_slide, F_roll and the
 * forces on slopes. */
void ovr_friction_forces(const ovr_simulation *sim, ovr_observation *o);
const double *ovr_wall_stress(const ovr_simulation *sim, int surface,
                              double *workspace);

/* Sets the pointers of the public state to the solution. */
void ovr_publish_state(ovr_simulation *sim);

/* Returns whether the maximum pressure is resolved, where P_unresolved is the
 * height of an unresolved spike on finer grids; 0: no such spike. */
bool ovr_is_resolved(double P_max, double P_unresolved);

/* Adds an observation to the extremes and means of the run; sets all to
 * unknown; returns the address of one of them. */
void ovr_statistics_take(ovr_statistics *s, const ovr_observation *o,
                         bool first);
void ovr_statistics_unknown(ovr_statistics *s);
/* Flags the extremes that this observation has set. */
void ovr_statistics_flag(ovr_statistics *s, const ovr_observation *o);
/* True if the extreme is from a flagged step. */
bool ovr_extreme_is_flagged(const ovr_extreme *which, const ovr_statistics *of);
double *ovr_kept_number(const ovr_extreme *which, ovr_statistics *of);

/* Observes film thickness, pressure, mass flow and friction of the line in
 * `now`. */
void ovr_observe_line(ovr_simulation *sim, ovr_observation *o);

/* Fills the state's fields and the observation from the finest level. */
void ovr_observe(ovr_simulation *sim, double dT, const ovr_outcome *outcome);

#endif
