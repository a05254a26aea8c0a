/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steps of conditioning. They use n points (x, z) with increasing x and, unless
 * noted, without missing z.
 */
#ifndef OVR_SURFACE_CONDITIONING_H
#define OVR_SURFACE_CONDITIONING_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "surface/spline.h"

/* Subtracts the least-squares polynomial of the given degree (0: mean, 1:
 * line). Each point is weighted by the length it represents. `work` has 3 n
 * elements. */
void ovr_level(size_t n, const double *x, double *z, int degree, double *work);

/* Subtracts the line through the mean points of the first and last tenth. A
 * dent or scratch between them does not affect it. */
void ovr_level_ends(size_t n, const double *x, double *z);

/* Computes the mean line of the Gaussian filter with cut-off lambda (ISO
 * 16610-21). `uniform`: x is uniform, which is faster. `work` has 2 n
 * elements. */
void ovr_gaussian(const ovr_points *of, double lambda, bool uniform,
                  double *mean, double *work);

/* Sets outliers of a map of ny rows of nx heights to NAN. The median is that of
 * 5 x 5 neighbours; `work` has 2 nx ny elements. */
size_t ovr_mark_map_outliers(size_t nx, size_t ny, double *z, double limit,
                             double *work);

/* Returns the length that point i represents: half the distance between its
 * neighbours. */
double ovr_share(size_t n, const double *x, size_t i);

#endif
