/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the table that a grid evaluates from a conditioned profile. */
#ifndef OVR_SURFACE_RESAMPLE_H
#define OVR_SURFACE_RESAMPLE_H

#include "overroll/profile.h"
#include "surface/spline.h"

/* The ways to treat the ends and what is beyond them. */
typedef struct ovr_ends {
    double taper; /* blended over this at each end; NAN: 5 % of the length */
    ovr_extension extend;
    bool both;   /* endless ahead of the leading end too */
    bool closed; /* its last point is its first: periodic without blending */
} ovr_ends;

/* Fills the table from the points of a profile, without what a grid of mesh D
 * cannot carry (wavelengths below 2 D). */
ovr_status ovr_resample(const ovr_points *profile, double mesh,
                        const ovr_ends *ends, ovr_table *table,
                        ovr_arena *arena, ovr_error *err);

/* sinc(2 fc u) B(u/reach), |u| < reach: a low-pass filter of the cut-off
 * frequency fc.  B is the window of resample.c. */
double ovr_windowed_sinc(double u, double fc, double reach);

#endif
