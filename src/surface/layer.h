/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A layer of oil that a surface convects, thickness against x, as a profile
 * has it: its largest x arrives first.  Between points linear, beyond its ends
 * as thick as there.
 */
#ifndef OVR_SURFACE_LAYER_H
#define OVR_SURFACE_LAYER_H

#include "overroll/contact.h"
#include "overroll/profile.h"

typedef struct ovr_layer ovr_layer;

/* OVR_BAD_INPUT: no profile, heights missing or below zero, a unit without a
 * physical contact. */
ovr_layer *ovr_layer_read(const char *file, const ovr_contact *contact,
                          const ovr_allocator *allocator, ovr_error *err);
void ovr_layer_free(ovr_layer *layer);

/* Makes a layer of n points, x from small to large in b, thickness in b^2/R;
 * what lies at `first` arrives first.  Copied. */
ovr_layer *ovr_layer_make(size_t n, const double *x, const double *thickness,
                          double first, const ovr_allocator *allocator,
                          ovr_error *err);

/* b^2/R, where so much of it, in b, has gone by. */
double ovr_layer_thickness(const ovr_layer *layer, double travelled);

/* Its mean over `length`, in b, that went by before `travelled`. */
double ovr_layer_mean(const ovr_layer *layer, double travelled, double length);

#endif
