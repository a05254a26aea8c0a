/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Viscosity by the free volume of Doolittle 1951 with the volume v of Tait's
 * equation (Cook, King, Herbst & Herschbach, J. Chem. Phys. 100, 1994; Bair,
 * Tribology Letters 22, 2006), for a number type `num` (base/scalar.h):
 *
 *     ln eta = B R0 (1/(v - R0) - 1/(1 - R0))
 *     (d eta/dP)/eta = B R0/(v - R0)^2 (-dv/dP)
 *     alphabar = B R0/((1 - R0)^2 K)
 *
 * where R0 is the fraction of the volume at ambient pressure occupied by
 * molecules. v - R0 is bounded below such that ln eta <= 650.
 */
#ifndef OVR_CONTACT_LAWS_DOOLITTLE_H
#define OVR_CONTACT_LAWS_DOOLITTLE_H

#include "contact/laws/tait.h"

typedef struct doolittle {
    tait volume;
    double R0, slope, stiffness, start; /* B R0; and over ln 2; /(1 - R0) */
    double minimum;                     /* of v - R0 */
} doolittle;

static inline void doolittle_make(const ovr_lubricant *oil, doolittle *law)
{
    const double inv_ln2 = 0x1.71547652b82fep0, maximum = 650;
    double BR0 = oil->doolittle_B * oil->doolittle_R0;
    tait_make(oil, &law->volume);
    law->R0 = oil->doolittle_R0;
    law->slope = BR0;
    law->stiffness = inv_ln2 * BR0;
    law->start = law->stiffness / (1 - law->R0);
    law->minimum = 1 / (maximum / BR0 + 1 / (1 - law->R0));
}

/* log2(1/eta), and the slope of ln eta. */
static inline num doolittle_fluidity(const doolittle *law, num P, num *slope)
{
    num loss, v = tait_volume(&law->volume, P, &loss);
    num inverse = 1 / larger(v - law->R0, all(law->minimum));
    *slope = law->slope * inverse * inverse * loss;
    return law->start - law->stiffness * inverse;
}

#endif
