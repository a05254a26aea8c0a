/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laws of a lubricant (contact/laws) at one pressure. */
#include <math.h>

#include "contact/laws/fluid.h"
#include "overroll/oil.h"

double ovr_viscosity(const ovr_lubricant *lubricant, double P)
{
    ovr_viscosity_law law = lubricant->viscosity_law;
    fluid_laws c = {0};
    fluid_laws_make(lubricant, &c);
    double divisor = viscosity_divisor(&c, law, P), slope;
    double power = viscosity_begin(&c, law, P, divisor, 1 / divisor, &slope);
    return exp2(-viscosity_finish(&c, law, power, &slope));
}

double ovr_density(const ovr_lubricant *lubricant, double P)
{
    fluid_laws c = {0};
    double slope;
    fluid_laws_make(lubricant, &c);
    return density_at(&c, lubricant->density_law, P, &slope);
}

ovr_status ovr_lubricant_make(const ovr_contact *contact,
                              ovr_viscosity_law viscosity_law,
                              ovr_density_law density_law, double p0, double z,
                              ovr_lubricant *lubricant, ovr_error *err)
{
    ovr_oil oil = ovr_oil_default();
    oil.viscosity_law = viscosity_law;
    oil.density_law = density_law;
    oil.p0 = p0;
    oil.z = z;
    return ovr_oil_scale(&oil, contact, lubricant, err);
}
