/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Data of a result for pictures: the drawn part in memory, in Hertzian units.
 * For several results with physical axes, values are converted to the Hertzian
 * units of the first result.
 */
#ifndef OVR_PICTURES_STORED_H
#define OVR_PICTURES_STORED_H

#include "base/arena.h"
#include "overroll/case.h"
#include "overroll/results.h"

typedef struct ovr_stored {
    ovr_result *result;
    const ovr_result_info *info;
    const char *name;  /* unescaped */
    double *x, *times; /* nodes; times of snapshots */
    /* Half-width and pressure of the Hertzian contact at the load and radius of
     * each snapshot, relative to the reference; NULL: equal to it. */
    double *hertz_width, *hertz_P;
    bool film, pressure, roughness, filling, touches;
    const char *unresolved; /* remedy; NULL: the maximum pressure is resolved */
    size_t flagged; /* number of flagged steps, which did not converge */
    bool *resolved; /* one per snapshot; NULL if `unresolved` is NULL */
    bool hot[3];    /* temperatures of surface 1, surface 2, mid-film */
    struct {
        double x, film, pressure, time;
    } by; /* units of this result divided by those of the first result */
} ovr_stored;

ovr_status ovr_stored_make(ovr_stored *run, ovr_result *result,
                           const char *name, ovr_arena *arena, ovr_error *err);

/* Returns the given title; if it is NULL, that of all results. Empty if they
 * differ, because the legend names them. */
const char *ovr_stored_title(const ovr_stored *runs, size_t count,
                             const char *given);

/* Return half-width and maximum pressure of the Hertzian contact at snapshot k,
 * relative to the reference. */
double ovr_stored_hertz_width(const ovr_stored *run, size_t k);
double ovr_stored_hertz_pressure(const ovr_stored *run, size_t k);

/* Returns the remedy if the mesh does not resolve a stress at depth z (in b)
 * below a pressure spike, otherwise NULL. `k` is a snapshot, or -1 for the
 * extreme over the run. */
const char *ovr_stored_unresolved(const ovr_stored *run, ptrdiff_t k, double z);

/* True for a complete result of a steady film: one snapshot and no time steps.
 */
bool ovr_stored_is_steady(const ovr_stored *run);

/* Fails for a result without snapshots: none were stored, or none yet. */
ovr_status ovr_stored_need_snapshots(const ovr_stored *run, ovr_error *err);

/* Chooses the common units of several results. These are Hertzian if one of
 * them has no scales and the other would be drawn in SI; fails if SI is
 * requested. */
ovr_status ovr_common_units(const ovr_stored *runs, size_t count,
                            ovr_units *units, ovr_error *err);

/* Converts x and times of each run and all later reads to the units of the
 * first. In Hertzian units nothing is converted. */
void ovr_stored_relate(ovr_stored *runs, size_t count, ovr_units units);

/* True if the run has other scales than the first one. */
bool ovr_stored_differs(const ovr_stored *run);

/* Creates the case and setup of a result, which the caller must free; NULL with
 * *err filled on failure. */
ovr_setup *ovr_stored_setup(const ovr_stored *run, ovr_case **c,
                            ovr_error *err);

/* A snapshot. Missing fields are NULL, and so is roughness that is zero
 * everywhere. */
typedef struct ovr_snapshot {
    const ovr_stored *run;
    size_t k;
    double T;
    double *P, *H, *S;
    /* For mass-conserving cavitation half of the lubricant is on each wall: up
     * to `oil`, and from `hung` to H; `wall` is 0. */
    double *oil, *hung, *wall;
    double *hot[3]; /* in degC, as in ovr_stored */
} ovr_snapshot;

ovr_status ovr_snapshot_make(ovr_snapshot *snapshot, const ovr_stored *run,
                             ovr_arena *arena, ovr_error *err);
ovr_status ovr_snapshot_read(ovr_snapshot *snapshot, size_t k, ovr_error *err);

/* Returns the snapshot nearest to a time. */
size_t ovr_stored_nearest(const ovr_stored *run, double T);

/* Reads a column of the history, multiplied by run->by of its kind; NULL with
 * *err filled if there is none. */
double *ovr_stored_history(const ovr_stored *run, const char *name, double by,
                           ovr_arena *arena, ovr_error *err);

/* Minimum range of the axes. */
typedef struct ovr_extent {
    double x_from, x_to;
    double P_high;            /* maximum pressure */
    double H_high;            /* maximum film thickness within |X| < 0.9 */
    double S_low, S_high;     /* roughness between x_from and x_to */
    double hot_low, hot_high; /* in degC */
} ovr_extent;

/* Returns an empty extent. x_from or x_to NAN: -2 and 1.5, or 2 in a symmetric
 * domain, limited to the domains of the runs. */
ovr_extent ovr_extent_make(double x_from, double x_to, const ovr_stored *runs,
                           size_t count);
void ovr_extent_add(ovr_extent *extent, const ovr_snapshot *snapshot);

/* Returns the nodes a..b-1 within the extent, with one more at each end. */
void ovr_extent_nodes(const ovr_extent *extent, const ovr_stored *run,
                      size_t *a, size_t *b);

#endif
