/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Amplitudes of small waves in the film of a sliding surface, relative to those
 * of a rolling one (sliding_waves.c). */
#ifndef OVR_RUN_SLIDING_WAVES_H
#define OVR_RUN_SLIDING_WAVES_H

#include "base/arena.h"
#include "overroll/contact.h"
#include "surface/local_roughness.h"

typedef struct ovr_sliding_waves {
    ovr_wave_factors factors; /* on the amplitudes of a rolling surface */
    double smooth_Rq;         /* of the film of smooth surfaces, b^2/R */
} ovr_sliding_waves;

/* Computes them for a surface that moves at u um; H is the central film
 * thickness of smooth surfaces. */
ovr_status ovr_sliding_waves_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  double u, ovr_arena *arena,
                                  ovr_sliding_waves *to, ovr_error *err);

#endif
