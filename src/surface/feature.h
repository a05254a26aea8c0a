/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One feature, ready to be evaluated: a shape about a centre that moves.
 * Lengths in b, heights in b^2/R.
 */
#ifndef OVR_SURFACE_FEATURE_H
#define OVR_SURFACE_FEATURE_H

#include <math.h>

#include "base/arena.h"
#include "overroll/surface.h"
#include "surface/areal_table.h"
#include "surface/spline.h"

/* Extent across rolling, on a strip (footprint.h). */
typedef struct ovr_footprint {
    bool round;          /* the formula of the distance from the centre */
    double across;       /* Y of the centre */
    double ratio;        /* width across relative to that along x */
    double length;       /* INFINITY: endless */
    double fade;         /* at the ends of its length */
    double sine, cosine; /* of the angle of its length from the y axis */
    double wavelength;   /* across; NAN: none */
    double stagger;      /* share of the wavelength across */
    double reach;        /* the formula vanishes beyond */
} ovr_footprint;

typedef struct ovr_feature {
    const char *name, *assumed;
    int surface;
    ovr_shape shape;
    double ratio; /* u_k/um */
    bool back;    /* its surface begins towards -x */
    double start; /* X of its centre at T = 0 */
    double A;     /* signed: negative into the surface */
    double width, wavelength, wavelength_end, length;
    double shoulder, shoulder_at, shoulder_width;
    double flank;
    bool ball;            /* an indent by its rim: shape.c */
    double behind, ahead; /* extent about the centre, as users see it */
    double reach_behind, reach_ahead; /* beyond them its height vanishes */
    double finest;                    /* shortest wavelength that matters */
    double grow, grow_from;
    double repeat; /* NAN: single */
    long copies;   /* 0: endless */
    ovr_footprint footprint;
    const ovr_table *table;       /* profile, roughness: heights from behind */
    const ovr_areal_table *areal; /* the same of a strip's areal surfaces */
    double local_Rq; /* of those before the grid's filter, as a contact
                        sees it (local_roughness.h); else 0 */
} ovr_feature;

/* sigma(v) = 6 v^5 - 15 v^4 + 10 v^3 between 0 and 1: twice continuously
 * differentiable everywhere. */
static inline double ovr_smoothstep(double v)
{
    if (!(v > 0))
        return 0;
    return v < 1 ? v * v * v * (10 + v * (6 * v - 15)) : 1;
}

/* Checks the form's sizes and fills everything of the feature that is about
 * its shape; `per_radius` is b/R, NAN without a physical contact. */
ovr_status ovr_shape_make(ovr_feature *feature, const ovr_feature_form *form,
                          double per_radius, ovr_error *err);

/* True if a shape may have a size, by its name. */
bool ovr_shape_has(int shape, const char *size);

/* The size that another is about, and does nothing without; NULL: of none. */
const char *ovr_size_of_what(const char *size);

/* Full width where half its depth or height is left; NAN without a width. */
double ovr_shape_diameter(const ovr_feature *feature);

/* True if it is without end to both sides: it is placed by an origin. */
static inline bool ovr_is_endless(const ovr_feature *feature)
{
    return isinf(feature->reach_ahead);
}

/* Returns the height at the distance s from the centre. */
double ovr_shape_height(const ovr_feature *feature, double s);

/* S[i] += factor * (height at X[i] with the centre at `centre`). */
void ovr_shape_add(const ovr_feature *feature, double factor, double centre,
                   size_t n, const double *X, double *S);

#endif
