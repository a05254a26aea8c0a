/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Depths of the stress field, and the mesh size required at each.
 *
 * At depth z a wave of the load is reduced by exp(-k z). Nodes with spacing 2^c
 * D therefore represent the field within 1e-6 if z >= 4 2^c D.
 */
#ifndef OVR_STRESS_DEPTHS_H
#define OVR_STRESS_DEPTHS_H

#include "stress/stress.h"

enum { OVR_STRESS_LEVELS = 6 };

/* Computes the depths: a geometric series from options->depth_min, and
 * additional depths in layers. Writes them to z unless z is NULL; returns their
 * number. */
size_t ovr_depths(const ovr_stress_options *options, double *z);

/* Level c of a depth. */
int ovr_depth_level(const ovr_stress_options *options, double z);

/* Number of nodes of the fields, including those needed for a shift; length of
 * the transforms: a power of two for the fields, the pressure and a transition
 * between them. */
size_t ovr_stress_nodes(const ovr_stress_options *options);
size_t ovr_stress_capacity(const ovr_stress_options *options);

/* Checks that all options are in range. */
ovr_status ovr_stress_check(const ovr_stress_options *options, ovr_error *err);

#endif
