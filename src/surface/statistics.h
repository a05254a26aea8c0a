/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Height, slope and wavelength parameters of a profile. */
#ifndef OVR_SURFACE_STATISTICS_H
#define OVR_SURFACE_STATISTICS_H

#include <stddef.h>

/*
 * The material ratio curve of heights: the share of the length at or above a
 * height.  Its core, and what stands out of it (ISO 21920-2, before that ISO
 * 13565-2):
 *
 *     the secant over 40 % of the ratio that is flattest; the line of least
 *     squares in height over that part, from its height at 0 to that at 100 %:
 *     k, the depth of the core
 *     pk, vk: height of the right-angled triangle over the ratio mr1 that the
 *     peaks above the core have (1 - mr2 the valleys below), of equal area
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
