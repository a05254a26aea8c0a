/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat as the library makes and asks it. */
#ifndef OVR_CONTACT_HEAT_NUMBERS_H
#define OVR_CONTACT_HEAT_NUMBERS_H

#include "overroll/heat.h"

/* Heat needs to know these, SI; NAN: not given. */
typedef struct ovr_heat_form {
    int points;         /* across the film: 5, or 7; 0: by the steady start */
    double temperature; /* of the supplied oil, K */
    double bulk[2];     /* of the bodies, K; NAN: the same */
    ovr_thermal oil, body[2];
    double expansion;     /* of the oil by volume at p = 0, 1/K */
    bool density_expands; /* else it heats where it is compressed, alone */
    double S0, beta;      /* one of them; beta in 1/K */
} ovr_heat_form;

/* Fails with OVR_BAD_INPUT about what is missing. */
ovr_status ovr_heat_make(const ovr_heat_form *form, const ovr_contact *contact,
                         const ovr_lubricant *lubricant, ovr_heat *heat,
                         ovr_error *err);

/* ln(eta/eta0) at the rise T from that at T0 and the same pressure. */
double ovr_heat_log_viscosity(const ovr_heat *given, double log_eta, double T);

/* -d ln eta/dT there. */
double ovr_heat_viscosity_fall(const ovr_heat *given, double log_eta, double T);

#endif
