/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading of grids of heights. A reader of an areal format calls
 * ovr_areal_reserve, fills profile->map.z (z[j nx + i], NAN: missing), and
 * returns ovr_areal_finish, which selects the requested line.
 */
#ifndef OVR_SURFACE_AREAL_H
#define OVR_SURFACE_AREAL_H

#include "surface/profile.h"

/* Allocates profile->map with nx ny heights.  Fails if dx or dy is not positive
 * or if there are more than OVR_POINTS_MAX heights. */
ovr_status ovr_areal_reserve(ovr_profile *profile, size_t nx, size_t ny,
                             double dx, double dy, ovr_error *err);

/* Determines the spacings along and across and the unit of heights. They are
 * taken from the caller's options if the file does not contain them, which adds
 * a note. *scale becomes the unit in metres (1 for b^2/R). */
ovr_status ovr_areal_need_spacing(ovr_profile *profile,
                                  const ovr_profile_source *source, double *dx,
                                  double *dy, double *scale, ovr_error *err);

/* Multiplies the heights by `scale` and extracts the profile of the selected
 * line. Before that, numbers that denote missing values (-9999, 1e30 ...) are
 * removed. A grid with one row is that profile. */
ovr_status ovr_areal_finish(ovr_profile *profile,
                            const ovr_profile_source *source, double scale,
                            ovr_error *err);

/* Fits a plane to the heights by least squares: z0 + zx i + zy j with i and j
 * from 0. */
void ovr_areal_plane(const ovr_areal *areal, double to[3]);

/* Returns the multiplications of ovr_areal_measure, about. */
double ovr_areal_measure_work(const ovr_areal *areal);

/* Generates random areal roughness, periodic with the given length and width,
 * in b. The lay is at `angle` (radians) from the y axis. The last row and
 * column equal the first. */
ovr_areal *ovr_areal_random(const ovr_roughness *form, double width,
                            double angle, const ovr_allocator *allocator,
                            ovr_error *err);

#endif
