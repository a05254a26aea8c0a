/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A window of plastic material: points along x, continued periodically, in
 * layers over depth. */
#ifndef OVR_STRESS_YIELDING_H
#define OVR_STRESS_YIELDING_H

#include "overroll/memory.h"
#include "stress/hardening.h"
#include "stress/stress.h"

/* Residual stresses due to plastic strains below a free surface, for single
 * waves. */

/* A layer with constant plastic strain; depths in b. */
typedef struct ovr_strained_layer {
    double top, bottom;
} ovr_strained_layer;

/* Amplitudes of strain in p_h/E*: x and z multiply cos kx, xz multiplies sin
 * kx. */
typedef struct ovr_plastic_strain {
    double x, z, xz;
} ovr_plastic_strain;

/* Amplitudes of stress in p_h: x, y and z multiply cos kx, xz multiplies -sin
 * kx. */
typedef struct ovr_residual_stress {
    double x, y, z, xz;
} ovr_residual_stress;

/* Residual stress at depth z due to the strain of one layer; k = 0: strain that
 * is constant along x. */
ovr_residual_stress ovr_residual_at(double k, double poisson,
                                    ovr_strained_layer source,
                                    ovr_plastic_strain strain, double z);

/* Mean of the residual stress over another layer or the same one. */
ovr_residual_stress ovr_residual_mean(double k, double poisson,
                                      ovr_strained_layer source,
                                      ovr_plastic_strain strain,
                                      ovr_strained_layer receiver);

/* Displacement of the surface into the body, in b p_h/E*; k > 0. */
double ovr_plastic_sinking(double k, double poisson, ovr_strained_layer source,
                           ovr_plastic_strain strain);

typedef struct ovr_yielding_options {
    size_t points; /* a power of two */
    double mesh;   /* between them, b */
    size_t layers;
    const double *edge; /* layers + 1 increasing depths, starting at 0, borrowed
                         */
    double poisson;
    ovr_hardening hardening;
    int iterations;
    double enough; /* tolerance of f/Y; 0: 1e-3 */
} ovr_yielding_options;

typedef struct ovr_yielding ovr_yielding;

ovr_yielding *ovr_yielding_create(const ovr_yielding_options *options,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_yielding_free(ovr_yielding *y);
double ovr_yielding_memory(const ovr_yielding_options *options);

/* Depths of `layers` layers; the first has thickness `first`, the last ends at
 * `depth`. */
void ovr_yielding_layers(size_t layers, double first, double depth,
                         double *edge);

/* Elastic stresses of a layer at every point, to be filled by the caller; idle:
 * no point yields. */
typedef struct ovr_layer_load {
    float *h, *d, *tau;
    bool idle;
} ovr_layer_load;
ovr_layer_load *ovr_yielding_load(ovr_yielding *y, size_t layer);

/* True if a point with this elastic stress exceeds this fraction of its yield
 * stress. */
bool ovr_yielding_is_near(const ovr_yielding *y, size_t layer, size_t i,
                          ovr_in_plane elastic, double share);

/* Minimum von Mises stress that must be added anywhere to cause plastic flow:
 * yield stress minus residual stress, at the point where it is least. Cached
 * until strains change. */
double ovr_yielding_reserve(ovr_yielding *y);

/* Repeats plastic flow until no stress exceeds yield by more than `enough`, up
 * to a maximum number of iterations. */
typedef struct ovr_flowed {
    int iterations; /* iterations with plastic flow; 0: no flow */
    size_t points;  /* points with plastic flow in the first iteration */
    double left;    /* maximum f/Y before the last iteration */
    double maximum; /* maximum plastic strain increment of a point, p_h/E* */
    double work;    /* b^2 p_h^2/E* along the line */
} ovr_flowed;
ovr_flowed ovr_yielding_flow(ovr_yielding *y);

/* Present strains and residual stresses of a layer's point; displacement of
 * each surface point into the body, b p_h/E*, 0 at the ends of the window. */
ovr_strained ovr_yielding_strain(const ovr_yielding *y, size_t layer, size_t i);
ovr_stressed ovr_yielding_residual(const ovr_yielding *y, size_t layer,
                                   size_t i);
const double *ovr_yielding_sinking(const ovr_yielding *y);

/* Strains of a layer, to be set by the caller: `points` each of x, z, xz and
 * all. After all are set, `settle` computes stresses and surface displacement.
 */
double *ovr_yielding_strains(ovr_yielding *y, size_t layer);
void ovr_yielding_settle(ovr_yielding *y);

#endif
