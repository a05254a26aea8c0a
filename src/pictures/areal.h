/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chart of a strip at one instant: maps of pressure and film thickness in
 * the plane of the contact, below them cuts along x and across.
 */
#ifndef OVR_PICTURES_AREAL_H
#define OVR_PICTURES_AREAL_H

#include "pictures/chart.h"
#include "pictures/picture.h"

enum { OVR_AREAL_FIELDS = 2, OVR_AREAL_ROWS = 3 };

/* One field of the chart. */
typedef struct ovr_areal_field {
    const char *name;
    ovr_unit_kind kind;
    double low, high; /* range of colours and cuts, Hertzian units */
    bool above;       /* some values are above `high` */
    double *values;   /* values in a snapshot, line by line */
    double *image;    /* on a uniform grid of cells, as drawn */
    double *across;   /* along the cut across, with one more element to close
                       * the period */
} ovr_areal_field;

typedef struct ovr_areal_view {
    const ovr_stored *run;
    const ovr_picture_options *options;
    double x_from, x_to, along; /* `along`: X of the cut across */
    double line;                /* Y of the cut along x */
    size_t shown;
    double *y; /* lines, with the first repeated at the end */
    double x_ends[2], y_ends[2], along_ends[2], line_ends[2];
    ovr_areal_field field[OVR_AREAL_FIELDS];
    ovr_panel panel[OVR_AREAL_FIELDS * OVR_AREAL_ROWS];
    ovr_series series[OVR_AREAL_FIELDS][OVR_AREAL_ROWS][2];
    char note[4][120], label[40], heading[240];
} ovr_areal_view;

/* Prepares the view of a strip's run. */
ovr_status ovr_areal_view_make(ovr_areal_view *view, const ovr_stored *run,
                               const ovr_picture_options *options,
                               ovr_arena *arena, ovr_error *err);

/* Extends the ranges of colours and cuts by snapshot k. */
ovr_status ovr_areal_view_include(ovr_areal_view *view, size_t k,
                                  ovr_error *err);

/* Makes the chart of snapshot k, whose data belong to the view. */
ovr_status ovr_areal_view_draw(ovr_areal_view *view, size_t k, ovr_chart *chart,
                               ovr_error *err);

#endif
