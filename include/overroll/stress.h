/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The report on stresses below a surface and on the fatigue of the material
 * that passes through them.
 *
 * Elastic half plane, plane strain.  Lengths in b, stresses in p_h; z > 0 is
 * depth into the body, tension is positive.
 */
#ifndef OVERROLL_STRESS_H
#define OVERROLL_STRESS_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------- material and measures */

/* Grid of material points at the shallowest depth: xi_k = start + k step. */
typedef struct ovr_material {
    size_t points, depths;
    double start, step;
    const double *z;
    const unsigned char *
        complete; /* flags: stress history not cut by start or end of the run */
} ovr_material;

/* Maximum of a field, with position and time. */
typedef struct ovr_stress_extreme {
    double value, X, Z, T;
} ovr_stress_extreme;

/* Measures of the stress history of a material point. */
typedef enum ovr_measure {
    OVR_MEASURE_CIRCLE,     /* radius of the minimum circumscribed circle of the
                               path */
    OVR_MEASURE_ORTHOGONAL, /* half range of tau_xz */
    OVR_MEASURE_CRITICAL, /* half range of shear stress on the critical plane */
    OVR_MEASURE_ANGLE, /* angle of the critical plane to the surface, degrees */
    OVR_MEASURE_VON_MISES, /* maximum von Mises stress */
    OVR_MEASURE_TRESCA,    /* maximum shear stress on any plane */
    OVR_MEASURE_HYDRO_MAX, /* maximum hydrostatic stress */
    OVR_MEASURE_HYDRO_MIN, /* minimum hydrostatic stress */
    OVR_MEASURES
} ovr_measure;

typedef struct ovr_life_result {
    double smooth_risk; /* risk per length of the smooth raceway, i_0, from
                           least_depth downward */
    double equivalent_length; /* from least_depth downward; NAN if i_0 = 0 */
    double least_depth;       /* depth of the first row used */
    double worst_amplitude;   /* maximum amplitude from there downward */
    double worst_xi, worst_z;
    double utilisation; /* maximum A/A_u from there downward; NAN without a
                           limit */
    size_t counted;     /* number of complete points */
    double used_xi, used_z,
        used_limit; /* position of the maximum A/A_u, and A_u there */
} ovr_life_result;

/* ------------------------------------------------------- report on a body */

/* Stresses below a surface after a run or from a result file. Lengths are in
 * b, stresses in p_h, maps are value[depth * points + point]. */
typedef struct ovr_stress_report {
    int surface;
    const char *feature; /* feature at whose centre xi = 0 at T = 0, or NULL */
    ovr_material material;
    size_t incomplete;  /* number of points whose stress history is cut by start
                           or end of the run */
    double least_depth; /* minimum depth for the following members */
    ovr_stress_extreme max_shear, von_mises; /* maxima over space and time */
    double R_max, xi_R_max, Z_R_max,
        R_smooth; /* maximum shear path radius, its position, and the value of
                     the smooth contact */
    /* Depth above which stresses depend on a pressure spike that the grid does
     * not resolve; 0: the maximum pressure is resolved. */
    double unresolved_depth;
    float *measure[OVR_MEASURES];
    double *smooth[OVR_MEASURES];
    bool fatigue; /* the following members are set */
    float *amplitude;
    double *amplitude_smooth;
    double *risk;   /* risk of each point */
    double *length; /* equivalent length from each depth downward */
    const ovr_life_result *life;
    double
        hertz; /* value of the criterion in a smooth dry contact with p_h = 1 */
    double limit;  /* fatigue limit, p_h */
    double ratio;  /* life ratio; NAN: unknown */
    int direction; /* direction of motion of the surface, 1 or -1; 0: both
                      directions */
    bool traction; /* the shear stress of the film is included */
    const char *no_traction; /* reason if it is not included */
    const char *none;        /* reason if all numbers are NAN, or NULL */
    const char *lifeless;    /* reason if life and risk are NAN, or NULL */
    double length_error; /* error of equivalent lengths: difference between the
                            risk at the ends of the material and that of the
                            smooth contact, times the length */
    /* Layers, otherwise NAN: maximum von Mises stress in a layer, maximum
     * shear stress and tension at an interface, maximum tension along the
     * surface at the shallowest depth. */
    ovr_stress_extreme layer_von_mises, interface_shear, interface_tension,
        surface_tension;
    /* Maximum von Mises stress of a layer divided by its yield stress; NAN: no
     * yield stress is set. */
    double layer_utilisation;
    /* Maximum amplitude in a layer divided by its fatigue limit; NAN: no
     * limit_pressure is set. */
    double layer_fatigue;
    /* Yield stress Y of the body in p_h (NAN: not evaluated). yield_ratio:
     * maximum von Mises stress / Y - 1. strip: maximum (P - P around)/(2.97
     * Y), with the width as Z. yielding_share: share of complete material
     * points from least_depth downward above Y. yielding_depth: depth of the
     * deepest of these points; 0: none. of_first_yield and of_shakedown: p_h
     * relative to first yield and to the shakedown limit of the smooth
     * contact. */
    double yield;
    ovr_stress_extreme yield_ratio, strip;
    double yielding_share, yielding_depth;
    double of_first_yield, of_shakedown;
    /* Maximum shear stress at an interface divided by its strength; NAN: no
     * strength is set. */
    double interface_utilisation;
} ovr_stress_report;

#ifdef __cplusplus
}
#endif

#endif
