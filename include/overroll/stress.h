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
 *     ovr_passage *passage = ovr_passage_create(&options, &range, NULL, &err);
 *     ovr_passage_begin(passage, P, NULL, &moment);         steady start
 *     ovr_passage_step(passage, P, NULL, &moment);          each step
 *     ovr_passage_end(passage, P, NULL, &moment);           last state
 *     ovr_passage_amplitude(passage, OVR_CRITERION_CIRCLE, 0, A);
 *     ovr_life(...)
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

/* What stands for the pressure between two nodes. */
typedef enum ovr_element {
    OVR_ELEMENT_AUTO,  /* points from 4 D downward, splines above */
    OVR_ELEMENT_POINT, /* line loads: exact from 4 D downward */
    OVR_ELEMENT_HAT,   /* linear between nodes, order 2 */
    OVR_ELEMENT_SPLINE /* cardinal cubic splines, order 4 */
} ovr_element;

struct ovr_layered;
typedef struct ovr_stress_options {
    size_t size;       /* of this struct, as its user knows it */
    double mesh;       /* D */
    double inlet;      /* X of the first node */
    size_t nodes;      /* of P and Q */
    double from, to;   /* where fields are wanted; -2.6 and 2.6 */
    double depth_min;  /* 0: 4 D; not above D/2 */
    double depth_max;  /* 2.5 */
    double per_octave; /* depths; 5 */
    ovr_element element;
    bool traction;                    /* Q is given */
    const struct ovr_layered *layers; /* on the body, in b; NULL: none */
} ovr_stress_options;
OVR_SIZED(ovr_stress_options)

typedef struct ovr_stress ovr_stress;

/* Closed forms of every depth, transformed once. */
OVR_API ovr_stress *ovr_stress_create(const ovr_stress_options *options,
                                      const ovr_allocator *allocator,
                                      ovr_error *err);
OVR_API void ovr_stress_free(ovr_stress *stress);

/* Memory that ovr_stress_create would take, bytes; NAN when refused. */
OVR_API double ovr_stress_memory(const ovr_stress_options *options);

OVR_API size_t ovr_stress_depths(const ovr_stress *stress, const double **z);

/* Fields of P and Q (nodes values each; Q NULL: none), their nodes moved by
 * `shift` mesh sizes, 0 <= shift <= 64.  `levels`: bit c is the depths whose
 * nodes are 2^c D apart; the others keep what they hold. */
#define OVR_STRESS_ALL_LEVELS (~0U)
OVR_API void ovr_stress_solve(ovr_stress *stress, const double *P,
                              const double *Q, double shift, unsigned levels);

/* One depth: value i stands at X = start + i step; d at shear[2 i], tau at
 * shear[2 i + 1], h at mean[2 i].  Valid until the next solve. */
typedef struct ovr_stress_row {
    double z;
    int level;          /* step = 2^level D */
    double start, step; /* of X, the shift included */
    size_t count;
    const float *shear, *mean;
} ovr_stress_row;
OVR_API ovr_stress_row ovr_stress_at(const ovr_stress *stress, size_t depth);

/* The same of the last solve, at every node of the mesh.  Valid until the next
 * call. */
OVR_API ovr_status ovr_stress_at_every_node(ovr_stress *stress, size_t depth,
                                            ovr_stress_row *row,
                                            ovr_error *err);

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

/* "sigma_x", ... */
OVR_API const char *ovr_stress_field_name(ovr_stress_field field);
OVR_API double ovr_stress_value(ovr_stress_field field, ovr_in_plane state,
                                double poisson, double residual_x,
                                double residual_y);

/* ------------------------------------------------------ exact references */

/* At (x, z) below one element of height 1 at x = 0, mesh D, loaded by
 * pressure p and traction q. */
OVR_API ovr_in_plane ovr_element_stress(ovr_element element, double D, double p,
                                        double q, double x, double z);

/* Smooth dry contact, P = p sqrt(1 - X^2), Q = q sqrt(1 - X^2). */
OVR_API ovr_in_plane ovr_hertz_stress(double p, double q, double x, double z);

/* -------------------------------------------------------------- passages */

typedef struct ovr_material_range {
    size_t size;       /* of this struct, as its user knows it */
    double reference;  /* X where xi = 0 is at U = 0 */
    double from, to;   /* xi, b; fixed in the material */
    double reach;      /* paths are followed through |X| <= reach; 2.5 */
    double poisson;    /* 0.3 */
    double residual_x; /* stresses already there, p_h, tension positive */
    double residual_y;
    double least_depth; /* extremes are looked for from here; 0: 8 D */
    /* Of the layers of ovr_stress_options, along x and across, borrowed; NULL:
     * none.  What is above is that of the body below them. */
    const double *layer_residual; /* two of each */
} ovr_material_range;
OVR_SIZED(ovr_material_range)

/* One moment of a run. */
typedef struct ovr_moment {
    double T;
    double U;       /* way of the surface since T = 0, b */
    double dU;      /* largest way of either surface or of the film against
                       the others since the moment before */
    int direction;  /* of the surface's motion: 1 or -1 */
    bool disturbed; /* a feature is within |X| < 2 (begin, end) */
} ovr_moment;

typedef struct ovr_passage ovr_passage;

OVR_API ovr_passage *ovr_passage_create(const ovr_stress_options *options,
                                        const ovr_material_range *range,
                                        const ovr_allocator *allocator,
                                        ovr_error *err);
OVR_API void ovr_passage_free(ovr_passage *passage);
OVR_API double ovr_passage_memory(const ovr_stress_options *options,
                                  const ovr_material_range *range);

/* What lies before the first and after the last moment is a steady contact
 * like the one of that moment. */
OVR_API void ovr_passage_begin(ovr_passage *passage, const double *P,
                               const double *Q, const ovr_moment *moment);
OVR_API void ovr_passage_step(ovr_passage *passage, const double *P,
                              const double *Q, const ovr_moment *moment);
OVR_API void ovr_passage_end(ovr_passage *passage, const double *P,
                             const double *Q, const ovr_moment *moment);

/* Pieces of memory that make up the state between two steps. */
typedef struct ovr_memory_piece {
    const char *name;
    void *memory;
    size_t bytes;
} ovr_memory_piece;
OVR_API size_t ovr_passage_state(ovr_passage *passage,
                                 const ovr_memory_piece **pieces);

/* Material points, the finest grid: xi_k = start + k step. */
typedef struct ovr_material {
    size_t points, depths;
    double start, step;
    const double *z;
    const unsigned char *complete; /* no closure of the run mattered */
} ovr_material;
OVR_API ovr_material ovr_passage_material(const ovr_passage *passage);

/* Largest values that a moment's fields showed from least_depth down. */
typedef struct ovr_stress_extreme {
    double value, X, Z, T;
} ovr_stress_extreme;
OVR_API ovr_stress_extreme ovr_passage_max_shear(const ovr_passage *passage);
OVR_API ovr_stress_extreme ovr_passage_von_mises(const ovr_passage *passage);

/* The largest way between two moments of a path that was followed: depths
 * above 4 times this are missed in part. */
OVR_API double ovr_passage_widest(const ovr_passage *passage);

/* What happened to a material point at a depth. */
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

/* Fills value[depth * points + k], and smooth[depth] with the steady contact
 * before the run; either may be NULL. */
OVR_API void ovr_passage_measure(const ovr_passage *passage,
                                 ovr_measure measure, float *value,
                                 double *smooth);

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

/* "circle", ... */
OVR_API const char *ovr_criterion_name(ovr_criterion criterion);

/* The criterion's largest value in a smooth dry contact, per p_h, and where:
 * what turns a limit given as a Hertz pressure into a stress. */
OVR_API double ovr_hertz_criterion(ovr_criterion criterion, double alpha,
                                   double poisson, double *z);

/* Fills A as ovr_passage_measure does; OVR_CRITERION_DANG_VAN needs paths
 * (ovr_dang_van) and is refused. */
OVR_API ovr_status ovr_passage_amplitude(const ovr_passage *passage,
                                         ovr_criterion criterion, double alpha,
                                         float *A, double *smooth,
                                         ovr_error *err);

typedef struct ovr_life_options {
    size_t size;           /* of this struct, as its user knows it */
    double limit;          /* A_u: amplitudes below it do no harm, p_h */
    double exponent;       /* c; 31/3 */
    double depth_exponent; /* h; 7/3 */
    double weibull;        /* e; 9/8 */
    double least_depth;    /* of risk and utilisation */
} ovr_life_options;
OVR_SIZED(ovr_life_options)

/* NAN where the options have no size or depths are more than 1024, the most
 * here and below.  Risk per length i = int <A - A_u>^c z^-h
 * dz from z[j] downward, j = 0 ... depths - 1. */
OVR_API void ovr_risk(const ovr_life_options *options, size_t depths,
                      const double *z, const double *A, double *risk);

typedef struct ovr_life_result {
    size_t size;              /* of this struct */
    double smooth_risk;       /* i_0 from least_depth down */
    double equivalent_length; /* from least_depth down; NAN where i_0 = 0 */
    double least_depth;       /* the row it was counted from */
    double worst_amplitude;   /* largest A from there down */
    double worst_xi, worst_z;
    double utilisation; /* worst_amplitude / A_u; NAN without a limit */
    size_t counted;     /* complete points */
} ovr_life_result;

/* risk[points]: from the least depth down; length[depths]: the equivalent
 * length lambda = int (i - i_0) dxi / i_0 counted from z[j] down.  Either may
 * be NULL. */
OVR_API ovr_status ovr_life_into(const ovr_life_options *options,
                                 const ovr_material *material, const float *A,
                                 const double *smooth, double *risk,
                                 double *length, ovr_life_result *result,
                                 ovr_error *err);
static inline ovr_status ovr_life(const ovr_life_options *options,
                                  const ovr_material *material, const float *A,
                                  const double *smooth, double *risk,
                                  double *length, ovr_life_result *result,
                                  ovr_error *err)
{
    if (result)
        result->size = sizeof *result;
    return ovr_life_into(options, material, A, smooth, risk, length, result,
                         err);
}

/* Life over that of the smooth raceway of this length with so many of the
 * features: (1 + count lambda / raceway)^(-1/e). */
OVR_API double ovr_life_ratio(const ovr_life_options *options,
                              double equivalent_length, double raceway,
                              double count);

/* ------------------------------------------------------- circle of a path */

typedef struct ovr_circle {
    double d, tau, radius;
} ovr_circle;

/* The smallest circle round n points (d, tau), exactly. */
OVR_API ovr_circle ovr_smallest_circle(size_t n, const float *points);

/* Largest |s - c| + alpha sigma_h on a path of n points (d, tau) with
 * hydrostatic stresses. */
OVR_API double ovr_dang_van(size_t n, const float *points,
                            const float *hydrostatic, double alpha);

#ifdef __cplusplus
}
#endif

#endif
