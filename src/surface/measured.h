/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Features whose heights come from a table: measured profiles and synthetic
 * roughness, conditioned and prepared for a grid.
 */
#ifndef OVR_SURFACE_MEASURED_H
#define OVR_SURFACE_MEASURED_H

#include "surface/feature.h"

/* Fills the feature's table, extents and notes from the form's source (shape
 * OVR_PROFILE) or roughness; `mesh` is the grid's D. */
ovr_status ovr_measured_make(ovr_feature *feature, const ovr_feature_form *form,
                             const ovr_contact *contact, double mesh,
                             ovr_arena *arena, ovr_error *err);

/* Returns only its heights, in b and b^2/R. */
ovr_profile *ovr_measured_profile(const ovr_feature_form *form,
                                  const ovr_contact *contact,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);

/* Mesh sizes of a strip along x and across, and its width, b. */
typedef struct ovr_strip_mesh {
    double D, Dy, width;
} ovr_strip_mesh;

/* Fills the feature's areal table, extents and notes from the form's map (shape
 * OVR_AREAL) or areal roughness. Fails if the map is not periodic with the
 * width of the strip. */
ovr_status ovr_measured_areal(ovr_feature *feature,
                              const ovr_feature_form *form,
                              const ovr_contact *contact,
                              const ovr_strip_mesh *mesh, ovr_arena *arena,
                              ovr_error *err);

/* Computes the width in b after which the form's map repeats across; 0 if it
 * does not. */
ovr_status ovr_areal_period(const ovr_feature_form *form,
                            const ovr_contact *contact,
                            const ovr_allocator *allocator, double *width,
                            ovr_error *err);

#endif
