/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The parts of conditioning.  All work on n points (x, z), x increasing; z
 * without gaps unless said.
 */
#ifndef OVR_SURFACE_CONDITIONING_H
#define OVR_SURFACE_CONDITIONING_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"
#include "surface/spline.h"

/* Subtracts the least-squares polynomial of the degree (0: mean, 1: line),
 * each point weighted by the length it stands for.  `work` holds 3 n. */
void ovr_level(size_t n, const double *x, double *z, int degree, double *work);

/* Subtracts the line through the mean points of the first and last tenth: a
 * dent or scratch in between does not tilt or lift it. */
void ovr_level_ends(size_t n, const double *x, double *z);

/* Mean line of the Gaussian filter of cut-off lambda (ISO 16610-21), into
 * `mean`; `uniform` x make it quicker.  `work` holds 2 n. */
void ovr_gaussian(const ovr_points *of, double lambda, bool uniform,
                  double *mean, double *work);

/* Marks outliers of a map of ny rows of nx heights.  The median is that of
 * 5 x 5 neighbours, and `work` holds 2 nx ny. */
size_t ovr_mark_map_outliers(size_t nx, size_t ny, double *z, double limit,
                             double *work);

/* Half the distance between a point's neighbours. */
double ovr_share(size_t n, const double *x, size_t i);

#endif
