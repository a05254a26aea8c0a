/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Lubricant laws, one value at a time; the fast whole-grid evaluation is in
 * src/multigrid.  Sources: Roelands 1966 (viscosity, and z from alpha and
 * eta0), Barus 1893, Dowson & Higginson 1966 (density).
 */
#include "overroll/contact.h"

#include <math.h>

static const double P0_PAPER = 1.98e8; /* Pa */
static const double Z_PAPER = 0.68;
static const double DENSITY_A = 5.9e8; /* Pa */
static const double DENSITY_LIMIT = 1.34;

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
    double P0 = lubricant->P0, z = lubricant->z;
    switch (lubricant->viscosity_law) {
    case OVR_ROELANDS:
        return exp(lubricant->alphabar * P0 / z * expm1(z * log1p(P / P0)));
    case OVR_BARUS: return exp(lubricant->alphabar * P);
    case OVR_ISOVISCOUS: break;
    }
    return 1;
}

double ovr_density(const ovr_lubricant *lubricant, double P)
{
    double A = lubricant->A;
    if (lubricant->density_law == OVR_DOWSON_HIGGINSON)
        return (A + DENSITY_LIMIT * P) / (A + P);
    return 1;
}
