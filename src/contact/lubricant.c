/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lubricant of a contact, and its laws (contact/laws) at one pressure. */
#include "overroll/contact.h"

#include <math.h>

#include "contact/laws/fluid.h"

static const double P0_PAPER = 1.98e8; /* Pa */
static const double Z_PAPER = 0.68;
static const double DENSITY_A = 5.9e8; /* Pa */

static ovr_status index_z(const ovr_contact *contact, double p0, double given,
                          double *z, ovr_error *err)
{
    *z = given;
    if (!isnan(given)) {
        if (given > 0 && given <= 2)
            return OVR_OK;
        return ovr_fail_about(err, "z", "z = %g: must be above 0 and at most 2",
                              given);
    }
    *z = Z_PAPER;
    if (isnan(contact->viscosity) || isnan(contact->alpha))
        return OVR_OK;
    *z = contact->alpha * p0 / (log(contact->viscosity) + 9.67);
    if (*z > 0 && *z <= 2)
        return OVR_OK;
    return ovr_fail_about(
        err, "alpha",
        "z = %g by Roelands' relation from alpha and viscosity: "
        "no oil has that; check them, or give z",
        *z);
}

ovr_status ovr_lubricant_make(const ovr_contact *contact,
                              ovr_viscosity_law viscosity_law,
                              ovr_density_law density_law, double p0, double z,
                              ovr_lubricant *lubricant, ovr_error *err)
{
    bool plain_film = !(contact->L > 0);
    bool piezo = viscosity_law != OVR_ISOVISCOUS;
    bool needs_ph = viscosity_law == OVR_ROELANDS ||
                    density_law == OVR_DOWSON_HIGGINSON;
    ovr_lubricant made = {OVR_ISOVISCOUS, OVR_INCOMPRESSIBLE, 0, 1, 1, 1};

    p0 = isnan(p0) ? P0_PAPER : p0;
    if (!(p0 > 0 && isfinite(p0)))
        return ovr_fail_about(err, "p0",
                              "p0 = %g Pa: must be positive and finite", p0);
    if (plain_film && piezo && isnan(contact->alpha))
        return ovr_fail_about(err, "alpha",
                              "alpha is missing (pressure-viscosity index; not "
                              "needed with viscosity_law = isoviscous)");
    if (!plain_film && needs_ph && !(contact->ph > 0))
        return ovr_fail_about(err, "alpha",
                              "alpha is missing: the lubricant's laws need the "
                              "Hertzian pressure, alphabar/alpha");
    if (!plain_film) {
        made.viscosity_law = viscosity_law;
        made.density_law = density_law;
        made.alphabar = contact->alphabar;
    }
    if (made.viscosity_law == OVR_ROELANDS) {
        if (index_z(contact, p0, z, &made.z, err))
            return OVR_BAD_INPUT;
        made.P0 = p0 / contact->ph;
    }
    if (made.density_law == OVR_DOWSON_HIGGINSON)
        made.A = DENSITY_A / contact->ph;
    *lubricant = made;
    return OVR_OK;
}

double ovr_viscosity(const ovr_lubricant *lubricant, double P)
{
    ovr_viscosity_law law = lubricant->viscosity_law;
    fluid_laws c;
    fluid_laws_make(lubricant, &c);
    double divisor = viscosity_divisor(&c, law, P), slope;
    double power = viscosity_begin(&c, law, P, divisor, 1 / divisor, &slope);
    return exp2(-viscosity_finish(&c, law, power, &slope));
}

double ovr_density(const ovr_lubricant *lubricant, double P)
{
    dowson_higginson law;
    double slope;
    dowson_higginson_make(lubricant, &law);
    return dowson_higginson_finish(&law, 1 / dowson_higginson_divisor(&law, P),
                                   &slope);
}
