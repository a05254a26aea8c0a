/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The chart of snapshots. Panels from top to bottom: pressure, film thickness
 * with the undeformed roughness, temperatures if there are any. One column for
 * each time, or all times in one column; a movie frame is a chart of one time.
 */
#ifndef OVR_PICTURES_SNAPSHOT_H
#define OVR_PICTURES_SNAPSHOT_H

#include "overroll/pictures.h"
#include "pictures/chart.h"
#include "pictures/stored.h"

enum { OVR_SNAPSHOTS = 8, OVR_HERTZ_POINTS = 121 };

/* Axes and ranges, equal for all pictures of a run. */
typedef struct ovr_snapshot_style {
    const ovr_picture_options *options;
    ovr_axis x, P, H, T;
    ovr_extent extent;
    double P_to, H_to; /* upper ends in Hertzian units */
    double hertz_x[OVR_HERTZ_POINTS], hertz_P[OVR_HERTZ_POINTS];
    const char *title;
    char heading[240];
} ovr_snapshot_style;

/* Computes axes and ranges from all snapshots of the `count` runs. */
ovr_status ovr_snapshot_style_make(ovr_snapshot_style *look,
                                   const ovr_picture_options *options,
                                   const ovr_extent *extent,
                                   const ovr_stored *runs, size_t count,
                                   ovr_error *err);

/* Returns colour and dash of the k-th curve; 21 are different. */
typedef struct ovr_curve_style {
    int colour;
    ovr_mark mark;
} ovr_curve_style;
ovr_curve_style ovr_curve_style_of(size_t k);

/* Writes M, L and p_h, as far as all runs have the same, as enhanced text. */
void ovr_heading(const ovr_stored *runs, size_t count, char *heading,
                 size_t capacity);

/* Memory of a chart of up to OVR_SNAPSHOTS snapshots. */
typedef struct ovr_snapshot_chart {
    ovr_chart chart;
    ovr_panel panel[3 * OVR_SNAPSHOTS + 1]; /* one more for the stresses */
    ovr_series series[3 * OVR_SNAPSHOTS][3 * OVR_SNAPSHOTS + 1];
    char note[OVR_SNAPSHOTS][240], name[OVR_SNAPSHOTS][300];
} ovr_snapshot_chart;

/* Draws `instants` times for each of `runs` runs: snapshot[instant * runs +
 * run]. `about` is a text after each time, or NULL. */
void ovr_snapshot_draw(ovr_snapshot_chart *to, const ovr_snapshot_style *look,
                       const ovr_snapshot *snapshot, size_t instants,
                       size_t runs, const char *const *about);

/* Adds a panel below the last row: the stresses of one snapshot. */
struct ovr_depth_field;
ovr_status ovr_stress_panel_add(struct ovr_depth_field *field,
                                const ovr_snapshot *snapshot,
                                const ovr_snapshot_style *look,
                                ovr_snapshot_chart *to, ovr_arena *arena,
                                ovr_error *err);

#endif
