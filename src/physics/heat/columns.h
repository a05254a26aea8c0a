/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The film that was read last as columns (multigrid/cross_film.h): what flows
 * in it, with viscosities by the temperatures `used`.
 *
 * Where the film has ruptured, what is left of it fills less than the gap:
 * what the last pressurized node upstream lets through, or, where cavitation is
 * mass-conserving, what there is.
 */
#ifndef OVR_PHYSICS_HEAT_COLUMNS_H
#define OVR_PHYSICS_HEAT_COLUMNS_H

#include "multigrid/cross_film.h"
#include "simulation/internal.h"

/* Places for what flows. */
ovr_status ovr_heat_film_take(ovr_simulation *sim, ovr_error *err);

/* Velocities, heating, stress and gamma. */
void ovr_heat_film(ovr_simulation *sim);

/* th, shift, drag and skewed for the film. */
void ovr_heat_film_fields(ovr_simulation *sim);

/* True if node i counts in the balance of heat: the film is wet, or power is
 * made where the surfaces touch. */
bool ovr_heat_counts(const ovr_simulation *sim, size_t i);

/* Powers made by friction and by heat of compression, and the sum of their
 * absolute values at the nodes; um ph b^2/R. */
typedef struct ovr_heat_power {
    double sheared, pressed, size;
} ovr_heat_power;
ovr_heat_power ovr_heat_made(const ovr_simulation *sim);

/* Power that the film takes up from `departure` in the time dT, or in a steady
 * film from node to node. */
double ovr_heat_stored(const ovr_simulation *sim);

#endif
