/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes the table that a grid evaluates from a conditioned profile. */
#ifndef OVR_SURFACE_RESAMPLE_H
#define OVR_SURFACE_RESAMPLE_H

#include "overroll/profile.h"
#include "surface/profile_table.h"

/* The ways to treat the ends and what is beyond them. */
typedef struct ovr_ends {
    double taper; /* blended over this at each end; NAN: 5 % of the length */
    ovr_extension extend;
    bool both;   /* endless ahead of the leading end too */
    bool closed; /* its last point is its first: periodic without blending */
} ovr_ends;

/* Fills the table from n points, without what a grid of mesh D cannot carry
 * (wavelengths below 2 D); `lost` is that part of the variance. */
ovr_status ovr_resample(size_t n, const double *x, const double *z, double mesh,
                        const ovr_ends *ends, ovr_table *table,
                        ovr_arena *arena, double *lost, ovr_error *err);

#endif
