/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses below a surface, stress histories of the material, and fatigue life.
 */

/*
 * Elastic half plane, plane strain.  Lengths in b, stresses in p_h.  The depth
 * z > 0 is into the body, tension is positive.  The pressure P >= 0 is
 * compressive, and Q is the traction on the body along +X.  The stresses in the
 * plane are stored as
 *
 *     h = -(sigma_x + sigma_z)/2,  d = (sigma_x - sigma_z)/2,  tau = tau_xz.
 *
 * sigma_x = d - h, sigma_z = -d - h, sigma_y = -2 nu h.
 *
 * A snapshot's fields at all depths:
 *     ovr_stress *stress = ovr_stress_create(&options, NULL, &err);
 *     ovr_stress_solve(stress, P, NULL, 0, OVR_STRESS_ALL_LEVELS);
 *     ovr_stress_row row = ovr_stress_at(stress, k);
 *
 * The stress history of the material of one surface over a whole run:
 *     ovr_material_history *m =
 *         ovr_material_history_create(&options, &range, NULL, &err);
 *     ovr_material_history_begin(m, P, NULL, &moment);      steady start
 *     ovr_material_history_step(m, P, NULL, &moment);       each step
 *     ovr_material_history_end(m, P, NULL, &moment);        last state
 *     ovr_material_history_amplitude(m, OVR_CRITERION_CIRCLE, 0, A);
 *     ovr_life(...)
 */
#ifndef OVR_STRESS_STRESS_H
#define OVR_STRESS_STRESS_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/stress.h"

/* ------------------------------------------------- fields of a snapshot */

/* Interpolation of the pressure between two nodes. */
typedef enum ovr_element {
    OVR_ELEMENT_AUTO,  /* points from 4 D downward, splines above */
    OVR_ELEMENT_POINT, /* line loads: exact from 4 D downward */
    OVR_ELEMENT_HAT,   /* linear between nodes, order 2 */
    OVR_ELEMENT_SPLINE /* cardinal cubic splines, order 4 */
} ovr_element;

typedef struct ovr_stress ovr_stress;

/* Bits of all levels of depths; depths of level c have nodes at distances 2^c
 * D. */
#define OVR_STRESS_ALL_LEVELS (~0U)

/* Stresses at one depth. Value i is at X = start + i step: d at shear[2 i],
 * tau at shear[2 i + 1], h at mean[2 i]. Valid until the next solve. */
typedef struct ovr_stress_row {
    double z;
    int level;          /* step = 2^level D */
    double start, step; /* first X, with the shift; distance of values */
    size_t count;
    const float *shear, *mean;
} ovr_stress_row;

/* Stresses computed from h, d and tau, including residual stresses. */
typedef enum ovr_stress_field {
    OVR_STRESS_SIGMA_X,
    OVR_STRESS_SIGMA_Z,
    OVR_STRESS_TAU_XZ,
    OVR_STRESS_SIGMA_Y,
    OVR_STRESS_VON_MISES,
    OVR_STRESS_MAX_SHEAR, /* in the plane */
    OVR_STRESS_TRESCA,    /* maximum shear stress on any plane */
    OVR_STRESS_HYDROSTATIC,
    OVR_STRESS_FIELDS
} ovr_stress_field;

typedef struct ovr_in_plane {
    double h, d, tau;
} ovr_in_plane;

/* ------------------------------------------------------ stress histories */

/* State of the motion at one time of a run. */
typedef struct ovr_moment {
    double T;
    double U;  /* distance travelled by the surface since T = 0, b */
    double dU; /* maximum relative displacement of surfaces and film since the
                  previous time */
    int direction;  /* direction of the surface's motion: 1 or -1 */
    bool disturbed; /* a feature is within |X| < 2 (begin, end) */
} ovr_moment;

typedef struct ovr_material_history ovr_material_history;

/* Memory blocks that form the state between two steps. */
typedef struct ovr_memory_piece {
    const char *name;
    void *memory;
    size_t bytes;
} ovr_memory_piece;

/* ------------------------------------------------------------- fatigue life */

typedef enum ovr_criterion {
    OVR_CRITERION_CIRCLE, /* circle + alpha max(hydrostatic, 0) */
    OVR_CRITERION_ORTHOGONAL,
    OVR_CRITERION_CRITICAL_PLANE,
    OVR_CRITERION_DANG_VAN, /* maximum over time of distance from the centre of
                               the circle + alpha hydrostatic stress */
    OVR_CRITERION_VON_MISES,
    OVR_CRITERION_TRESCA
} ovr_criterion;

typedef struct ovr_life_options {
    double
        limit; /* fatigue limit A_u in p_h; smaller amplitudes have no effect */
    double exponent;       /* c; 31/3 */
    double depth_exponent; /* h; 7/3 */
    double weibull;        /* e; 9/8 */
    double least_depth;    /* minimum depth for risk and utilization */
    /* Fatigue limit A_u against depth, for hardened bodies, instead of
     * `limit`: increasing depths, linear interpolation, constant beyond the
     * ends. */
    size_t limits;         /* 0: no table */
    const double *limit_z; /* [limits] */
    const double *limit_A; /* [limits], above 0 */
} ovr_life_options;

/* ------------------------------------------------------- circle of a path */

typedef struct ovr_circle {
    double d, tau, radius;
} ovr_circle;

/* -------------------------------------------------------------- functions */

struct ovr_layered;
typedef struct ovr_stress_options {
    double mesh;       /* D */
    double inlet;      /* X of the first node */
    size_t nodes;      /* number of values of P and of Q */
    double from, to;   /* range of the requested fields; default -2.6 to 2.6 */
    double depth_min;  /* default (0): 4 D; at most D/2 */
    double depth_max;  /* 2.5 */
    double per_octave; /* number of depths; default 5 */
    ovr_element element;
    bool traction;                    /* Q is given */
    const struct ovr_layered *layers; /* layers on the body, in b; NULL: none */
} ovr_stress_options;

/* Maximum number of mesh sizes of material with a stress history. */
enum { OVR_MATERIAL_POINTS_MAX = 1 << 26 };

typedef struct ovr_material_range {
    double reference;  /* X of xi = 0 at U = 0 */
    double from, to;   /* xi in b, fixed in the material */
    double reach;      /* paths are recorded for |X| <= reach; default 2.5 */
    double poisson;    /* 0.3 */
    double residual_x; /* residual stresses in p_h, tension positive */
    double residual_y;
    size_t residuals; /* number of depths of the following table, which replaces
                       * residual_x and residual_y */
    const double *residual_z, *residual_s; /* increasing depths in b; stresses,
                                            * equal in both directions */
    double least_depth; /* minimum depth for extremes; 0: 8 D */
    /* Residual stresses of the layers of ovr_stress_options, along x and along
     * the line, borrowed; NULL: none. The stresses above are those of the body
     * below the layers. */
    const double *layer_residual; /* two per layer */
    double yield;                 /* von Mises, of the body; 0: unknown */
} ovr_material_range;

/* Creates a field; the closed forms of all depths are transformed once. */
ovr_stress *ovr_stress_create(const ovr_stress_options *options,
                              const ovr_allocator *allocator, ovr_error *err);

/* Creates a field at given depths, in increasing order. */
ovr_stress *ovr_stress_create_at(const ovr_stress_options *options,
                                 size_t depths, const double *z,
                                 const ovr_allocator *allocator,
                                 ovr_error *err);
void ovr_stress_free(ovr_stress *stress);

/* Memory in bytes that ovr_stress_create would allocate; NAN if the options are
 * invalid. */
double ovr_stress_memory(const ovr_stress_options *given);

size_t ovr_stress_depths(const ovr_stress *stress, const double **z);

void ovr_stress_solve(ovr_stress *stress, const double *P, const double *Q,
                      double shift, unsigned levels);

/* Stresses at one depth; valid until the next solve. */
ovr_stress_row ovr_stress_at(const ovr_stress *stress, size_t j);

/* Stresses of the last solve at every node of the mesh; valid until the next
 * call. */
ovr_status ovr_stress_at_every_node(ovr_stress *stress, size_t j,
                                    ovr_stress_row *row, ovr_error *err);

/* Names of the fields: "sigma_x", ... */
const char *ovr_stress_field_name(ovr_stress_field field);
double ovr_stress_value(ovr_stress_field field, ovr_in_plane state,
                        double poisson, double residual_x, double residual_y);

/* Stress at (x, z) below one element of height 1 at x = 0 with mesh size D, for
 * pressure p and traction q. */
ovr_in_plane ovr_element_stress(ovr_element element, double D, double p,
                                double q, double x, double z);

/* Stress below a smooth dry contact, P = p sqrt(1 - X^2), Q = q sqrt(1 - X^2).
 */
ovr_in_plane ovr_hertz_stress(double p, double q, double x, double z);

ovr_material_history *
ovr_material_history_create(const ovr_stress_options *given,
                            const ovr_material_range *range,
                            const ovr_allocator *allocator, ovr_error *err);
void ovr_material_history_free(ovr_material_history *history);
double ovr_material_history_memory(const ovr_stress_options *given,
                                   const ovr_material_range *range);

/* Starts (and ends) a stress history: the contact is steady before the first
 * time and after the last. */
void ovr_material_history_begin(ovr_material_history *history, const double *P,
                                const double *Q, const ovr_moment *moment);
void ovr_material_history_step(ovr_material_history *history, const double *P,
                               const double *Q, const ovr_moment *moment);
void ovr_material_history_end(ovr_material_history *history, const double *P,
                              const double *Q, const ovr_moment *moment);

/* The memory that defines the state between two steps. */
size_t ovr_material_history_state(ovr_material_history *history,
                                  const ovr_memory_piece **pieces);

/* X of xi = 0 at U = 0. */
double ovr_material_history_reference(const ovr_material_history *history);

/* The material points of a stress history. */
ovr_material ovr_material_history_points(const ovr_material_history *history);

/* Maxima over all times at depths of at least least_depth. */
ovr_stress_extreme
ovr_material_history_max_shear(const ovr_material_history *history);
ovr_stress_extreme
ovr_material_history_von_mises(const ovr_material_history *history);

/* Maximum of the mean pressure of a strip (at least least_depth wide) minus the
 * mean pressure of its surroundings (yield.c). `position` is the middle of the
 * strip, Z its width. NAN without a yield stress. */
ovr_stress_extreme
ovr_material_history_strip(const ovr_material_history *history);

/* Maximum distance moved between two times of a path: maxima at depths below 4
 * times this are partly missed. */
double ovr_material_history_widest(const ovr_material_history *history);

/* Computes value[depth * points + k], and smooth[depth] for the steady contact
 * before the run; either may be NULL. */
void ovr_material_history_measure(const ovr_material_history *history,
                                  ovr_measure which, float *to, double *smooth);

/* Names of the criteria: "circle", ... */
const char *ovr_criterion_name(ovr_criterion criterion);

/* Maximum of the criterion in a smooth dry contact, relative to p_h, and its
 * depth; converts a limit given as a Hertzian pressure to a stress. */
double ovr_hertz_criterion(ovr_criterion criterion, double alpha,
                           double poisson, double *z);

/* Limits of a body with von Mises yield stress 1: p_h of a smooth dry contact
 * at first yield; p_h above which there is no shakedown in rolling; pressure
 * excess that a strip can carry. */
double ovr_first_yield(double poisson);
double ovr_shakedown_limit(void);
double ovr_strip_collapse(void);

/* Computes A as ovr_material_history_measure does. OVR_CRITERION_DANG_VAN needs
 * paths (ovr_dang_van) and is rejected. */
ovr_status ovr_material_history_amplitude(const ovr_material_history *history,
                                          ovr_criterion criterion, double alpha,
                                          float *A, double *smooth,
                                          ovr_error *err);

/* Risk per length i = int <A - A_u>^c z^-h dz from z[j] downward, j = 0 ...
 * depths - 1. NAN if an option is missing, or for more than 1024 depths, the
 * maximum here and below. */
void ovr_risk(const ovr_life_options *options, size_t depths, const double *z,
              const double *A, double *risk);

/* Amplitudes in a material and below a smooth contact, by depth. */
typedef struct ovr_amplitudes {
    const ovr_material *material;
    const float *A;
    const double *smooth;
} ovr_amplitudes;

/* Computes risk[points] from the minimum depth on, and length[depths], the
 * equivalent length lambda = int (i - i_0) dxi / i_0 from z[j] on. Either may
 * be NULL. */
ovr_status ovr_life(const ovr_life_options *options, const ovr_amplitudes *of,
                    double *risk, double *length, ovr_life_result *result,
                    ovr_error *err);

/* Life relative to that of the smooth raceway of this length, with `count`
 * features: (1 + count lambda / raceway)^(-1/e). */
double ovr_life_ratio(const ovr_life_options *options, double equivalent_length,
                      double raceway, double count);

/* The smallest circle around n points (d, tau), exactly. */
ovr_circle ovr_minimum_circle(size_t n, const float *points);

/* Maximum of |s - c| + alpha sigma_h on a path of n points (d, tau) with
 * hydrostatic stresses. */
double ovr_dang_van(size_t n, const float *points, const float *hydrostatic,
                    double alpha);

/* Returns the depth above which a pressure spike that the mesh does not resolve
 * changes the stresses, in the unit of the mesh size. */
double ovr_unresolved_depth(double mesh);

ovr_stress_options ovr_stress_options_default(void);

ovr_material_range ovr_material_range_default(void);

ovr_life_options ovr_life_options_default(void);

#endif
