/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Stresses below the surface, and what they do to the material that rolls
 * through them.
 *
 * Elastic half plane, plane strain.  Lengths in b, stresses in p_h; z > 0 is
 * depth into the body, tension is positive, pressure P >= 0 is compressive, Q
 * is the traction on the body along +X.  Of the three stresses in the plane
 *
 *     h = -(sigma_x + sigma_z)/2,  d = (sigma_x - sigma_z)/2,  tau = tau_xz
 *
 * are kept: sigma_x = d - h, sigma_z = -d - h, sigma_y = -2 nu h.
 *
 * A snapshot's fields at all depths:
 *     ovr_stress *stress = ovr_stress_create(&options, NULL, &err);
 *     ovr_stress_solve(stress, P, NULL, 0, OVR_STRESS_ALL_LEVELS);
 *     ovr_stress_row row = ovr_stress_at(stress, k);
 *
 * The history of the material of one surface, over a whole run:
 *     ovr_material_history *material history =
 * ovr_material_history_create(&options, &range, NULL, &err);
 *     ovr_material_history_begin(material history, P, NULL, &moment); steady
 * start ovr_material_history_step(material history, P, NULL, &moment); each
 * step ovr_material_history_end(material history, P, NULL, &moment); last state
 *     ovr_material_history_amplitude(material history, OVR_CRITERION_CIRCLE, 0,
 * A); ovr_life(...)
 */
#ifndef OVERROLL_STRESS_H
#define OVERROLL_STRESS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"
#include "overroll/memory.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------- fields of a snapshot */

/* The shape of the pressure between two nodes. */
typedef enum ovr_element {
    OVR_ELEMENT_AUTO,  /* points from 4 D downward, splines above */
    OVR_ELEMENT_POINT, /* line loads: exact from 4 D downward */
    OVR_ELEMENT_HAT,   /* linear between nodes, order 2 */
    OVR_ELEMENT_SPLINE /* cardinal cubic splines, order 4 */
} ovr_element;

typedef struct ovr_stress ovr_stress;

/* Fields of P and Q (nodes values each; Q NULL: none), their nodes moved by
 * `shift` mesh sizes, 0 <= shift <= 64.  `levels`: bit c is the depths whose
 * nodes are 2^c D apart; the others keep what they hold. */
#define OVR_STRESS_ALL_LEVELS (~0U)

/* One depth: value i is at X = start + i step; d at shear[2 i], tau at
 * shear[2 i + 1], h at mean[2 i].  Valid until the next solve. */
typedef struct ovr_stress_row {
    double z;
    int level;          /* step = 2^level D */
    double start, step; /* of X, the shift included */
    size_t count;
    const float *shear, *mean;
} ovr_stress_row;

/* Stresses made of h, d and tau, residual ones added. */
typedef enum ovr_stress_field {
    OVR_STRESS_SIGMA_X,
    OVR_STRESS_SIGMA_Z,
    OVR_STRESS_TAU_XZ,
    OVR_STRESS_SIGMA_Y,
    OVR_STRESS_VON_MISES,
    OVR_STRESS_MAX_SHEAR, /* in the plane */
    OVR_STRESS_TRESCA,    /* largest shear on any plane */
    OVR_STRESS_HYDROSTATIC,
    OVR_STRESS_FIELDS
} ovr_stress_field;

typedef struct ovr_in_plane {
    double h, d, tau;
} ovr_in_plane;

/* ------------------------------------------------------ exact references */

/* -------------------------------------------------------------- material
 * histories */

/* One moment of a run. */
typedef struct ovr_moment {
    double T;
    double U;       /* way of the surface since T = 0, b */
    double dU;      /* largest way of either surface or of the film against
                       the others since the moment before */
    int direction;  /* of the surface's motion: 1 or -1 */
    bool disturbed; /* a feature is within |X| < 2 (begin, end) */
} ovr_moment;

typedef struct ovr_material_history ovr_material_history;

/* Pieces of memory that make up the state between two steps. */
typedef struct ovr_memory_piece {
    const char *name;
    void *memory;
    size_t bytes;
} ovr_memory_piece;

/* Material points, the finest grid: xi_k = start + k step. */
typedef struct ovr_material {
    size_t points, depths;
    double start, step;
    const double *z;
    const unsigned char *complete; /* no closure of the run mattered */
} ovr_material;

/* The largest value of a field, and where and when. */
typedef struct ovr_stress_extreme {
    double value, X, Z, T;
} ovr_stress_extreme;

/* The history of a material point at a depth. */
typedef enum ovr_measure {
    OVR_MEASURE_CIRCLE,     /* radius of the smallest circle round the path */
    OVR_MEASURE_ORTHOGONAL, /* half range of tau_xz */
    OVR_MEASURE_CRITICAL,   /* the same on the worst plane */
    OVR_MEASURE_ANGLE,      /* of that plane to the surface, degrees */
    OVR_MEASURE_VON_MISES,  /* largest */
    OVR_MEASURE_TRESCA,     /* largest shear on any plane */
    OVR_MEASURE_HYDRO_MAX,  /* hydrostatic stress, largest */
    OVR_MEASURE_HYDRO_MIN,  /* and smallest */
    OVR_MEASURES
} ovr_measure;

/* ------------------------------------------------------------------ life */

typedef enum ovr_criterion {
    OVR_CRITERION_CIRCLE, /* circle + alpha max(hydrostatic, 0) */
    OVR_CRITERION_ORTHOGONAL,
    OVR_CRITERION_CRITICAL_PLANE,
    OVR_CRITERION_DANG_VAN, /* largest distance from the circle's centre +
                               alpha hydrostatic: single line */
    OVR_CRITERION_VON_MISES,
    OVR_CRITERION_TRESCA
} ovr_criterion;

typedef struct ovr_life_options {
    double limit;          /* A_u: amplitudes below it do no harm, p_h */
    double exponent;       /* c; 31/3 */
    double depth_exponent; /* h; 7/3 */
    double weibull;        /* e; 9/8 */
    double least_depth;    /* of risk and utilisation */
    /* A_u against the depth, of hardened bodies, instead of the limit: depths
     * that rise, linear between them, the ends' values beyond. */
    size_t limits;         /* 0: there are none */
    const double *limit_z; /* [limits] */
    const double *limit_A; /* [limits], above 0 */
} ovr_life_options;

typedef struct ovr_life_result {
    double smooth_risk;       /* i_0 from least_depth down */
    double equivalent_length; /* from least_depth down; NAN where i_0 = 0 */
    double least_depth;       /* the row it was counted from */
    double worst_amplitude;   /* largest A from there down */
    double worst_xi, worst_z;
    double utilisation; /* largest A / A_u from there; NAN without a limit */
    size_t counted;     /* complete points */
    double used_xi, used_z, used_limit; /* where that is, and A_u there */
} ovr_life_result;

/* ------------------------------------------------------- circle of a path */

typedef struct ovr_circle {
    double d, tau, radius;
} ovr_circle;

/* ------------------------------------------------------- report on a body */

/* Stresses below a surface, as a run or a stored one leaves them: lengths in
 * b, stresses in p_h, maps value[depth * points + point]. */
typedef struct ovr_stress_report {
    int surface;
    const char *feature; /* xi counts from its centre at T = 0, or NULL */
    ovr_material material;
    size_t incomplete; /* points whose material history an end of the run cut */
    double least_depth; /* what follows is counted from here down */
    ovr_stress_extreme max_shear, von_mises;   /* in space and time */
    double R_max, xi_R_max, Z_R_max, R_smooth; /* radius of the circle */
    /* Depth above which stresses follow the height of a pressure spike that the
     * mesh does not resolve; 0: the mesh resolves the maximum pressure. */
    double unresolved_depth;
    float *measure[OVR_MEASURES];
    double *smooth[OVR_MEASURES];
    bool fatigue; /* what follows is there */
    float *amplitude;
    double *amplitude_smooth;
    double *risk;   /* of each point */
    double *length; /* equivalent length counted from each depth down */
    const ovr_life_result *life;
    double hertz;  /* the criterion in a smooth dry contact of p_h = 1 */
    double limit;  /* p_h */
    double ratio;  /* of lives; NAN without a raceway */
    int direction; /* of the surface's motion, 1 or -1; 0: both ways */
    bool traction; /* with the film's shear stress on the surface */
    const char *no_traction; /* why without */
    const char *none;        /* why all of its numbers are NAN; or NULL */
    const char *lifeless;    /* why life and risk are NAN; or NULL */
    double length_error; /* of equivalent lengths: how far the risk of points
                            at the ends of the material is from the smooth
                            contact's, over its whole length */
    /* Layers, NAN where there are none: von Mises stress in any of them,
     * shear and tension on an interface, tension along the surface, at the
     * shallowest depth. */
    ovr_stress_extreme layer_von_mises, interface_shear, interface_tension,
        surface_tension;
    /* Largest von Mises stress of a layer over its own yield; NAN: no layer
     * has one. */
    double layer_utilisation;
    /* Largest amplitude in a layer over that of its own limit_pressure; NAN:
     * no layer has one. */
    double layer_fatigue;
    /* A body with the yield stress `yield`, in p_h; NAN: not evaluated.  Value
     * f/Y of `yield_ratio`: the largest von Mises stress over Y, less 1; of
     * `strip`: the largest (P - P around)/(2.97 Y), Z its width.  Share of the
     * complete material points from least_depth down that go beyond Y; the
     * deepest of all that do, 0: none.  p_h over that of the smooth contact's
     * first yield, and over the limit of its shakedown. */
    double yield;
    ovr_stress_extreme yield_ratio, strip;
    double yielding_share, yielding_depth;
    double of_first_yield, of_shakedown;
    /* Largest shear stress of an interface over its strength; NAN: none has
     * one. */
    double interface_utilisation;
} ovr_stress_report;

#ifdef __cplusplus
}
#endif

#endif
