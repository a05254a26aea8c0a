/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts, lubricants and histories as the library makes and asks them. */
#ifndef OVR_CONTACT_CONTACT_H
#define OVR_CONTACT_CONTACT_H

#include "overroll/contact.h"

/* The table of Carreau's law or that of points; a second's tenth of work.
 * NULL: *err says why. */
ovr_flow_law *ovr_flow_law_create(const ovr_flow_form *given,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_flow_law_free(ovr_flow_law *law);

/* Gives the lubricant a flow law.  Fails if a stress in Pa is given and b/R or
 * ph is not known, or both or neither of the two. */
ovr_status ovr_lubricant_flow(const ovr_contact *contact,
                              const ovr_flow_form *given,
                              ovr_lubricant *lubricant, ovr_error *err);

/* Relative viscosity at one dimensionless pressure. */
double ovr_viscosity(const ovr_lubricant *lubricant, double P);

ovr_history *ovr_history_create(const ovr_history_form *given,
                                const ovr_allocator *allocator, ovr_error *err);
void ovr_history_free(ovr_history *history);

/* Its slope at T, of a sine and a table at their ends the one inside; 0 where
 * it jumps. */
double ovr_history_slope(const ovr_history *history, double T);

/* From when on it does not change any more; INFINITY: it never ends. */
double ovr_history_end(const ovr_history *history);

/* Integral of the value from 0 to T, exact for the analytic kinds: how far
 * the mean surface has moved when the history is the speed ratio Cu. */
double ovr_history_integral(const ovr_history *history, double T);

/* How fast a surface moves, over um0; arguments as below. */
double ovr_surface_speed(const ovr_history *speed, const ovr_history *sliding,
                         double ratio, int surface, double T);

/* How far a surface has moved from 0 to T, in b: ratio = u_k/um of the nominal
 * speeds times the integral of Cu; with a history of the sliding V = (u1 -
 * u2)/um0 the integral of Cu +- V/2. */
double ovr_surface_way(const ovr_history *speed, const ovr_history *sliding,
                       double ratio, int surface, double T);

#endif
