/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Pressure flow factor: the flow through a mean gap h between rough surfaces
 * relative to that between smooth surfaces, for the same pressure gradient;
 * sigma is the combined Rq:
 *
 *     isotropic      phi = 1 - 0.90 exp(-0.56 h/sigma)    h > 0.5 sigma
 *     transverse     phi = 1 - 1.48 exp(-0.42 h/sigma)    h > sigma
 *     longitudinal   phi = 1 + 0.87 (h/sigma)^-1.5        h > 0.5 sigma
 *
 * for ridges 9 times as long as they are wide (Peklenik's gamma 1/9, 9), fitted
 * by the authors to solutions for random surfaces. Below these limits phi is
 * constant. The shear flow factor of two surfaces with equal roughness is zero.
 *
 * Source: Patir & Cheng, J. Lubr. Technol. 100 (1978) 12; 101 (1979) 220.
 * Another program's fits to the same tables, R. Boman's (rboman/progs,
 * apps/EHD/EHD/ehd_flow_factors.c), give 0.897 and 0.560, 1.481 and 0.421,
 * 0.861 and 1.5 at gamma 1, 1/9 and 9. In these fits h is the distance of the
 * mean planes. Here h is the mean gap, which differs if many asperities are
 * flattened.
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

/* phi and its derivative with respect to h. */
double ovr_flow_factor_at(const ovr_flow_factor *factor, double h,
                          double *slope);

/* Approximate ratio of the film thickness to that of smooth surfaces with
 * lambda ratio `lambda`. The film thickness is determined in the inlet, where
 * the gap is about twice as large, and is proportional to viscosity^0.7; hence
 * H = lambda sigma phi(2 H)^-0.7, with an error of 3 % for lambda ratios from
 * 0.7 to 3. */
double ovr_flow_factor_film(const ovr_flow_factor *factor, double lambda);

#endif
