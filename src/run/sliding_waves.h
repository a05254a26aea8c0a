/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Amplitudes of small waves in the film of a sliding surface, relative to those
 * of a rolling one (sliding_waves.c). */
#ifndef OVR_RUN_SLIDING_WAVES_H
#define OVR_RUN_SLIDING_WAVES_H

#include "base/arena.h"
#include "overroll/contact.h"
#include "surface/local_roughness.h"

/* Computes them for a surface that moves at u um; H is the central film
 * thickness of smooth surfaces. */
ovr_status ovr_sliding_waves_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  double u, ovr_arena *arena,
                                  ovr_wave_factors *to, ovr_error *err);

/* Length of a wave in the film divided by that of the surface, which moves at u
 * um. */
double ovr_film_wave_stretch(double u);

typedef struct ovr_smooth_film {
    double ratio; /* film thickness divided by that of a Newtonian oil */
    double Rq;    /* b^2/R */
} ovr_smooth_film;

/* Computes the film thickness of smooth surfaces; H as above. */
ovr_status ovr_smooth_film_make(const ovr_contact *contact,
                                const ovr_lubricant *lubricant, double H,
                                ovr_arena *arena, ovr_smooth_film *to,
                                ovr_error *err);

/* Heights of a surface at rest at X + i step, and the same with every wave a
 * quarter of its length later (ovr_waves_turn); they reach beyond the film. */
typedef struct ovr_still {
    double X, step;
    const double *z, *turned;
} ovr_still;

typedef struct ovr_standing_film {
    double Rq;     /* roughness due to the heights */
    double lowest; /* largest decrease of H at the outlet, negative */
} ovr_standing_film;

/* Computes the film thickness of a surface at rest while the other one moves.
 */
ovr_status ovr_standing_film_make(const ovr_contact *contact,
                                  const ovr_lubricant *lubricant, double H,
                                  const ovr_still *surface, ovr_arena *arena,
                                  ovr_standing_film *to, ovr_error *err);

#endif
