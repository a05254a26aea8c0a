/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Relative volume and density by the Tait equation in the form of Dymond &
 * Malhotra 1988, for a number type `num` (base/scalar.h):
 *
 *     v = 1/rho = 1 - ln(a)/(1 + K'),  a = 1 + P (1 + K')/K
 *     dv/dP = -1/(K a),  d rho/dP = rho^2/(K a)
 *
 * with K = K0/ph the bulk modulus at ambient pressure and K' its slope there,
 * about 11 in lubricants (Bair, High Pressure Rheology for Quantitative
 * Elastohydrodynamics, 2nd ed., 2019).  v is bounded below by 0.2, which no
 * liquid reaches.
 */
#ifndef OVR_CONTACT_LAWS_TAIT_H
#define OVR_CONTACT_LAWS_TAIT_H

#include "overroll/contact.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct tait {
    double growth, inv_K; /* (1 + K')/K, 1/K */
    log_table shrinking;  /* ln a/(1 + K') */
} tait;

static inline void tait_make(const ovr_lubricant *oil, tait *law)
{
    const double ln2 = 0x1.62e42fefa39efp-1;
    law->growth = (1 + oil->tait_K_slope) / oil->tait_K;
    law->inv_K = 1 / oil->tait_K;
    make_log_table(ln2 / (1 + oil->tait_K_slope), &law->shrinking);
}

/* v, and -dv/dP. */
static inline num tait_volume(const tait *law, num P, num *loss)
{
    num a = fused(P, all(law->growth), all(1));
    *loss = law->inv_K / a;
    return larger(1 - scaled_log2(&law->shrinking, a), all(0.2));
}

/* rho and its slope. */
static inline num tait_density(const tait *law, num P, num *slope)
{
    num loss, rho = 1 / tait_volume(law, P, &loss);
    *slope = loss * rho * rho;
    return rho;
}

#endif
