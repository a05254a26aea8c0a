/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts, lubricants and time histories: functions for use inside the
 * library. */
#ifndef OVR_CONTACT_CONTACT_H
#define OVR_CONTACT_CONTACT_H

#include "overroll/contact.h"

/* Limits of plausible numbers, for programs and for keys of a case. */
#define OVR_M_MIN 1e-3
#define OVR_M_MAX 1e6
#define OVR_L_MAX 1e3
#define OVR_CARREAU_N_MIN 0.05
#define OVR_CARREAU_A_MIN 0.1
#define OVR_CARREAU_A_MAX 10.0

/* A rheological model: its stress in Pa, or as a dimensionless number; the
 * other one is NAN. */
typedef struct ovr_flow_form {
    ovr_rheology rheology;
    double stress;         /* tau0, Pa */
    double number;         /* Sigma0 = tau0/(ph b/R) */
    double limiting_shear; /* maximum of the mean shear stress divided by the
                            * pressure, for friction */
    double n, a;           /* Carreau-Yasuda: exponents, 0.5 and 2 */
    /* points of a table, both increasing, the stress not faster than the rate;
     * borrowed. `stress` scales the table, in the units of `shear` */
    size_t points;
    const double *rate, *shear;
    const ovr_flow_law *law; /* for all models except Newtonian and Eyring */
} ovr_flow_form;

/* Input for a time history; times in b/um, values relative to the reference
 * value. */
typedef struct ovr_history_form {
    ovr_history_kind kind;
    double from, to;          /* ramp, step: values before and after */
    double start, duration;   /* ramp (quintic smoothstep), step: duration 0 */
    double amplitude, period; /* sine */
    size_t points;            /* table */
    const double *T, *value;  /* table, T increasing; copied */
    double mean;              /* sine: mean value, also the value before start;
                               * default 1 */
} ovr_history_form;

/* Creates the table of Carreau's model or of measured points; takes a tenth of
 * a second. Returns NULL on failure. */
ovr_flow_law *ovr_flow_law_create(const ovr_flow_form *given,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_flow_law_free(ovr_flow_law *law);

/* Sets the rheological model of the lubricant. Fails if a stress in Pa is given
 * and b/R or p_h is unknown, or if both or neither of stress and number are
 * given. */
ovr_status ovr_lubricant_flow(const ovr_contact *contact,
                              const ovr_flow_form *given,
                              ovr_lubricant *lubricant, ovr_error *err);

/* Relative viscosity at one dimensionless pressure. */
double ovr_viscosity(const ovr_lubricant *lubricant, double P);

ovr_history *ovr_history_create(const ovr_history_form *given,
                                const ovr_allocator *allocator, ovr_error *err);
void ovr_history_free(ovr_history *history);

/* Slope at T. At the ends of a sine or a table it is the slope inside; at jumps
 * it is 0. */
double ovr_history_slope(const ovr_history *history, double T);

/* Time after which the value is constant; INFINITY: never. */
double ovr_history_end(const ovr_history *history);

/* Integral of the value from 0 to T, exact for the analytic kinds: the distance
 * moved at the entrainment speed if the history is the speed ratio Cu. */
double ovr_history_integral(const ovr_history *history, double T);

/* Speed of a surface relative to um0; arguments as below. */
double ovr_surface_speed(const ovr_history *speed, const ovr_history *sliding,
                         double ratio, int surface, double T);

/* Distance moved by a surface from 0 to T, in b: ratio = u_k/um at the
 * reference speeds times the integral of Cu. With a sliding history V = (u1 -
 * u2)/um0 the integral of Cu +- V/2. */
double ovr_surface_distance(const ovr_history *speed,
                            const ovr_history *sliding, double ratio,
                            int surface, double T);

/* History with the value 1 at all times. */
ovr_history_form ovr_history_form_default(void);
ovr_flow_form ovr_flow_form_default(void);

/* Relative density at one dimensionless pressure. */
double ovr_density(const ovr_lubricant *lubricant, double P);

/* Value at T (a NULL history is 1). */
double ovr_history_value(const ovr_history *history, double T);

/* (u1 - u2)/um; exactly 0 if the difference is rounding error, as at the pitch
 * point of a gear. */
double ovr_slip_ratio(double u1, double u2, double um);

/* Sliding speed u_1 - u_2 and speed of surface k (0 or 1) at T, relative to the
 * contact's um. Without a sliding history the sliding speed is that of the
 * contact times the speed ratio. */
double ovr_slip_at(const ovr_contact *c, const ovr_history *speed,
                   const ovr_history *sliding, double T);
double ovr_speed_at(const ovr_contact *c, const ovr_history *speed,
                    const ovr_history *sliding, int k, double T);

/* True if the value ever differs from that at T = 0. */
bool ovr_history_varies(const ovr_history *history);

#endif
