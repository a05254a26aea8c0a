/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Areal surfaces: heights on a regular grid, as areal instruments measure them,
 * and their parameters (ISO 25178-2).
 *
 * Row j and column i have the coordinates y = j dy and x = i dx.  Rows and
 * columns are counted from 1 in ovr_profile_source and in messages.
 */
#ifndef OVERROLL_AREAL_H
#define OVERROLL_AREAL_H

#include "overroll/profile.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ovr_areal {
    size_t nx, ny;      /* points of a row; rows */
    double dx, dy;      /* distances of the points, m (scaled_x: b) */
    double *z;          /* nx ny heights, row after row, m (scaled_z: b^2/R),
                           positive out of the surface; NAN: missing */
    bool scaled_x;      /* lengths in b, else in metres */
    bool scaled_z;      /* heights in b^2/R, else in metres */
    size_t missing;     /* number of missing heights */
    const char *format; /* "SDF (binary)", ... */
    const char *notes;  /* assumptions of the reader: lines ending in '\n' */
    void *owner;        /* memory of z, format and notes */
} ovr_areal;

/* Reads source->file, which must hold at least two rows of at least two points.
 * row, column, y, direction and band of the source are not used.  The caller
 * frees the result with ovr_areal_free.  NULL: failed. */
OVR_API ovr_areal *ovr_areal_read(const ovr_profile_source *source,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
/* Frees the grid and all that it points to. */
OVR_API void ovr_areal_free(ovr_areal *areal);

/*
 * Conditions the heights in place (src/surface/areal_condition.c): turn,
 * window, stretch, reverse, scale, invert, missing heights filled, outliers
 * replaced, F-operation (level), L-filter (lambda_c), S-filter (lambda_s),
 * offset.  Levelling by line is that by the least-squares plane.  max_gap,
 * tapers and extensions are not used.
 */
OVR_API ovr_status ovr_areal_condition(ovr_areal *areal,
                                       const ovr_conditioning *how,
                                       ovr_error *err);

/*
 * Parameters of the heights about their least-squares plane; texture aspect
 * ratio and direction of the lay by the autocorrelation of these heights
 * (src/surface/lay.c).
 */
typedef struct ovr_areal_numbers {
    double Sa, Sq;   /* mean and root mean square height */
    double Ssk, Sku; /* skewness and kurtosis; NAN: flat */
    double Str; /* 0 (strong lay) to 1 (isotropic); NAN: unknown, the grid is
                   shorter than 8 points or flat */
    bool Str_is_bound; /* the autocorrelation along the lay does not decay
                          within half the shorter side: Str is an upper bound */
    double lay; /* angle of the lay to the x axis, degrees, -90 to 90; NAN: no
                   distinct lay (Str > 0.5 or unknown) */
} ovr_areal_numbers;

OVR_API ovr_status ovr_areal_measure(const ovr_areal *areal,
                                     ovr_areal_numbers *numbers,
                                     ovr_error *err);

#ifdef __cplusplus
}
#endif

#endif
