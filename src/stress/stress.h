/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses below a surface, material histories, and lives. */
#ifndef OVR_STRESS_STRESS_H
#define OVR_STRESS_STRESS_H

#include "overroll/stress.h"

struct ovr_layered;
typedef struct ovr_stress_options {
    double mesh;       /* D */
    double inlet;      /* X of the first node */
    size_t nodes;      /* of P and Q */
    double from, to;   /* where fields are asked for; -2.6 and 2.6 */
    double depth_min;  /* 0: 4 D; not above D/2 */
    double depth_max;  /* 2.5 */
    double per_octave; /* depths; 5 */
    ovr_element element;
    bool traction;                    /* Q is given */
    const struct ovr_layered *layers; /* on the body, in b; NULL: none */
} ovr_stress_options;

typedef struct ovr_material_range {
    double reference;  /* X where xi = 0 is at U = 0 */
    double from, to;   /* xi, b; fixed in the material */
    double reach;      /* paths are followed through |X| <= reach; 2.5 */
    double poisson;    /* 0.3 */
    double residual_x; /* stresses already there, p_h, tension positive */
    double residual_y;
    size_t residuals; /* by depth in place of both, along and across alike: */
    const double *residual_z, *residual_s; /* depths, b, which rise; stresses */
    double least_depth; /* extremes are looked for from here; 0: 8 D */
    /* Residual stresses of the layers of ovr_stress_options, along x and along
     * the line, borrowed; NULL: none.  What is above is that of the body below
     * them. */
    const double *layer_residual; /* two of each */
    double yield;                 /* von Mises, of the body; 0: unknown */
} ovr_material_range;

/* Closed forms of every depth, transformed once. */
ovr_stress *ovr_stress_create(const ovr_stress_options *options,
                              const ovr_allocator *allocator, ovr_error *err);

/* Uses the caller's depths, in increasing order. */
ovr_stress *ovr_stress_create_at(const ovr_stress_options *options,
                                 size_t depths, const double *z,
                                 const ovr_allocator *allocator,
                                 ovr_error *err);
void ovr_stress_free(ovr_stress *stress);

/* Memory that ovr_stress_create would take, bytes; NAN when refused. */
double ovr_stress_memory(const ovr_stress_options *given);

size_t ovr_stress_depths(const ovr_stress *stress, const double **z);

void ovr_stress_solve(ovr_stress *stress, const double *P, const double *Q,
                      double shift, unsigned levels);

/* One depth; valid until the next solve. */
ovr_stress_row ovr_stress_at(const ovr_stress *stress, size_t j);

/* The same of the last solve, at every node of the mesh.  Valid until the next
 * call. */
ovr_status ovr_stress_at_every_node(ovr_stress *stress, size_t j,
                                    ovr_stress_row *row, ovr_error *err);

/* "sigma_x", ... */
const char *ovr_stress_field_name(ovr_stress_field field);
double ovr_stress_value(ovr_stress_field field, ovr_in_plane state,
                        double poisson, double residual_x, double residual_y);

/* The stress at (x, z) below one element of height 1 at x = 0, mesh D, loaded
 * by pressure p and traction q. */
ovr_in_plane ovr_element_stress(ovr_element element, double D, double p,
                                double q, double x, double z);

/* Smooth dry contact, P = p sqrt(1 - X^2), Q = q sqrt(1 - X^2). */
ovr_in_plane ovr_hertz_stress(double p, double q, double x, double z);

ovr_material_history *
ovr_material_history_create(const ovr_stress_options *given,
                            const ovr_material_range *range,
                            const ovr_allocator *allocator, ovr_error *err);
void ovr_material_history_free(ovr_material_history *history);
double ovr_material_history_memory(const ovr_stress_options *given,
                                   const ovr_material_range *range);

/* The contact is steady before the first moment and after the last, as it is at
 * that moment. */
void ovr_material_history_begin(ovr_material_history *history, const double *P,
                                const double *Q, const ovr_moment *moment);
void ovr_material_history_step(ovr_material_history *history, const double *P,
                               const double *Q, const ovr_moment *moment);
void ovr_material_history_end(ovr_material_history *history, const double *P,
                              const double *Q, const ovr_moment *moment);

/* Pieces of memory that make up the state between two steps. */
size_t ovr_material_history_state(ovr_material_history *history,
                                  const ovr_memory_piece **pieces);

/* X where xi = 0 is at U = 0. */
double ovr_material_history_reference(const ovr_material_history *history);

/* The material points of a material history. */
ovr_material ovr_material_history_points(const ovr_material_history *history);

/* Largest values that a moment's fields showed from least_depth down. */
ovr_stress_extreme
ovr_material_history_max_shear(const ovr_material_history *history);
ovr_stress_extreme
ovr_material_history_von_mises(const ovr_material_history *history);

/* The largest mean pressure of a strip, at least least_depth wide, above that
 * around it (yield.c), at its middle, Z its width; all NAN without a yield. */
ovr_stress_extreme
ovr_material_history_strip(const ovr_material_history *history);

/* The largest way between two moments of a path that was followed: depths
 * above 4 times this are missed in part. */
double ovr_material_history_widest(const ovr_material_history *history);

/* Fills value[depth * points + k], and smooth[depth] with the steady contact
 * before the run; either may be NULL. */
void ovr_material_history_measure(const ovr_material_history *history,
                                  ovr_measure which, float *to, double *smooth);

/* "circle", ... */
const char *ovr_criterion_name(ovr_criterion criterion);

/* The criterion's largest value in a smooth dry contact, per p_h, and where:
 * what turns a limit given as a Hertz pressure into a stress. */
double ovr_hertz_criterion(ovr_criterion criterion, double alpha,
                           double poisson, double *z);

/* Limits of a body that yields at a von Mises stress of 1: p_h of the smooth
 * dry contact at its first yield, and above which it never shakes down in
 * rolling; what a strip of uniform pressure bears above the pressure around
 * it. */
double ovr_first_yield(double poisson);
double ovr_shakedown_limit(void);
double ovr_strip_collapse(void);

/* Fills A as ovr_material_history_measure does; OVR_CRITERION_DANG_VAN needs
 * paths (ovr_dang_van) and is refused. */
ovr_status ovr_material_history_amplitude(const ovr_material_history *history,
                                          ovr_criterion criterion, double alpha,
                                          float *A, double *smooth,
                                          ovr_error *err);

/* NAN where the options have no size or depths are more than 1024, the most
 * here and below.  Risk per length i = int <A - A_u>^c z^-h
 * dz from z[j] downward, j = 0 ... depths - 1. */
void ovr_risk(const ovr_life_options *options, size_t depths, const double *z,
              const double *A, double *risk);

/* Amplitudes of a material, and below a smooth contact, by depth. */
typedef struct ovr_amplitudes {
    const ovr_material *material;
    const float *A;
    const double *smooth;
} ovr_amplitudes;

/* risk[points]: from the smallest depth down; length[depths]: the equivalent
 * length lambda = int (i - i_0) dxi / i_0 counted from z[j] down.  Either may
 * be NULL. */
ovr_status ovr_life(const ovr_life_options *options, const ovr_amplitudes *of,
                    double *risk, double *length, ovr_life_result *result,
                    ovr_error *err);

/* Life over that of the smooth raceway of this length with so many of the
 * features: (1 + count lambda / raceway)^(-1/e). */
double ovr_life_ratio(const ovr_life_options *options, double equivalent_length,
                      double raceway, double count);

/* The smallest circle round n points (d, tau), exactly. */
ovr_circle ovr_minimum_circle(size_t n, const float *points);

/* Largest |s - c| + alpha sigma_h on a path of n points (d, tau) with
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
