/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stresses in a half plane loaded by elements of pressure and traction.
 *
 * With w = x + i z and C_f(w) = 1/(pi i) int f(s)/(s - w) ds of a density f on
 * the surface, C' = dC/dw, the stresses of p and q are
 *
 *     F = C_p - i C_q
 *     (sigma_x + sigma_z)/2 = -Re F
 *     tau_xz + i (sigma_x - sigma_z)/2 = z F' - C_q
 *
 * (Flamant's kernels summed; Muskhelishvili's potentials of the half plane). Re
 * C is the harmonic extension of f into the body, Im C its conjugate.
 */
#ifndef OVR_STRESS_ELEMENT_H
#define OVR_STRESS_ELEMENT_H

#include <complex.h>

#include "stress/stress.h"

/* C and C' of one density. */
typedef struct ovr_potential {
    double complex C, dC;
} ovr_potential;

/* Potentials at x = (first + k) D, k = 0 ... count - 1. */
void ovr_element_line(ovr_element element, double D, double z, long first,
                      size_t count, ovr_potential *out);

/* Stresses due to p times one density and q times another. */
ovr_in_plane ovr_stress_of(double z, ovr_potential p, ovr_potential q);

/* Adds the stresses due to p and q times the same density. */
ovr_in_plane ovr_stress_of_both(double z, ovr_potential one, double p,
                                double q);

#endif
