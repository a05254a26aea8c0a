/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips of pressure that exceed the load capacity of a plastic body. */
#ifndef OVR_STRESS_YIELD_H
#define OVR_STRESS_YIELD_H

#include <stdbool.h>
#include <stddef.h>

/* Space for cumulative sums of nodes + 1 pressures, the first 0. */
typedef struct ovr_pressure_sums {
    size_t nodes;
    double *sum;
} ovr_pressure_sums;

/* Excess of the mean pressure of a strip of `width` nodes over its
 * surroundings; its middle, in nodes from the first. */
typedef struct ovr_strip {
    double excess, middle, width;
} ovr_strip;

/* Stores the strip of `minimum` to `maximum` nodes with the largest excess in
 * *worst if it exceeds the one there; returns whether it does. */
bool ovr_strip_find(ovr_pressure_sums *s, const double *P, double minimum,
                    double maximum, ovr_strip *worst);

#endif
