/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heat as the library makes and asks it. */
#ifndef OVR_CONTACT_HEAT_H
#define OVR_CONTACT_HEAT_H

#include "overroll/heat.h"

/* Fails with OVR_BAD_INPUT about what is missing. */
ovr_status ovr_heat_make_into(const ovr_heat_form *form,
                              const ovr_contact *contact,
                              const ovr_lubricant *lubricant, ovr_heat *heat,
                              ovr_error *err);
static inline ovr_status ovr_heat_make(const ovr_heat_form *form,
                                       const ovr_contact *contact,
                                       const ovr_lubricant *lubricant,
                                       ovr_heat *heat, ovr_error *err)
{
    if (heat)
        heat->size = sizeof *heat;
    return ovr_heat_make_into(form, contact, lubricant, heat, err);
}

/* ln(eta/eta0) at the rise T from that at T0 and the same pressure. */
double ovr_heat_log_viscosity(const ovr_heat *given, double log_eta, double T);

/* -d ln eta/dT there. */
double ovr_heat_viscosity_fall(const ovr_heat *given, double log_eta, double T);

#endif
