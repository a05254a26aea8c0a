/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Viscosity by Roelands 1966, for a number type `num` (base/scalar.h):
 *
 *     eta = exp(alphabar P0/z [t^z - 1]),  t = 1 + P/P0
 *     log2(1/eta) = S - S t^z,  S = alphabar P0/(z ln 2)
 *     (d eta/dP)/eta = alphabar t^z/t
 *
 * Powers have the base 2. The factors z and S are included in the tables.
 * Logarithm and power are two stages, so that more nodes can be processed in
 * parallel. The error of z log2 t, some 2^-51 for z <= 1, grows by the
 * stiffness ln eta + alphabar P0/z, up to 80 in contacts.
 */
#ifndef OVR_CONTACT_LAWS_ROELANDS_H
#define OVR_CONTACT_LAWS_ROELANDS_H

#include "overroll/contact.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct roelands {
    double inv_P0, stiffness, slope; /* 1/P0, S, alphabar/S */
    log_table log;                   /* z log2 t */
    exp_table growth;                /* S t^z */
} roelands;

static inline void roelands_make(const ovr_lubricant *oil, roelands *law)
{
    const double ln2 = 0x1.62e42fefa39efp-1, inv_ln2 = 0x1.71547652b82fep0;
    law->inv_P0 = 1 / oil->P0;
    law->stiffness = inv_ln2 * oil->alphabar * oil->P0 / oil->z;
    law->slope = ln2 * oil->z / oil->P0;
    make_log_table(oil->z, &law->log);
    make_exp_table(law->stiffness, &law->growth);
}

/* t, the divisor of the slope. */
static inline num roelands_divisor(const roelands *law, num P)
{
    return fused(P, all(law->inv_P0), all(1));
}

/* First stage: z log2 t. */
static inline num roelands_begin(const roelands *law, num t)
{
    return scaled_log2(&law->log, t);
}

/* Second stage: log2(1/eta), and the slope of ln eta. On entry *slope contains
 * 1/t. */
static inline num roelands_finish(const roelands *law, num power, num *slope)
{
    num growth = scaled_exp2(&law->growth, power);
    *slope = law->slope * growth * *slope;
    return law->stiffness - growth;
}

#endif
