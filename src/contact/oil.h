/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A lubricant in SI units: constants of its laws, viscosity at temperatures
 * from data sheets, and tables of measured values.
 *
 * The viscosity law applies at the temperature of the case. For some laws its
 * constants also determine the viscosity eta0 and the coefficient alpha:
 *   Doolittle alpha = B R0/((1 - R0)^2 K0)
 *   Yasutomi  eta0 and alpha at the temperature T
 *   table     eta0 and alpha of its first point
 * alpha is the slope of ln eta at p = 0.
 */
#ifndef OVR_CONTACT_OIL_H
#define OVR_CONTACT_OIL_H

#include "overroll/contact.h"

typedef struct ovr_law_table ovr_law_table;

typedef enum ovr_table_of {
    OVR_TABLE_OF_VISCOSITY, /* Pa s */
    OVR_TABLE_OF_DENSITY    /* kg/m3 or any other unit, because only ratios are
                             * used */
} ovr_table_of;

/* A lubricant; NAN: not given. */
typedef struct ovr_oil {
    ovr_viscosity_law viscosity_law;
    ovr_density_law density_law;
    double temperature;            /* K */
    double viscosity;              /* eta0 at that temperature, Pa s */
    double alpha;                  /* pressure-viscosity coefficient, 1/Pa */
    double p0, z;                  /* Roelands: p0 in Pa, z dimensionless */
    double tait_K0, tait_K0_slope; /* Tait's K_0 in Pa and K' (dimensionless) at
                                      this temperature */
    double doolittle_B, doolittle_R0;
    ovr_yasutomi yasutomi;  /* A2, b1 in 1/Pa; T is the temperature of the case
                             */
    double glass_viscosity; /* Yasutomi: at the glass transition, Pa s */
    double nu_40, nu_100;   /* in m2/s, at 40 and 100 degC */
    double density_15;      /* kg/m3 at 15 degC; NAN: 870 */
    double viscosity_index; /* in place of nu_100 */
    double S0, beta;        /* decrease of viscosity with temperature: Roelands'
                             * S0; -d ln eta/dT at p = 0, 1/K */
    const ovr_law_table *viscosity_table, *density_table;
    int mineral; /* 1: estimate alpha of a mineral oil if it is not given */
} ovr_oil;

/* Measured points of a law. */
typedef struct ovr_law_points {
    ovr_table_of of;
    size_t n;
    const double *p, *value;
} ovr_law_points;

/* Creates a table from n >= 2 points: p in Pa, increasing, the first between 0
 * and 1 MPa; values positive and not decreasing. Between the points ln(eta) or
 * rho follows Steffen's monotone spline in p, sampled at 1024 grid intervals;
 * beyond the ends it is continued linearly. */
ovr_law_table *ovr_law_table_create(const ovr_law_points *points,
                                    const ovr_allocator *allocator,
                                    ovr_error *err);
void ovr_law_table_free(ovr_law_table *table);

/* Sets viscosity and alpha from the law or the data sheet. Fails with
 * OVR_BAD_INPUT; the message names what is missing, given twice or out of
 * range. */
ovr_status ovr_oil_complete(ovr_oil *oil, ovr_error *err);

/* The lubricant in the scaling of a contact. Its tables must outlive the
 * result. If L = 0, the lubricant is isoviscous and incompressible for all
 * laws. */
ovr_status ovr_oil_scale(const ovr_oil *oil, const ovr_contact *contact,
                         ovr_lubricant *lubricant, ovr_error *err);

/* Kinematic viscosity at T (K) by Walther's form of ASTM D341,
 *   log10 log10(nu + 0.7) = A - B log10 T,  nu in mm2/s
 * through the values at 40 and 100 degC; all in m2/s. */
double ovr_walther(double nu_40, double nu_100, double T);

/* Viscosity index by ASTM D2270 (ISO 2909) from viscosities in m2/s, NAN if the
 * viscosity at 100 degC is below 2 mm2/s; and the inverse: the viscosity at 100
 * degC. */
double ovr_viscosity_index(double nu_40, double nu_100);
double ovr_viscosity_at_100(double nu_40, double index);

/* Laws of Roelands and Dowson-Higginson; all numbers NAN. */
ovr_oil ovr_oil_default(void);

/* Blok's reciprocal asymptotic isoviscous pressure coefficient times p_h:
 * 1/(integral from 0 to infinity of dP/eta(P)) with relative eta; NAN if the
 * viscosity does not increase. */
double ovr_asymptotic_alphabar(const ovr_lubricant *lubricant);

#endif
