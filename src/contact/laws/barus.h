/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Viscosity by Barus 1893, for a number type `num` (base/scalar.h); isoviscous
 * if alphabar = 0:
 *
 *     eta = exp(alphabar P),  log2(1/eta) = -alphabar P/ln 2
 *     (d eta/dP)/eta = alphabar
 */
#ifndef OVR_CONTACT_LAWS_BARUS_H
#define OVR_CONTACT_LAWS_BARUS_H

#include "overroll/contact.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct barus {
    double stiffness, slope; /* alphabar/ln 2, alphabar */
} barus;

static inline void barus_make(const ovr_lubricant *oil, barus *law)
{
    const double inv_ln2 = 0x1.71547652b82fep0;
    bool piezo = oil->viscosity_law == OVR_BARUS;
    law->slope = piezo ? oil->alphabar : 0;
    law->stiffness = piezo ? inv_ln2 * oil->alphabar : 0;
}

/* log2(1/eta), and the slope of ln eta. */
static inline num barus_begin(const barus *law, num P, num *slope)
{
    *slope = all(law->slope);
    return -law->stiffness * P;
}

#endif
