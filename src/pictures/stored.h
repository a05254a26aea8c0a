/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A result as pictures need it: in memory as far as it is drawn, everything
 * in Hertzian units; of several, whose axes are physical, in those of the
 * first: values of another are multiplied by its own unit over the first's.
 */
#ifndef OVR_PICTURES_STORED_H
#define OVR_PICTURES_STORED_H

#include "base/arena.h"
#include "overroll/case.h"
#include "overroll/results.h"

typedef struct ovr_stored {
    ovr_result *result;
    const ovr_result_info *info;
    const char *name;  /* foreign */
    double *x, *times; /* nodes, snapshots */
    /* of Hertz's contact at the load and radius of each snapshot, over the
     * nominal one's; NULL: it is that */
    double *hertz_width, *hertz_P;
    bool film, pressure, roughness, filling, touches;
    const char *unresolved; /* remedy; NULL: P_max is resolved */
    bool *resolved; /* P_max by snapshot; NULL if `unresolved` is NULL */
    bool hot[3]; /* temperatures of surface 1, surface 2, middle of the film */
    struct {
        double x, film, pressure, time;
    } by; /* its units in those of the first */
} ovr_stored;

ovr_status ovr_stored_make(ovr_stored *run, ovr_result *result,
                           const char *name, ovr_arena *arena, ovr_error *err);

/* The title that is given or, where it is NULL, that of all the results; none
 * where they differ: a legend tells them apart. */
const char *ovr_stored_title(const ovr_stored *runs, size_t count,
                             const char *given);

/* Hertz's half width and maximum pressure at snapshot k over the nominal. */
double ovr_stored_hertz_width(const ovr_stored *run, size_t k);
double ovr_stored_hertz_pressure(const ovr_stored *run, size_t k);

/* Returns the remedy if the mesh does not resolve a stress at depth z (b) below
 * a pressure spike, NULL otherwise.  `k` is a snapshot, or -1 for the extreme
 * over the run. */
const char *ovr_stored_unresolved(const ovr_stored *run, ptrdiff_t k, double z);

/* Refuses one that was stored without snapshots, or is at its beginning. */
ovr_status ovr_stored_need_snapshots(const ovr_stored *run, ovr_error *err);

/* The units that several results have in common: Hertzian ones where one of
 * them has no scales but another is to be drawn in SI, unless SI is asked for,
 * which is an error then. */
ovr_status ovr_common_units(const ovr_stored *runs, size_t count,
                            ovr_units *units, ovr_error *err);

/* Converts x and times of each run, and all later reads, into the
 * units of the first; Hertzian ones are each its own. */
void ovr_stored_relate(ovr_stored *runs, size_t count, ovr_units units);

/* The run has scales of its own, unlike the first's. */
bool ovr_stored_differs(const ovr_stored *run);

/* The setup of the case that a result holds, to be freed by the two; NULL with
 * *err filled. */
ovr_setup *ovr_stored_setup(const ovr_stored *run, ovr_case **c,
                            ovr_error *err);

/* One snapshot; a field that the file lacks is NULL, as is roughness that is
 * zero everywhere. */
typedef struct ovr_shot {
    const ovr_stored *run;
    size_t k;
    double T;
    double *P, *H, *S;
    /* of runs that conserve oil, half of which lies on each wall: up to `oil`,
     * and from `hung` up to H; `wall` is 0 */
    double *oil, *hung, *wall;
    double *hot[3]; /* temperatures as in ovr_stored; degC */
} ovr_shot;

ovr_status ovr_shot_make(ovr_shot *shot, const ovr_stored *run,
                         ovr_arena *arena, ovr_error *err);
ovr_status ovr_shot_read(ovr_shot *shot, size_t k, ovr_error *err);

/* The snapshot nearest to a time. */
size_t ovr_stored_nearest(const ovr_stored *run, double T);

/* One column of the history, multiplied by run->by of its kind; NULL with *err
 * filled when there is none. */
double *ovr_stored_history(const ovr_stored *run, const char *name, double by,
                           ovr_arena *arena, ovr_error *err);

/* The axes must show at least this. */
typedef struct ovr_extent {
    double x_from, x_to;
    double P_high;            /* maximum pressure */
    double H_high;            /* largest film within |X| < 0.9 */
    double S_low, S_high;     /* of the roughness between x_from and x_to */
    double hot_low, hot_high; /* degC */
} ovr_extent;

/* Nothing yet; x_from or x_to NAN: -2 and 1.5, or 2 in a domain that is as long
 * on both sides, as far as the runs go. */
ovr_extent ovr_extent_make(double x_from, double x_to, const ovr_stored *runs,
                           size_t count);
void ovr_extent_add(ovr_extent *extent, const ovr_shot *shot);

/* Nodes a..b-1 that lie within the extent, one more at each end. */
void ovr_extent_nodes(const ovr_extent *extent, const ovr_stored *run,
                      size_t *a, size_t *b);

#endif
