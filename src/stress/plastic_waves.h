/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses that plastic strains leave behind below a free surface, wave by
 * wave. */
#ifndef OVR_STRESS_PLASTIC_WAVES_H
#define OVR_STRESS_PLASTIC_WAVES_H

/* A layer of constant plastic strain; depths in b. */
typedef struct ovr_strained_layer {
    double top, bottom;
} ovr_strained_layer;

/* Amplitudes of strain over p_h/E*: x and z are cos kx, xz is sin kx. */
typedef struct ovr_plastic_strain {
    double x, z, xz;
} ovr_plastic_strain;

/* Amplitudes of stress in p_h: x, y and z are cos kx, xz is -sin kx. */
typedef struct ovr_residual_stress {
    double x, y, z, xz;
} ovr_residual_stress;

/* The stress at depth z from the strain of one layer; k = 0 is a strain that is
 * the same everywhere along x. */
ovr_residual_stress ovr_residual_at(double k, double poisson,
                                    ovr_strained_layer source,
                                    ovr_plastic_strain strain, double z);

/* Its mean over another layer, or over the same one. */
ovr_residual_stress ovr_residual_mean(double k, double poisson,
                                      ovr_strained_layer source,
                                      ovr_plastic_strain strain,
                                      ovr_strained_layer receiver);

/* The distance by which the surface moves into the body, in b p_h/E*; k > 0. */
double ovr_plastic_sinking(double k, double poisson, ovr_strained_layer source,
                           ovr_plastic_strain strain);

#endif
