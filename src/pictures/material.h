/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A file holds arrays of the material below a surface, by depth and by place
 * along the surface, in the groups of [fatigue] and [plastic].
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
    double *z, *xi; /* b, from the surface down; places */
} ovr_material_group;

/* Finds the group of a surface that has `array` by depth and place; false: the
 * file has none. */
bool ovr_material_find(ovr_material_group *m, const char *group, int surface,
                       const char *array);

/* Reads its axes. */
ovr_status ovr_material_axes(ovr_material_group *m, ovr_error *err);

/* `rows` of n values; NULL with *err filled. */
double *ovr_material_read(const ovr_material_group *m, const char *name,
                          size_t rows, size_t n, ovr_error *err);

/* The value of a field at a place and depth. */
typedef double ovr_material_at(const ovr_material_group *m, const double *field,
                               double xi, double z);

/* A panel of a field over places and the logarithm of depth: from x_from to
 * x_to, which the panel has, in image.ny rows of cells. */
ovr_status ovr_material_map(const ovr_material_group *m, const double *field,
                            ovr_material_at *at, ovr_panel *panel,
                            ovr_error *err);

/* The axis of places. */
extern const char ovr_material_place[];

#endif
