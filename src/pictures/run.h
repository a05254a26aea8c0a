/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A result as pictures need it: everything in Hertzian units, in memory as
 * far as it is drawn. */
#ifndef OVR_PICTURES_RUN_H
#define OVR_PICTURES_RUN_H

#include "base/arena.h"
#include "overroll/results.h"

typedef struct ovr_stored {
    ovr_result *result;
    const ovr_result_info *info;
    const char *name;  /* foreign */
    double *x, *times; /* nodes, snapshots */
    bool film, pressure, roughness;
} ovr_stored;

ovr_status ovr_stored_make(ovr_stored *run, ovr_result *result,
                           const char *name, ovr_arena *arena, ovr_error *err);

/* One snapshot; a field that the file lacks is NULL, as is roughness that is
 * zero everywhere. */
typedef struct ovr_shot {
    const ovr_stored *run;
    size_t k;
    double T;
    double *P, *H, *S;
} ovr_shot;

ovr_status ovr_shot_make(ovr_shot *shot, const ovr_stored *run,
                         ovr_arena *arena, ovr_error *err);
ovr_status ovr_shot_read(ovr_shot *shot, size_t k, ovr_error *err);

/* The snapshot nearest to a time. */
size_t ovr_stored_nearest(const ovr_stored *run, double T);

/* One column of the history, NULL with *err filled when there is none. */
double *ovr_stored_history(const ovr_stored *run, const char *name,
                           ovr_arena *arena, ovr_error *err);

/* What the axes must show. */
typedef struct ovr_extent {
    double x_from, x_to;
    double P_high;        /* largest pressure */
    double H_high;        /* largest film within |X| < 0.9 */
    double S_low, S_high; /* of the roughness between x_from and x_to */
} ovr_extent;

/* Nothing yet; x_from or x_to NAN: -2 and 1.5, as far as the runs go. */
ovr_extent ovr_extent_make(double x_from, double x_to, const ovr_stored *runs,
                           size_t count);
void ovr_extent_add(ovr_extent *extent, const ovr_shot *shot);

/* Nodes a..b-1 that lie within the extent, one more at each end. */
void ovr_extent_nodes(const ovr_extent *extent, const ovr_stored *run,
                      size_t *a, size_t *b);

#endif
