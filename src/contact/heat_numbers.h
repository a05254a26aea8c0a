/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Heat in film and solids, in the contact's scaling; temperatures are in K,
 * rises above that of the supplied oil.
 *
 *     Theta = ph/(rho0 c)                     K
 *     Kf = k R^2/(rho0 c um b^3)              conduction across the film
 *     N_k = k R b^(-3/2)/sqrt(pi k_k rho_k c_k um)   body k
 *     Pe_k = |u_k| b rho_k c_k/k_k
 *     kappa_k = k_k/(rho_k c_k um b)          along surface k
 *
 * Viscosity falls with temperature, with x = (T0 - 138 K + T)/(T0 - 138 K) by
 *     Roelands   ln eta = (ln eta(T0) + C) x^(-S0) - C,  C = alpha p0/z
 *     others     ln eta = ln eta(T0) - beta T
 * where beta = S0 C/(T0 - 138 K) at ambient pressure.
 */
#ifndef OVR_CONTACT_HEAT_NUMBERS_H
#define OVR_CONTACT_HEAT_NUMBERS_H

#include <stdbool.h>

#include "overroll/contact.h"

#define OVR_ROELANDS_T                                                         \
    138.0 /* K: temperature at which Roelands' viscosity is singular */

/* Thermal properties of a material, SI units. */
typedef struct ovr_thermal {
    double conductivity, heat_capacity, density; /* W/m.K, J/kg.K, kg/m3 */
} ovr_thermal;

/* Dimensionless numbers, all zero for an isothermal film. */
typedef struct ovr_heat {
    int points;               /* number of points across the film */
    double T0;                /* K */
    double bulk[2];           /* temperature rises */
    double theta, conduction; /* Theta, Kf */
    double solid[2];          /* N_k with um */
    double peclet[2];
    double min_peclet; /* minimum for the steady march along x; 0.1 */
    double expansion;  /* 1/K; 0: incompressible oil */
    bool density_expands;
    double S0, C, beta; /* C = 0: not Roelands */
    double A; /* 5.9e8 Pa/ph; thermal expansion of the oil is `expansion` times
                 f = A^2/((A + P)(A + 1.34 P)); 0: f = 1 */
    double diffusion[2]; /* k_k/(rho_k c_k um b): along surface k; 0: none */
    double slowest[2]; /* minimum |u_k|/um during the run of a case; determines
                          the heat history */
} ovr_heat;

/* Input of the heat model in SI units; NAN: not given. */
typedef struct ovr_heat_form {
    int points;         /* across the film: 5, or 7; 0: automatic, from the
                         * steady start */
    double temperature; /* supply temperature, K */
    double bulk[2];     /* temperature of the bodies, K; NAN: supply temperature
                         */
    ovr_thermal oil, body[2];
    double expansion;     /* thermal expansion of the lubricant at p = 0, 1/K */
    bool density_expands; /* the density depends on temperature; otherwise
                           * expansion causes compression heating only */
    double S0, beta;      /* one of them is given; beta in 1/K */
} ovr_heat_form;

/* Fails with OVR_BAD_INPUT; the message names missing values. */
ovr_status ovr_heat_make(const ovr_heat_form *form, const ovr_contact *contact,
                         const ovr_lubricant *lubricant, ovr_heat *heat,
                         ovr_error *err);

/* ln(eta/eta0) at temperature rise T, from that at T0 and the same pressure. */
double ovr_heat_log_viscosity(const ovr_heat *given, double log_eta, double T);

/* -d ln eta/dT at the same state. */
double ovr_heat_viscosity_fall(const ovr_heat *given, double log_eta, double T);

#endif
