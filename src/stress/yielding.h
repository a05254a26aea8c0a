/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A window of material that yields: points along x, again and again with their
 * period, in layers of depth. */
#ifndef OVR_STRESS_YIELDING_H
#define OVR_STRESS_YIELDING_H

#include "overroll/memory.h"
#include "overroll/stress.h"
#include "stress/hardening.h"

/* Stresses that plastic strains leave behind below a free surface, wave by
 * wave. */

/* A layer of constant plastic strain; depths in b. */
typedef struct ovr_strained_layer {
    double top, bottom;
} ovr_strained_layer;

/* Amplitudes of strain over p_h/E*: x and z are cos kx, xz is sin kx. */
typedef struct ovr_plastic_strain {
    double x, z, xz;
} ovr_plastic_strain;

/* Amplitudes of stress in p_h: x, y and z are cos kx, xz is -sin kx. */
typedef struct ovr_residual_stress {
    double x, y, z, xz;
} ovr_residual_stress;

/* The stress at depth z from the strain of one layer; k = 0 is a strain that is
 * the same everywhere along x. */
ovr_residual_stress ovr_residual_at(double k, double poisson,
                                    ovr_strained_layer source,
                                    ovr_plastic_strain strain, double z);

/* Its mean over another layer, or over the same one. */
ovr_residual_stress ovr_residual_mean(double k, double poisson,
                                      ovr_strained_layer source,
                                      ovr_plastic_strain strain,
                                      ovr_strained_layer receiver);

/* The distance by which the surface moves into the body, in b p_h/E*; k > 0. */
double ovr_plastic_sinking(double k, double poisson, ovr_strained_layer source,
                           ovr_plastic_strain strain);

typedef struct ovr_yielding_options {
    size_t points; /* a power of two */
    double mesh;   /* between them, b */
    size_t layers;
    const double *edge; /* layers + 1 depths that rise from 0, borrowed */
    double poisson;
    ovr_hardening hardening;
    int iterations;
    double enough; /* f/Y at which they end; 0: 1e-3 */
} ovr_yielding_options;

typedef struct ovr_yielding ovr_yielding;

ovr_yielding *ovr_yielding_create(const ovr_yielding_options *options,
                                  const ovr_allocator *allocator,
                                  ovr_error *err);
void ovr_yielding_free(ovr_yielding *y);
double ovr_yielding_memory(const ovr_yielding_options *options);

/* Depths of `layers` layers, the first so thick, that grow to `depth`. */
void ovr_yielding_layers(size_t layers, double first, double depth,
                         double *edge);

/* The elastic stresses of a moment in the middle of a layer at every point, to
 * be filled; idle: nothing yields there, whatever they are. */
typedef struct ovr_layer_load {
    float *h, *d, *tau;
    bool idle;
} ovr_layer_load;
ovr_layer_load *ovr_yielding_load(ovr_yielding *y, size_t layer);

/* True if a point is above this share of its yield under an elastic stress. */
bool ovr_yielding_is_near(const ovr_yielding *y, size_t layer, size_t i,
                          ovr_in_plane elastic, double share);

/* The least von Mises stress that has to be added anywhere before anything
 * flows: yield less what is already borne, at the point nearest to it.  Kept
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

/* The present state: strains, and residual stresses, of a layer's
 * point; how far each point of the surface has moved into the body, b p_h/E*, 0
 * at the ends of the window. */
ovr_strained ovr_yielding_strain(const ovr_yielding *y, size_t layer, size_t i);
ovr_stressed ovr_yielding_residual(const ovr_yielding *y, size_t layer,
                                   size_t i);
const double *ovr_yielding_sinking(const ovr_yielding *y);

/* Strains of a layer from outside: `points` each of x, z, xz and all.  Once all
 * are set, settle makes stresses and surface of them. */
double *ovr_yielding_strains(ovr_yielding *y, size_t layer);
void ovr_yielding_settle(ovr_yielding *y);

#endif
