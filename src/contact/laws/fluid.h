/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Common interface of all viscosity and density laws, for a number type `num`
 * (base/scalar.h, or vector.h with power.h):
 *
 *     a divisor of the density and one of the viscosity, both functions of P,
 *     so that one division by their product is sufficient for both;
 *     begin and finish, the two stages of the viscosity: log2(1/eta) and the
 *     slope of ln eta.
 *
 * In fast loops `law` is a compile-time constant, so that code for other laws
 * is omitted.
 */
#ifndef OVR_CONTACT_LAWS_FLUID_H
#define OVR_CONTACT_LAWS_FLUID_H

#include "contact/laws/barus.h"
#include "contact/laws/doolittle.h"
#include "contact/laws/dowson_higginson.h"
#include "contact/laws/roelands.h"
#include "contact/laws/tabulated.h"
#include "contact/laws/tait.h"
#include "contact/laws/yasutomi.h"

typedef struct fluid_laws {
    dowson_higginson density;
    roelands roelands;
    barus barus;
    tait tait;
    doolittle doolittle;
    yasutomi yasutomi;
    tabulated viscosity_table, density_table;
} fluid_laws;

static inline void fluid_laws_make(const ovr_lubricant *oil, fluid_laws *c)
{
    const double inv_ln2 = 0x1.71547652b82fep0;
    dowson_higginson_make(oil, &c->density);
    barus_make(oil, &c->barus);
    roelands_make(oil, &c->roelands);
    if (oil->density_law == OVR_TAIT)
        tait_make(oil, &c->tait);
    if (oil->viscosity_law == OVR_DOOLITTLE)
        doolittle_make(oil, &c->doolittle);
    if (oil->viscosity_law == OVR_YASUTOMI)
        yasutomi_make(oil, &c->yasutomi);
    tabulated_make(oil->viscosity_table, oil->table_ph, -inv_ln2,
                   &c->viscosity_table);
    tabulated_make(oil->density_table, oil->table_ph, 1, &c->density_table);
}

/* Laws evaluated in one stage, whose divisor is 1. */
static inline bool viscosity_is_direct(ovr_viscosity_law law)
{
    return law == OVR_DOOLITTLE || law == OVR_YASUTOMI ||
           law == OVR_VISCOSITY_TABLE;
}

/* log2(1/eta), and the slope of ln eta. */
static inline num viscosity_direct(const fluid_laws *c, ovr_viscosity_law law,
                                   num P, num *slope)
{
    const double ln2 = 0x1.62e42fefa39efp-1;
    num power;
    if (law == OVR_DOOLITTLE)
        return doolittle_fluidity(&c->doolittle, P, slope);
    if (law == OVR_YASUTOMI)
        return yasutomi_fluidity(&c->yasutomi, P, slope);
    power = tabulated_at(&c->viscosity_table, P, slope);
    *slope *= -ln2;
    return power;
}

/* rho and its slope. */
static inline num density_at(const fluid_laws *c, ovr_density_law law, num P,
                             num *slope)
{
    if (law == OVR_TAIT)
        return tait_density(&c->tait, P, slope);
    if (law == OVR_DENSITY_TABLE)
        return tabulated_at(&c->density_table, P, slope);
    return dowson_higginson_finish(
        &c->density, 1 / dowson_higginson_divisor(&c->density, P), slope);
}

static inline num viscosity_divisor(const fluid_laws *c, ovr_viscosity_law law,
                                    num P)
{
    return law == OVR_ROELANDS ? roelands_divisor(&c->roelands, P) : all(1);
}

/* `inverse` is 1/divisor. */
static inline num viscosity_begin(const fluid_laws *c, ovr_viscosity_law law,
                                  num P, num divisor, num inverse, num *slope)
{
    *slope = inverse;
    if (law == OVR_ROELANDS)
        return roelands_begin(&c->roelands, divisor);
    if (viscosity_is_direct(law))
        return viscosity_direct(c, law, P, slope);
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
