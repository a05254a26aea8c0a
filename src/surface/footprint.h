/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Features on a strip: their extent across rolling. */
#ifndef OVR_SURFACE_FOOTPRINT_H
#define OVR_SURFACE_FOOTPRINT_H

#include "surface/feature.h"

/* Sets the footprint of a feature whose shape is made, on a strip of width W.
 * Fails if the feature does not close on the period. */
ovr_status ovr_footprint_make(ovr_feature *feature,
                              const ovr_feature_form *form, double W,
                              ovr_error *err);

/* Adds factor times the height at nodes X and lines Y with the centre at
 * `centre`, all images across included; element (i, j) is S[i stride + j]. */
void ovr_footprint_add(const ovr_feature *feature, double factor, double centre,
                       double W, size_t n, const double *X, size_t lines,
                       const double *Y, size_t stride, double *S);

/* True if the footprint includes all copies of the feature. */
bool ovr_footprint_repeats(const ovr_feature *feature);

#endif
