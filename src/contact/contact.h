/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts, lubricants and histories as the library makes and asks them. */
#ifndef OVR_CONTACT_CONTACT_H
#define OVR_CONTACT_CONTACT_H

#include "overroll/contact.h"

/* Beyond these a number is a slip of the pen, not a contact: for programs and
 * for the keys of a case alike. */
#define OVR_M_MIN 1e-3
#define OVR_M_MAX 1e6
#define OVR_L_MAX 1e3
#define OVR_CARREAU_N_MIN 0.05
#define OVR_CARREAU_A_MIN 0.1
#define OVR_CARREAU_A_MAX 10.0

/* A flow law: its stress in Pa, or as a number, the other one NAN. */
typedef struct ovr_flow_form {
    ovr_rheology rheology;
    double stress;         /* tau0, Pa */
    double number;         /* Sigma0 = tau0/(ph b/R) */
    double limiting_shear; /* of the mean shear stress, for friction */
    double n, a;           /* Carreau-Yasuda: exponents, 0.5 and 2 */
    /* Points of a table, both increasing, the stress no faster than the rate;
     * borrowed.  Its stress, which is but a scale, in the units of `shear`. */
    size_t points;
    const double *rate, *shear;
    const ovr_flow_law *law; /* of all but Newtonian and Eyring */
} ovr_flow_form;

/* A history as its user gives it; times in b/um, values relative to nominal. */
typedef struct ovr_history_form {
    ovr_history_kind kind;
    double from, to;          /* ramp, step: value before and after */
    double start, duration;   /* ramp (quintic smoothstep), step: duration 0 */
    double amplitude, period; /* sine */
    size_t points;            /* table */
    const double *T, *value;  /* table, T increasing; copied */
    double mean;              /* sine: what it is about, and before start; 1 */
} ovr_history_form;

/* The table of Carreau's law or that of points; a second's tenth of work.
 * Returns NULL on failure. */
ovr_flow_law *ovr_flow_law_create(const ovr_flow_form *given,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_flow_law_free(ovr_flow_law *law);

/* Sets the rheological model of the lubricant.  Fails if a stress in Pa is
 * given and b/R or ph is not known, or both or neither of the two. */
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

/* The time from which on it does not change any more; INFINITY: it never
 * ends. */
double ovr_history_end(const ovr_history *history);

/* Integral of the value from 0 to T, exact for the analytic kinds: how far
 * the mean surface has moved when the history is the speed ratio Cu. */
double ovr_history_integral(const ovr_history *history, double T);

/* The speed of a surface, over um0; arguments as below. */
double ovr_surface_speed(const ovr_history *speed, const ovr_history *sliding,
                         double ratio, int surface, double T);

/* The distance that a surface has moved from 0 to T, in b: ratio = u_k/um of
 * the nominal speeds times the integral of Cu; with a history of the sliding V
 * = (u1 - u2)/um0 the integral of Cu +- V/2. */
double ovr_surface_distance(const ovr_history *speed,
                            const ovr_history *sliding, double ratio,
                            int surface, double T);

/* Value 1 at all times. */
ovr_history_form ovr_history_form_default(void);
ovr_flow_form ovr_flow_form_default(void);

/* Relative density at one dimensionless pressure. */
double ovr_density(const ovr_lubricant *lubricant, double P);

/* Value at T (a NULL history is 1). */
double ovr_history_value(const ovr_history *history, double T);

/* (u1 - u2)/um, 0 where it is rounding: at the pitch point of a gear. */
double ovr_slip_ratio(double u1, double u2, double um);

/* The slip u_1 - u_2 and the speed of surface k (0 or 1) at T, over the
 * contact's um.  Without a history of the slip it is the contact's, as the
 * speed grows. */
double ovr_slip_at(const ovr_contact *c, const ovr_history *speed,
                   const ovr_history *sliding, double T);
double ovr_speed_at(const ovr_contact *c, const ovr_history *speed,
                    const ovr_history *sliding, int k, double T);

/* True if its value is ever another than at T = 0. */
bool ovr_history_varies(const ovr_history *history);

#endif
