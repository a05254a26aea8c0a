/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Density by Dowson & Higginson 1966, for a number type `num` (base/scalar.h);
 * incompressible if d = 0:
 *
 *     rho = (A + 1.34 P)/(A + P) = 1 + d - d A/a,  a = A + P,  d = 0.34
 *     d rho/dP = d A/a^2
 */
#ifndef OVR_CONTACT_LAWS_DOWSON_HIGGINSON_H
#define OVR_CONTACT_LAWS_DOWSON_HIGGINSON_H

#include "overroll/contact.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct dowson_higginson {
    double A, range; /* range: d */
} dowson_higginson;

static inline void dowson_higginson_make(const ovr_lubricant *oil,
                                         dowson_higginson *law)
{
    bool compressible = oil->density_law == OVR_DOWSON_HIGGINSON;
    law->A = compressible ? oil->A : 1;
    law->range = compressible ? 0.34 : 0;
}

/* The divisor a of density and slope. */
static inline num dowson_higginson_divisor(const dowson_higginson *law, num P)
{
    return law->A + P;
}

/* rho and its slope, from 1/a. */
static inline num dowson_higginson_finish(const dowson_higginson *law,
                                          num inv_a, num *slope)
{
    num drop = law->range * law->A * inv_a;
    *slope = drop * inv_a;
    return (1 + law->range) - drop;
}

#endif
