/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reads arrays of the material below a surface, as functions of depth and
 * position along the surface, from the groups of [fatigue] and [plastic] of a
 * result file.
 */
#ifndef OVR_PICTURES_MATERIAL_H
#define OVR_PICTURES_MATERIAL_H

#include "pictures/chart.h"
#include "pictures/stored.h"

typedef struct ovr_material_group {
    const ovr_stored *run;
    ovr_arena *arena;
    char group[40]; /* "plastic/surface_1" */
    size_t depths, points;
    double *z, *xi; /* in b: depths, and positions along the surface */
} ovr_material_group;

/* Finds the group of a surface that contains `array` as a function of depth and
 * position; false if there is none. */
bool ovr_material_find(ovr_material_group *m, const char *group, int surface,
                       const char *array);

/* Reads its axes. */
ovr_status ovr_material_axes(ovr_material_group *m, ovr_error *err);

/* Reads `rows` of n values; NULL with *err filled on failure. */
double *ovr_material_read(const ovr_material_group *m, const char *name,
                          size_t rows, size_t n, ovr_error *err);

/* Returns the value of a field at a position and depth. */
typedef double ovr_material_at(const ovr_material_group *m, const double *field,
                               double xi, double z);

/* Makes a panel of a field against position (x_from to x_to of the panel) and
 * the logarithm of depth, in image.ny rows of cells. */
ovr_status ovr_material_map(const ovr_material_group *m, const double *field,
                            ovr_material_at *at, ovr_panel *panel,
                            ovr_error *err);

/* Label of the axis of positions. */
extern const char ovr_material_place[];

#endif
