/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/layout.h"

#include <math.h>

#include "overroll/results.h"

const ovr_field ovr_field_table[OVR_FIELD_COUNT] = {
    {"pressure", "pressure", 'P', OVR_FIELD_PRESSURE},
    {"film_thickness", "film thickness", 'H', OVR_FIELD_FILM},
    {"roughness", "height of the features of both surfaces, outward positive",
     'H', OVR_FIELD_ROUGHNESS},
    {"density", "density relative to ambient", '1', OVR_FIELD_DENSITY},
    {"viscosity", "viscosity", 'E', OVR_FIELD_VISCOSITY},
    {"mass_flow", "mass flow per unit width over ambient density", 'Q',
     OVR_FIELD_MASS_FLOW},
    {"cavitated", "1 where the pressure is zero", 'b', OVR_FIELD_CAVITATED},
};

ovr_scales ovr_scales_of(const ovr_contact *contact)
{
    ovr_scales scales;
    scales.contact = *contact;
    scales.physical = isfinite(contact->b) && isfinite(contact->ph) &&
                      isfinite(contact->height) && isfinite(contact->time);
    return scales;
}

double ovr_scale(const ovr_scales *scales, char kind)
{
    const ovr_contact *c = &scales->contact;
    switch (kind) {
    case 'X': return c->b;
    case 'H': return c->height;
    case 'P': return c->ph;
    case 'T': return c->time;
    case 'E': return c->viscosity;
    case 'Q': return c->um * c->height;
    default: return 1;
    }
}

/* Known by itself: viscosity and speed may lack where the rest is known. */
static bool stored_in_si(const ovr_scales *scales, char kind)
{
    return scales->physical && isfinite(ovr_scale(scales, kind));
}

double ovr_factor(const ovr_scales *scales, char kind)
{
    return stored_in_si(scales, kind) ? ovr_scale(scales, kind) : 1;
}

const char *ovr_unit(const ovr_scales *scales, char kind)
{
    if (!stored_in_si(scales, kind))
        return "1";
    switch (kind) {
    case 'X': return "m";
    case 'H': return "m";
    case 'P': return "Pa";
    case 'T': return "s";
    case 'E': return "Pa s";
    case 'Q': return "m2 s-1";
    default: return "1";
    }
}
