/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinds of quantities: names, units, scales. */
#include <math.h>
#include <string.h>

#include "base/given.h"
#include "overroll/contact.h"

#define ROW(name, si, hertzian, suffix)                                        \
    {                                                                          \
        name, si, hertzian, suffix                                             \
    }
static const ovr_kind_info kinds[OVR_KINDS + 1] = {
    [OVR_KIND_NUMBER] = ROW("number", "1", "1", ""),
    [OVR_KIND_COUNT] = ROW("count", "1", "1", ""),
    [OVR_KIND_FLAG] = ROW("flag", "1", "1", ""),
    [OVR_KIND_LENGTH] = ROW("length", "m", "b", "_m"),
    [OVR_KIND_HEIGHT] = ROW("height", "m", "b^2/R", "_m"),
    [OVR_KIND_PRESSURE] = ROW("pressure", "Pa", "ph", "_Pa"),
    [OVR_KIND_TIME] = ROW("time", "s", "b/um", "_s"),
    [OVR_KIND_VISCOSITY] = ROW("viscosity", "Pa s", "eta0", "_Pa_s"),
    [OVR_KIND_FLOW] = ROW("flow", "m2 s-1", "um b^2/R", "_m2_per_s"),
    [OVR_KIND_SHEAR] = ROW("shear stress", "Pa", "ph b/R", "_Pa"),
    [OVR_KIND_FORCE] = ROW("friction force", "N m-1", "ph b^2/R", "_N_per_m"),
    [OVR_KIND_POWER] = ROW("friction power", "W m-1", "um ph b^2/R",
                           "_W_per_m"),
    [OVR_KIND_TEMPERATURE] = ROW("temperature", "K", "K", ""),
    [OVR_KIND_HEAT] = ROW("heat flux", "W m-2", "um ph b/R", "_W_per_m2"),
    [OVR_KIND_AREA] = ROW("area", "m2", "b^3/R", "_m2"),
    [OVR_KINDS] = ROW("", "1", "1", "")};

const ovr_kind_info *ovr_kind_about(ovr_unit_kind kind)
{
    return &kinds[kind];
}

ovr_unit_kind ovr_kind_named(const char *name)
{
    if (!name)
        return OVR_KINDS;
    ovr_unit_kind kind = OVR_KIND_NUMBER;
    while (kind < OVR_KINDS && strcmp(kinds[kind].name, name) != 0)
        kind++;
    return kind;
}

double ovr_kind_scale(ovr_unit_kind kind, const ovr_contact *contact)
{
    const ovr_contact *c = contact;
    if (!c)
        return NAN;
    switch (kind) {
    case OVR_KIND_LENGTH: return c->b;
    case OVR_KIND_HEIGHT: return c->height;
    case OVR_KIND_PRESSURE: return c->ph;
    case OVR_KIND_TIME: return c->time;
    case OVR_KIND_VISCOSITY: return c->viscosity;
    case OVR_KIND_FLOW: return c->um * c->height;
    case OVR_KIND_SHEAR: return c->ph * c->kappa;
    case OVR_KIND_FORCE: return c->ph * c->kappa * c->b;
    case OVR_KIND_POWER: return c->ph * c->kappa * c->b * c->um;
    case OVR_KIND_HEAT: return c->ph * c->kappa * c->um;
    case OVR_KIND_AREA: return c->b * c->height;
    default: return 1;
    }
}
