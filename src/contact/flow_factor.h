/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The pressure flow factor is the ratio of the flow that a pressure gradient
 * drives through a mean gap h between rough surfaces, over what it would drive
 * between smooth ones; sigma is the Rq of both:
 *
 *     isotropic      phi = 1 - 0.90 exp(-0.56 h/sigma)    h > 0.5 sigma
 *     transverse     phi = 1 - 1.48 exp(-0.42 h/sigma)    h > sigma
 *     longitudinal   phi = 1 + 0.87 (h/sigma)^-1.5        h > 0.5 sigma
 *
 * of ridges 9 times as long as they are wide (Peklenik's gamma 1/9, 9), their
 * fits to solutions of random surfaces; below, phi is held.  Of two surfaces
 * that are alike the factor of the shear flow is nothing.
 *
 * Source: Patir & Cheng, J. Lubr. Technol. 100 (1978) 12; 101 (1979) 220.
 * Another program's fits to the same tables, R. Boman's (rboman/progs,
 * apps/EHD/EHD/ehd_flow_factors.c), give 0.897 and 0.560, 1.481 and 0.421,
 * 0.861 and 1.5 at gamma 1, 1/9 and 9. Their h is the distance of the mean
 * planes, here it is the mean gap, which is another one where many summits are
 * pressed flat.
 */
#ifndef OVR_CONTACT_FLOW_FACTOR_H
#define OVR_CONTACT_FLOW_FACTOR_H

typedef enum ovr_ridges {
    OVR_RIDGES_NONE,
    OVR_RIDGES_ISOTROPIC,
    OVR_RIDGES_TRANSVERSE,
    OVR_RIDGES_LONGITUDINAL
} ovr_ridges;

typedef struct ovr_flow_factor {
    ovr_ridges ridges;
    double sigma;
} ovr_flow_factor;

/* phi, and its change by h. */
double ovr_flow_factor_at(const ovr_flow_factor *factor, double h,
                          double *slope);

/* Roughly the film over that of smooth surfaces, which has lambda: where the
 * inlet makes the film, its gap is some twice as large, and films go as
 * viscosity^0.7; so that H = lambda sigma phi(2 H)^-0.7, 3 % off from lambda
 * 0.7 to 3. */
double ovr_flow_factor_film(const ovr_flow_factor *factor, double lambda);

#endif
