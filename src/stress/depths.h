/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Depths, and the mesh that each needs.
 *
 * The fields at depth z carry every wave with exp(-k z): on nodes 2^c D apart
 * they are whole to 1e-6 where z >= 4 2^c D.
 */
#ifndef OVR_STRESS_DEPTHS_H
#define OVR_STRESS_DEPTHS_H

#include "overroll/stress.h"
#include "stress/stress.h"

enum { OVR_STRESS_LEVELS = 6 };

/* Geometric from options->depth_min, and what layers ask for; writes z and
 * returns how many (z NULL: only that). */
size_t ovr_depths(const ovr_stress_options *options, double *z);

/* c of a depth. */
int ovr_depth_level(const ovr_stress_options *options, double z);

/* Nodes of the fields on the mesh, those that a shift may need included; and
 * the space of the transforms: a power of two that holds them, the pressure and
 * a seam. */
size_t ovr_stress_nodes(const ovr_stress_options *options);
size_t ovr_stress_capacity(const ovr_stress_options *options);

/* Everything in range? */
ovr_status ovr_stress_check(const ovr_stress_options *options, ovr_error *err);

#endif
