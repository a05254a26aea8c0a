/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The flow law of a lubricant. */
#include <math.h>

#include "overroll/contact.h"

static ovr_status stress_number(const ovr_contact *contact,
                                const ovr_flow_form *form, double *Sigma0,
                                ovr_error *err)
{
    double unit = contact->ph * contact->kappa;
    if (!isnan(form->stress) && !isnan(form->number))
        return ovr_fail_about(err, "eyring_number",
                              "eyring_stress is given too: leave one out");
    if (isnan(form->stress) && isnan(form->number))
        return ovr_fail_about(err, "rheology",
                              "eyring_stress is missing (or eyring_number, the "
                              "same over ph b/R)");
    if (!isnan(form->stress) && isnan(unit))
        return ovr_fail_about(err, "eyring_stress",
                              "needs b/R: give modulus (or G) and alpha, or "
                              "give eyring_number, the stress over ph b/R");
    *Sigma0 = isnan(form->stress) ? form->number : form->stress / unit;
    if (*Sigma0 > 0)
        return OVR_OK;
    return ovr_fail_about(
        err, isnan(form->stress) ? "eyring_number" : "eyring_stress",
        "must be positive");
}

ovr_status ovr_lubricant_flow(const ovr_contact *contact,
                              const ovr_flow_form *form,
                              ovr_lubricant *lubricant, ovr_error *err)
{
    double Sigma0 = 0;
    if (form->rheology == OVR_NEWTONIAN &&
        !(isnan(form->stress) && isnan(form->number)))
        return ovr_fail_about(
            err, isnan(form->stress) ? "eyring_number" : "eyring_stress",
            "has no meaning with rheology = newtonian");
    if (!(form->limiting_shear >= 0))
        return ovr_fail_about(err, "limiting_shear", "must not be negative");
    if (form->limiting_shear > 0 && isnan(contact->kappa))
        return ovr_fail_about(err, "limiting_shear",
                              "needs b/R: give modulus or G");
    if (form->rheology != OVR_NEWTONIAN &&
        stress_number(contact, form, &Sigma0, err))
        return OVR_BAD_INPUT;
    lubricant->rheology = form->rheology;
    lubricant->Sigma0 = Sigma0;
    lubricant->limiting_shear = form->limiting_shear;
    return OVR_OK;
}
