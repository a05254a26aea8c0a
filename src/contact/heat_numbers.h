/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dimensionless numbers of heat, for use inside the library. */
#ifndef OVR_CONTACT_HEAT_NUMBERS_H
#define OVR_CONTACT_HEAT_NUMBERS_H

#include "overroll/heat.h"

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
