/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL's cubic splines without aborting. GSL's default error handler ends the
 * program, so all its error conditions are checked before it is called.
 */
#ifndef OVR_SURFACE_SPLINE_H
#define OVR_SURFACE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/*
 * Heights tabulated at equal distances h, evaluated by the cubic spline
 * through them (natural, or periodic when endless):
 *
 *     z(s) = (1-t) z_i + t z_{i+1} + [(1-t)^3 - (1-t)] c_i + [t^3 - t] c_{i+1}
 *     t = s/h - i,  c = z'' h^2/6
 *
 * GSL finds z''; the evaluation is here so that it needs no search, no
 * allocation and no error handler.
 */

typedef struct ovr_table {
    size_t n;     /* entries; if endless, the last equals the first */
    double h;     /* distance between entries */
    double *z;    /* heights */
    double *c;    /* z'' h^2/6 at the entries */
    bool endless; /* endless beyond its trailing end */
    bool both;    /* endless also ahead of the leading end */
    double fade;  /* endless beyond its trailing end only: distance over which
                     the heights grow from zero */
    double lost;  /* fraction of the profile's variance that is not in the
                   * table */
    double work;  /* multiplications to make it, about */
} ovr_table;

/* Computes c from n, h, z and endless. */
ovr_status ovr_table_prepare(ovr_table *table, ovr_arena *arena,
                             ovr_error *err);

/* Returns the distance from the first entry to the last. */
double ovr_table_length(const ovr_table *table);

/* Returns the height at distance s from the first entry. */
double ovr_table_height(const ovr_table *table, double s);

/* Points along x, owned by the caller. */
typedef struct ovr_points {
    size_t n;
    const double *x, *y;
} ovr_points;

/* Evaluates the natural spline at at[k]; constant outside its ends. */
ovr_status ovr_spline_resample(const ovr_points *of, size_t m, const double *at,
                               const ovr_allocator *allocator, double *out,
                               ovr_error *err);

#endif
