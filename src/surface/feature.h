/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A feature that can be evaluated: a shape about a moving centre. Lengths in b,
 * heights in b^2/R.
 */
#ifndef OVR_SURFACE_FEATURE_H
#define OVR_SURFACE_FEATURE_H

#include <math.h>

#include "base/arena.h"
#include "overroll/surface.h"
#include "surface/areal_table.h"
#include "surface/spline.h"

/* Extent of a feature across the rolling direction, on a strip
 * (footprint.h). */
typedef struct ovr_footprint {
    bool round;          /* axisymmetric: a function of the distance from the
                          * centre */
    double across;       /* Y of the centre, b */
    double ratio;        /* width across relative to the width along x */
    double length;       /* length; INFINITY: endless */
    double fade;         /* distance over which the height vanishes at the ends
                          * of the length */
    double sine, cosine; /* sine and cosine of the angle between the feature's
                            length and the y axis */
    double wavelength;   /* wavelength across; NAN: none */
    double stagger;      /* fraction of the wavelength across */
    double reach;        /* distance beyond which the height is zero */
} ovr_footprint;

typedef struct ovr_feature {
    const char *name, *assumed;
    int surface;
    ovr_shape shape;
    double ratio; /* u_k/um */
    bool back;    /* the surface moves towards -x */
    double start; /* X of the centre at T = 0 */
    double A;     /* signed amplitude; negative: into the surface */
    double width, wavelength, wavelength_end, length;
    double shoulder, shoulder_at, shoulder_width;
    double flank;
    bool ball;            /* indentation specified by its rim, see shape.c */
    double behind, ahead; /* extent about the centre, as reported */
    double reach_behind, reach_ahead; /* extent outside of which the height is
                                       * zero */
    double finest;                    /* shortest significant wavelength */
    double grow, grow_from;
    double repeat; /* distance between copies; NAN: single */
    long copies;   /* number of copies; 0: endless */
    ovr_footprint footprint;
    const ovr_table *table;       /* profile, roughness: heights from the
                                   * trailing end */
    const ovr_areal_table *areal; /* heights of an areal surface of a strip */
    double local_Rq; /* Rq before the grid's filter as seen by a contact
                      * (local_roughness.h), for profiles and roughness;
                      * otherwise 0 */
    double work;     /* multiplications to make it, about */
} ovr_feature;

/* sigma(v) = 6 v^5 - 15 v^4 + 10 v^3 between 0 and 1: twice continuously
 * differentiable everywhere. */
static inline double ovr_smoothstep(double v)
{
    if (!(v > 0))
        return 0;
    return v < 1 ? v * v * v * (10 + v * (6 * v - 15)) : 1;
}

/* Checks the sizes and computes everything that depends on the shape.
 * `per_radius` is b/R, NAN without a physical contact. */
ovr_status ovr_shape_make(ovr_feature *feature, const ovr_feature_form *form,
                          double per_radius, ovr_error *err);

/* True if a shape can have the size with this name. */
bool ovr_shape_has(int shape, const char *size);

/* Returns the size without which `size` has no effect; NULL if there is
 * none. */
const char *ovr_size_of_what(const char *size);

/* Returns the full width at half depth or height; NAN for shapes without a
 * width. */
double ovr_shape_diameter(const ovr_feature *feature);

/* True if the feature is endless in both directions; its position is then given
 * by an origin. */
static inline bool ovr_is_endless(const ovr_feature *feature)
{
    return isinf(feature->reach_ahead);
}

/* Returns the height at distance s from the centre. */
double ovr_shape_height(const ovr_feature *feature, double s);

/* Adds factor times the heights at X[i] to S[i], with the centre at
 * `centre`. */
void ovr_shape_add(const ovr_feature *feature, double factor, double centre,
                   size_t n, const double *X, double *S);

#endif
