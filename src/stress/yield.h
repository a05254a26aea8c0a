/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strips of pressure that a body which yields does not bear. */
#ifndef OVR_STRESS_YIELD_H
#define OVR_STRESS_YIELD_H

#include <stdbool.h>
#include <stddef.h>

/* Space for sums of nodes + 1 pressures, the first of them 0. */
typedef struct ovr_pressure_sums {
    size_t nodes;
    double *sum;
} ovr_pressure_sums;

/* The pressure of a strip of `width` nodes above that around it; its middle, in
 * nodes from the first. */
typedef struct ovr_strip {
    double excess, middle, width;
} ovr_strip;

/* Stores the strip of `minimum` to `maximum` nodes with the largest excess in
 * *worst if it exceeds the one there; returns whether it does. */
bool ovr_strip_find(ovr_pressure_sums *s, const double *P, double minimum,
                    double maximum, ovr_strip *worst);

#endif
