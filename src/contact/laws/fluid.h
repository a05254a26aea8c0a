/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The laws of a lubricant behind one face, over a number type
 * (base/scalar.h, or vector.h with power.h):
 *
 *     a divisor of the density and one of the viscosity, both functions of P,
 *     that one division of 1 by their product serves both;
 *     begin and finish, the two stages of the viscosity: log2(1/eta) and the
 *     slope of ln eta.
 *
 * `law` is a constant where speed counts: what other laws need is not compiled.
 */
#ifndef OVR_CONTACT_LAWS_FLUID_H
#define OVR_CONTACT_LAWS_FLUID_H

#include "contact/laws/barus.h"
#include "contact/laws/dowson_higginson.h"
#include "contact/laws/roelands.h"

typedef struct fluid_laws {
    dowson_higginson density;
    roelands roelands;
    barus barus;
} fluid_laws;

static inline void fluid_laws_make(const ovr_lubricant *oil, fluid_laws *c)
{
    dowson_higginson_make(oil, &c->density);
    barus_make(oil, &c->barus);
    roelands_make(oil, &c->roelands);
}

static inline num viscosity_divisor(const fluid_laws *c, ovr_viscosity_law law,
                                    num P)
{
    return law == OVR_ROELANDS ? roelands_divisor(&c->roelands, P) : all(1);
}

/* Inverse: 1/divisor. */
static inline num viscosity_begin(const fluid_laws *c, ovr_viscosity_law law,
                                  num P, num divisor, num inverse, num *slope)
{
    *slope = inverse;
    if (law == OVR_ROELANDS)
        return roelands_begin(&c->roelands, divisor);
    return barus_begin(&c->barus, P, slope);
}

static inline num viscosity_finish(const fluid_laws *c, ovr_viscosity_law law,
                                   num power, num *slope)
{
    if (law == OVR_ROELANDS)
        return roelands_finish(&c->roelands, power, slope);
    return power;
}

#endif
