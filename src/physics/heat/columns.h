/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The film last read, as columns across the film (multigrid/cross_film.h): its
 * flow, with viscosities at the temperatures `used`.
 *
 * Downstream of film rupture the lubricant fills a part of the gap: its content
 * is the flow from the last pressurized node upstream or, with mass-conserving
 * cavitation, the computed content.
 */
#ifndef OVR_PHYSICS_HEAT_COLUMNS_H
#define OVR_PHYSICS_HEAT_COLUMNS_H

#include "multigrid/cross_film.h"
#include "simulation/internal.h"

/* Allocates the arrays of the flow. */
ovr_status ovr_heat_film_take(ovr_simulation *sim, ovr_error *err);

/* Computes velocities, heat source, stress and gamma. */
void ovr_heat_film(ovr_simulation *sim);

/* True if node i is included in the heat balance: it is pressurized, or there
 * is frictional heating in asperity contact. */
bool ovr_heat_counts(const ovr_simulation *sim, size_t i);

/* Powers of friction and of compression heating, and the sum of their absolute
 * values at the nodes, in um ph b^2/R. */
typedef struct ovr_heat_power {
    double sheared, pressed, size;
} ovr_heat_power;
ovr_heat_power ovr_heat_made(const ovr_simulation *sim);

/* Power stored in the film since `departure`, during dT, or in a steady film
 * from node to node. */
double ovr_heat_stored(const ovr_simulation *sim);

#endif
