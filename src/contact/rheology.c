/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rheological model of a lubricant. */
#include <math.h>

#include "contact/contact.h"

#include "base/error.h"
#include "base/given.h"

ovr_flow_form ovr_flow_form_default(void)
{
    const ovr_flow_form defaults = {
        .stress = NAN, .number = NAN, .n = 0.5, .a = 2};
    return defaults;
}

/* Keys of the stress: in Pa, and as a dimensionless number. */
static const char *const keys[][2] = {
    [OVR_NEWTONIAN] = {"eyring_stress", "eyring_number"},
    [OVR_EYRING] = {"eyring_stress", "eyring_number"},
    [OVR_CARREAU] = {"carreau_stress", "carreau_number"},
    [OVR_CARREAU_STRESS] = {"carreau_stress", "carreau_number"},
    [OVR_FLOW_TABLE] = {"rheology_file", "rheology_file"}};

static ovr_status stress_number(const ovr_contact *contact,
                                const ovr_flow_form *form, double *Sigma0,
                                ovr_error *err)
{
    const char *const *key = keys[form->rheology];
    double unit = contact->ph * contact->kappa;
    bool both = !isnan(form->stress) && !isnan(form->number);
    if (both)
        return ovr_fail_about(err, key[1],
                              "%s is also set; remove one of "
                              "the two",
                              key[0]);
    if (isnan(form->stress) && isnan(form->number))
        return ovr_fail_about(err, "rheology",
                              "%s is missing (or %s, the stress divided by "
                              "p_h b/R)",
                              key[0], key[1]);
    if (!isnan(form->stress) && isnan(unit))
        return ovr_fail_about(err, key[0],
                              "needs b/R; set modulus (or G) and alpha, or "
                              "use the stress divided by p_h b/R");
    *Sigma0 = isnan(form->stress) ? form->number : form->stress / unit;
    if (*Sigma0 > 0)
        return OVR_OK;
    return ovr_fail_about(err, key[isnan(form->stress)], "must be positive");
}

static ovr_status check_form(const ovr_contact *contact,
                             const ovr_flow_form *form, ovr_error *err)
{
    bool stress = !isnan(form->stress) || !isnan(form->number);
    if (form->rheology == OVR_NEWTONIAN && stress)
        return ovr_fail_about(err, keys[0][isnan(form->stress)],
                              "has no effect with rheology = newtonian; "
                              "remove it");
    if (!(form->limiting_shear >= 0))
        return ovr_fail_about(err, "limiting_shear", "must not be negative");
    if (form->limiting_shear > 0 && isnan(contact->kappa))
        return ovr_fail_about(err, "limiting_shear",
                              "needs b/R; set modulus or G");
    if (form->rheology > OVR_EYRING && !form->law)
        return ovr_fail_about(
            err, "rheology",
            "rheology needs the ovr_flow_law that was created from it");
    return OVR_OK;
}

ovr_status ovr_lubricant_flow(const ovr_contact *contact,
                              const ovr_flow_form *given,
                              ovr_lubricant *lubricant, ovr_error *err)
{
    ovr_flow_form form;
    ovr_contact of;
    ovr_lubricant oil;
    double Sigma0 = 0;
    if (OVR_TAKE(ovr_flow_form, &form, given, err) ||
        OVR_TAKE(ovr_contact, &of, contact, err) ||
        OVR_TAKE(ovr_lubricant, &oil, lubricant, err) ||
        check_form(&of, &form, err))
        return OVR_BAD_INPUT;
    if (form.rheology != OVR_NEWTONIAN &&
        stress_number(&of, &form, &Sigma0, err))
        return OVR_BAD_INPUT;
    oil.rheology = form.rheology;
    oil.Sigma0 = Sigma0;
    oil.limiting_shear = form.limiting_shear;
    oil.flow_law = form.law;
    if (lubricant)
        *lubricant = oil;
    return OVR_OK;
}
