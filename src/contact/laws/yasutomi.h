/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Viscosity by the distance from the glass transition: Yasutomi, Bair & Winer
 * 1984 in the improved form of Bair, Mary, Bouscharain & Vergne 2013 (Proc.
 * IMechE J 227), for a number type `num` (base/scalar.h):
 *
 *     eta(p)/eta_g = 10^(-C1 u/(C2 + u)),  u = (T - Tg) F
 *     Tg = Tg0 + A1 ln(1 + A2 p),  F = (1 + b1 p)^b2
 *     ln(eta/eta0) = ln 10 C1 C2 (1/(C2 + u) - 1/(C2 + u0)),  u0 = T - Tg0
 *     (d eta/dp)/eta = -ln 10 C1 C2/(C2 + u)^2 du/dp
 *     du/dp = -A1 A2/(1 + A2 p) F + b1 b2/(1 + b1 p) u
 *
 * C2 + u is bounded below such that ln eta <= 650.
 */
#ifndef OVR_CONTACT_LAWS_YASUTOMI_H
#define OVR_CONTACT_LAWS_YASUTOMI_H

#include "overroll/contact.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct yasutomi {
    double A2, b1, b2, C2;
    double above, rise;        /* T - Tg0; A1 A2 */
    double slope, stiffness;   /* ln 10 C1 C2; the same over ln 2 */
    double start, minimum;     /* stiffness/(C2 + u0); of C2 + u */
    log_table glass, fraction; /* A1 ln x; b2 log2 x */
    exp_table power;
} yasutomi;

static inline void yasutomi_make(const ovr_lubricant *oil, yasutomi *law)
{
    const double ln2 = 0x1.62e42fefa39efp-1, inv_ln2 = 0x1.71547652b82fep0;
    const double ln10 = 0x1.26bb1bbb55516p+1, maximum = 650;
    const ovr_yasutomi *y = &oil->yasutomi;
    *law = (yasutomi){.A2 = y->A2,
                      .b1 = y->b1,
                      .b2 = y->b2,
                      .C2 = y->C2,
                      .above = y->T - y->Tg0,
                      .rise = y->A1 * y->A2};
    law->slope = ln10 * y->C1 * y->C2;
    law->stiffness = inv_ln2 * law->slope;
    law->start = law->stiffness / (y->C2 + law->above);
    law->minimum = law->slope / (maximum + law->slope / (y->C2 + law->above));
    make_log_table(ln2 * y->A1, &law->glass);
    make_log_table(y->b2, &law->fraction);
    make_exp_table(1, &law->power);
}

/* log2(1/eta), and the slope of ln eta. */
static inline num yasutomi_fluidity(const yasutomi *law, num P, num *slope)
{
    num a = fused(P, all(law->A2), all(1)), b = fused(P, all(law->b1), all(1));
    num F = scaled_exp2(&law->power, scaled_log2(&law->fraction, b));
    num u = (law->above - scaled_log2(&law->glass, a)) * F;
    num du = law->rise / a * F - law->b1 * law->b2 / b * u;
    num inverse = 1 / larger(law->C2 + u, all(law->minimum));
    *slope = law->slope * inverse * inverse * du;
    return law->start - law->stiffness * inverse;
}

#endif
