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

/* Memory that ovr_simulation_create would take, bytes: counted in the same
 * set-up, which takes none here.  Where options are left automatic those of a
 * moderate contact count.  INFINITY: options that are refused, or more than
 * this process may address. */
double ovr_simulation_memory(const ovr_options *options);

/* For OVR_CAVITATION_CONSERVING: the supplied content q = rho H at the inlet at
 * time T >= 0 (before: that of T = 0). For layers h1, h2 it is (u1 h1 + u2
 * h2)/um. The excess over the flooded flow stays in the inlet reservoir;
 * `reservoir` of it, in b^3/R, is there at the start. When it is used up only
 * the film arrives.  INFINITY: the contact is flooded whatever comes.
 * Borrowed; NULL, the default: flooded. */
typedef double ovr_supply(void *data, double T);
void ovr_simulation_supply(ovr_simulation *sim, ovr_supply *supply, void *data,
                           double reservoir);

/* Sets the time histories of load and speed, which are borrowed; NULL: 1.
 * Negative speeds require a symmetric domain and Reynolds cavitation. */
void ovr_simulation_histories(ovr_simulation *sim, const ovr_history *load,
                              const ovr_history *speed);

/* V = (u1 - u2)/um0 in time, any sign, instead of Cu times that of the contact;
 * u_k/um0 = Cu +- V/2.  Borrowed; NULL: none. */
void ovr_simulation_sliding(ovr_simulation *sim, const ovr_history *sliding);

/* R over the nominal one in time: the gap of the smooth surfaces is then
 * R0/R X^2/2, all else in units of the nominal contact.  `convected`: what
 * varies is the curvature of the material that comes by, as on an involute or a
 * cam, which a cubic term tells from one that is imposed (overroll-theory(7));
 * of surface 1 alone radius_1 = R_1/R0 (negative: concave) where that is known,
 * else NULL.  Not where the surfaces stand: a step is refused where the cubic
 * would close the gap within the domain.  Borrowed; NULL: 1. */
void ovr_simulation_radius(ovr_simulation *sim, const ovr_history *radius,
                           const ovr_history *radius_1, bool convected);

/* Heat in solutions of second order, steady and in time: temperatures of film
 * and surfaces, and the viscosity by them.  To be called before anything is
 * solved; OVR_BAD_INPUT where options do not go with it.  An order that was
 * left to the library (0) is 2 from then on, as ovr_simulation_options tells.
 */
ovr_status ovr_simulation_heat(ovr_simulation *sim, const ovr_heat *heat,
                               ovr_error *err);

/* Sets the heights on surface 1 and on surface 2 (NULL: none), called with the
 * data of ovr_simulation_surface.  Without this call all features are on one
 * surface.  Its speed is the argument of ovr_simulation_moving; surface 1 if
 * both have that speed or it is unknown. */
void ovr_simulation_sides(ovr_simulation *sim, ovr_heights *heights_1,
                          ovr_heights *heights_2);

/* Features of both surfaces that vary across rolling, with the data of
 * ovr_simulation_surface, which removes them.  Only a strip asks for them. */
void ovr_simulation_across(ovr_simulation *sim, ovr_heights_across *heights);

/* Returns the Y of the lines of a strip, b, their number and the shown line;
 * NULL, 1 and 0 for a line contact. */
const double *ovr_simulation_lines(const ovr_simulation *sim, size_t *count,
                                   size_t *shown);

/* Returns the oil's mean shear stress across the film at half nodes, ph b/R,
 * without boundary friction. */
const double *ovr_film_stress(const ovr_simulation *sim);

/* Points across the film: those asked for, else 5 or, where the steady solution
 * needs them, 7; 0: no heat. */
int ovr_simulation_heat_points(const ovr_simulation *sim);

/* Order of the last steady solution, and of what a run keeps of it: 4, 2 (also
 * where 4 was asked for but its corrections did not converge, or load, speed or
 * radius vary), or 1. */
int ovr_simulation_order(const ovr_simulation *sim);

/* Describes the strategy of the last steady solution; "" if the first attempt
 * succeeded. */
const char *ovr_simulation_strategy(const ovr_simulation *sim);

/* A field by name, or NULL. */
const ovr_observable *ovr_observable_field(const char *name);

/* Calls visit(context, name, address, size in bytes) for every piece of
 * memory that makes up the state between two steps: writing them all and
 * reading them back, by name, into a simulation created alike continues bit for
 * bit.  A number (8 bytes at most) that is not written back has its
 * default.  Stops at the first status that is not OVR_OK and returns it. */
ovr_status ovr_simulation_visit(ovr_simulation *sim, ovr_visit *visit,
                                void *context, ovr_error *err);
/* Calls visit with "S", the heights of the surface at the nodes, by which a
 * resumed run checks that it has the same surface. */
ovr_status ovr_simulation_visit_heights(ovr_simulation *sim, ovr_visit *visit,
                                        void *context, ovr_error *err);
/* Has to be called after a visit that wrote into the simulation. */
void ovr_simulation_restored(ovr_simulation *sim);

/* "line", ...: the words of solver.smoother. */
const char *ovr_smoother_name(ovr_smoother smoother);

#endif
