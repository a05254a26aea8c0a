/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laws of a lubricant (contact/laws) at one pressure. */
#include <math.h>

#include "base/given.h"
#include "contact/contact.h"
#include "contact/laws/fluid.h"

double ovr_viscosity(const ovr_lubricant *lubricant, double P)
{
    const ovr_lubricant *oil = lubricant;
    fluid_laws c = {0};
    if (!oil)
        return NAN;
    ovr_viscosity_law law = oil->viscosity_law;
    fluid_laws_make(oil, &c);
    double divisor = viscosity_divisor(&c, law, P), slope;
    double power = viscosity_begin(&c, law, P, divisor, 1 / divisor, &slope);
    return exp2(-viscosity_finish(&c, law, power, &slope));
}

double ovr_density(const ovr_lubricant *lubricant, double P)
{
    const ovr_lubricant *oil = lubricant;
    fluid_laws c = {0};
    double slope;
    if (!oil)
        return NAN;
    fluid_laws_make(oil, &c);
    return density_at(&c, oil->density_law, P, &slope);
}
