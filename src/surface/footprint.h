/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Features on a strip: their extent across the rolling direction. */
#ifndef OVR_SURFACE_FOOTPRINT_H
#define OVR_SURFACE_FOOTPRINT_H

#include "surface/feature.h"

/* Sets the footprint of a feature, whose shape must be set, on a strip of width
 * W. Fails if the feature is not periodic with the width. */
ovr_status ovr_footprint_make(ovr_feature *feature,
                              const ovr_feature_form *form, double W,
                              ovr_error *err);

/* Nodes X and lines Y of a strip; element (i, j) of a field is i stride + j. */
typedef struct ovr_places {
    size_t n, lines, stride;
    const double *X, *Y;
    double width; /* width W, the period */
} ovr_places;

/* Adds factor times the height with the centre at `centre`, including all
 * images across. */
void ovr_footprint_add(const ovr_feature *feature, double factor, double centre,
                       const ovr_places *at, double *S);

/* True if the footprint includes all copies of the feature. */
bool ovr_footprint_repeats(const ovr_feature *feature);

#endif
