/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the table that a grid evaluates from a conditioned profile. */
#ifndef OVR_SURFACE_RESAMPLE_H
#define OVR_SURFACE_RESAMPLE_H

#include "overroll/profile.h"
#include "surface/spline.h"

/* How the ends of a profile and its continuation are treated. */
typedef struct ovr_ends {
    double taper; /* length blended at each end; NAN: 5 % of the length */
    ovr_extension extend;
    bool both;   /* endless also ahead of the leading end */
    bool closed; /* the last point equals the first: periodic without
                  * blending */
} ovr_ends;

/* Fills the table from the points of a profile. Wavelengths below 2 D, which
 * the grid cannot represent, are removed. */
ovr_status ovr_resample(const ovr_points *profile, double mesh,
                        const ovr_ends *ends, ovr_table *table,
                        ovr_arena *arena, ovr_error *err);

/* Returns sinc(2 fc u) B(u/reach) for |u| < reach: a low-pass filter with
 * cut-off frequency fc and the window B of resample.c. */
double ovr_windowed_sinc(double u, double fc, double reach);

/* Time of ovr_windowed_sinc relative to that of a multiplication. */
#define OVR_SINC_WORK 30.0

#endif
