/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Local roughness relevant for a contact: for a profile z the root of the mean
 * of
 *
 *     <z^2> - <z>^2,    < > the mean over a window as wide as the contact,
 *
 * over all windows that lie in the profile. Wavelengths longer than the window
 * shift the surfaces as a whole and do not count as roughness. A wave of
 * amplitude A and wavelength l contributes A^2/2 (1 - s^2), s = sin(pi w/l)/(pi
 * w/l).
 */
#ifndef OVR_SURFACE_LOCAL_ROUGHNESS_H
#define OVR_SURFACE_LOCAL_ROUGHNESS_H

#include <stddef.h>

/* Roughness in the film of a rolling contact (local_roughness.c). */

/* Factors on the amplitudes of waves: value[k] at the wavelength
 * first exp(k step), linear in the logarithm of the wavelength between them,
 * constant beyond the ends. */
enum { OVR_WAVE_FACTORS = 20 };
typedef struct ovr_wave_factors {
    double first, step; /* b */
    double value[OVR_WAVE_FACTORS];
} ovr_wave_factors;

double ovr_wave_factor(const ovr_wave_factors *factors, double wavelength);

/* Multiplies the waves of one period of heights z[n] (n a power of two, `step`
 * b apart) by their amplitude reduction under the contact and, unless NULL, by
 * the factors. */
void ovr_waves_reduce(double M, double L, const ovr_wave_factors *factors,
                      double step, size_t n, double *z);

/* Computes turned[n] from one period of heights z[n]: every cosine becomes a
 * sine (Hilbert transform). */
void ovr_waves_turn(size_t n, const double *z, double *turned);

/* Width of the contact, b. */
#define OVR_CONTACT_WIDTH 2.

/* Returns the local roughness of a profile that is linear between its points, x
 * increasing. A profile shorter than the window is one window. */
double ovr_local_roughness(size_t n, const double *x, const double *z,
                           double window);

/* Returns the local roughness of a wave. */
double ovr_local_roughness_of_wave(double amplitude, double wavelength,
                                   double window);

#endif
