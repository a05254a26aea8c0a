/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL's cubic splines behind a door that cannot abort: GSL's default error
 * handler ends the program, so everything it would complain of is checked
 * before it is called.
 */
#ifndef OVR_SURFACE_SPLINE_H
#define OVR_SURFACE_SPLINE_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Points along x, borrowed. */
typedef struct ovr_points {
    size_t n;
    const double *x, *y;
} ovr_points;

/* y2[i] = second derivative at x[i] of the natural (periodic: y[n-1] = y[0])
 * cubic spline through n >= 2 points; x must increase and all be finite. */
ovr_status ovr_spline_second(const ovr_points *of, bool periodic,
                             const ovr_allocator *allocator, double *y2,
                             ovr_error *err);

/* out[k] = the natural spline at at[k], held to the ends outside. */
ovr_status ovr_spline_resample(const ovr_points *of, size_t m, const double *at,
                               const ovr_allocator *allocator, double *out,
                               ovr_error *err);

#endif
