/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A lubricant layer convected with a surface: thickness as a function of x. As
 * for profiles, the largest x enters first. Linear between points, constant
 * outside.
 */
#ifndef OVR_SURFACE_LAYER_H
#define OVR_SURFACE_LAYER_H

#include "overroll/contact.h"
#include "overroll/profile.h"

typedef struct ovr_layer ovr_layer;

/* Reads a layer from a file. Fails with OVR_BAD_INPUT if the file is no
 * profile, a thickness is missing or negative, or a unit needs a physical
 * contact. */
ovr_layer *ovr_layer_read(const char *file, const ovr_contact *contact,
                          const ovr_allocator *allocator, ovr_error *err);
void ovr_layer_free(ovr_layer *layer);

/* Creates a layer of n points with increasing x in b and thickness in b^2/R;
 * the point at `first` enters first. The arrays are copied. */
ovr_layer *ovr_layer_make(size_t n, const double *x, const double *thickness,
                          double first, const ovr_allocator *allocator,
                          ovr_error *err);

/* Returns the thickness in b^2/R at the distance `travelled`, in b. */
double ovr_layer_thickness(const ovr_layer *layer, double travelled);

/* Returns the mean thickness over `length`, in b, that entered before
 * `travelled`. */
double ovr_layer_mean(const ovr_layer *layer, double travelled, double length);

#endif
