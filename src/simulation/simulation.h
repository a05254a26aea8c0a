/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Functions of the simulation for use inside the library. */
#ifndef OVR_SIMULATION_SIMULATION_H
#define OVR_SIMULATION_SIMULATION_H

#include "overroll/simulation.h"

/* Heights of surface 1 or 2, or of both (0), at n nodes along x and on lines
 * across; element (i, j) is S[i stride + j]. */
typedef void ovr_heights_across(void *data, int surface, double T, size_t n,
                                const double *X, size_t lines, const double *Y,
                                size_t stride, double *S);

/* Memory in bytes that ovr_simulation_create would allocate, determined by the
 * same set-up without allocation. Automatic options are those of a moderate
 * contact. INFINITY: invalid options, or more than this process can address. */
double ovr_simulation_memory(const ovr_options *options);

/* Sets the time histories of load and speed, which are borrowed; NULL: 1.
 * Negative speeds require a symmetric domain and Reynolds cavitation. */
void ovr_simulation_histories(ovr_simulation *sim, const ovr_history *load,
                              const ovr_history *speed);

/* Sets V = (u1 - u2)/um0 as a function of time, of any sign, in place of Cu
 * times that of the contact; u_k/um0 = Cu +- V/2. Borrowed; NULL: none. */
void ovr_simulation_sliding(ovr_simulation *sim, const ovr_history *sliding);

/* Sets R relative to the reference radius as a function of time. The gap of the
 * smooth surfaces is R0/R X^2/2; all units are those of the reference contact.
 * `convected`: the curvature belongs to the material passing through, as on an
 * involute or a cam; a cubic term distinguishes it from a curvature that
 * changes everywhere at once (overroll-theory(7)). radius_1 = R_1/R0 of surface
 * 1 alone (negative: concave) if known, else NULL. Not for stationary surfaces:
 * a step is rejected if the cubic term would close the gap within the domain.
 * Borrowed; NULL: 1. */
void ovr_simulation_radius(ovr_simulation *sim, const ovr_history *radius,
                           const ovr_history *radius_1, bool convected);

/* Sets the heights on surface 1 and on surface 2 (NULL: none), called with the
 * data of ovr_simulation_surface.  Without this call all features are on one
 * surface. The speed of this surface is the argument of ovr_simulation_moving;
 * surface 1 if both have that speed or it is unknown. */
void ovr_simulation_sides(ovr_simulation *sim, ovr_heights *heights_1,
                          ovr_heights *heights_2);

/* Sets features of both surfaces that vary across the rolling direction, with
 * the data of ovr_simulation_surface, which removes them. Used by strip
 * contacts only. */
void ovr_simulation_across(ovr_simulation *sim, ovr_heights_across *heights);

/* Returns the Y of the lines of a strip, b, their number and the shown line;
 * NULL, 1 and 0 for a line contact. */
const double *ovr_simulation_lines(const ovr_simulation *sim, size_t *count,
                                   size_t *shown);

/* Returns the mean shear stress of the lubricant across the film at half nodes,
 * in p_h b/R, without boundary friction. */
const double *ovr_film_stress(const ovr_simulation *sim);

/* Number of points across the film: the requested number, or by default 5 (7 if
 * the steady solution needs them); 0: no heat. */
int ovr_simulation_heat_points(const ovr_simulation *sim);

/* Order of the last steady solution and of a run starting from it: 4; 2 (also
 * if order 4 was requested but its corrections did not converge, or load, speed
 * or radius vary); or 1. */
int ovr_simulation_order(const ovr_simulation *sim);

/* Describes the strategy of the last steady solution; "" if the first attempt
 * succeeded. */
const char *ovr_simulation_strategy(const ovr_simulation *sim);

/* Returns the field with this name, or NULL. */
const ovr_observable *ovr_observable_field(const char *name);

/* Called for each part of a state with its name, address and size in bytes. */
typedef ovr_status ovr_visit(void *context, const char *name, void *memory,
                             size_t bytes, ovr_error *err);

/* Calls visit(context, name, address, size in bytes) for every piece of memory
 * that makes up the state between two steps: writing all of them and reading
 * them by name into a simulation with the same options continues the run bit
 * for bit. A number (at most 8 bytes) that is not read keeps its default.
 * Stops at the first status that is not OVR_OK and returns it. */
ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err);
/* Visits "S", the heights of the surface at the nodes, which a resumed run
 * compares with its own surface. */
ovr_status ovr_simulation_visit_heights(ovr_simulation *sim, ovr_visit *visit,
                                        void *context, ovr_error *err);
/* Must be called after a visit that has written to the simulation. */
void ovr_simulation_restored(ovr_simulation *sim);

/* Names of the smoothers ("line", ...), the values of solver.smoother. */
const char *ovr_smoother_name(ovr_smoother smoother);

#endif
