/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A rough surface as it is in the film of a rolling contact (amplitude.c). */
#ifndef OVR_SURFACE_AMPLITUDE_H
#define OVR_SURFACE_AMPLITUDE_H

#include <stddef.h>

/* The heights z[n] (n a power of two), a period of them `step` b apart, become
 * what is left of them under the contact. */
void ovr_waves_reduce(double M, double L, double step, size_t n, double *z);

#endif
