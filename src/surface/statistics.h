/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Height, slope and wavelength parameters of a profile. */
#ifndef OVR_SURFACE_STATISTICS_H
#define OVR_SURFACE_STATISTICS_H

#include <stddef.h>

/*
 * Material ratio curve: fraction of the length at or above a height. Its core
 * and the peaks and valleys outside the core (ISO 21920-2, formerly ISO
 * 13565-2):
 *
 *     central part: the 40 % of the ratio over which the secant is flattest
 *     k: depth of the core, the height at 0 minus the height at 100 % of the
 *        regression line of the central part
 *     mr1, 1 - mr2: material ratio of the peaks above and of the valleys below
 *        the core
 *     pk, vk: heights of right-angled triangles with these ratios as base and
 *        the areas of the peaks and of the valleys
 */

/* A height and the length of the profile at this height. */
typedef struct ovr_height {
    double z, length;
} ovr_height;

typedef struct ovr_core {
    double k, pk, vk, mr1, mr2;
} ovr_core;

/* Sorts n >= 1 heights in descending order and evaluates the curve. */
ovr_core ovr_material_ratio(size_t n, ovr_height *heights);

#endif
