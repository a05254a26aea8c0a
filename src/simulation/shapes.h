/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Heights of the surfaces: smooth gap, features, and contributions of physical
 * models. */
#ifndef OVR_SIMULATION_SHAPES_H
#define OVR_SIMULATION_SHAPES_H

#include "contact/curvature.h"
#include "simulation/simulation.h"

/* The surfaces of a simulation. */
typedef struct ovr_shapes {
    ovr_heights *heights;
    void *data;
    ovr_heights *sides[2]; /* heights of surface 1 and 2; both NULL: not
                            * distinguished */
    ovr_heights *sides_of; /* total heights to which `sides` belong, and their
                            * data */
    void *sides_data;
    /* features that vary across the rolling direction, with the same data, or
     * NULL. `Y` is the position of the line in `now` (solver.h) */
    ovr_heights_across *across;
    double Y;
    ovr_heights *standing; /* heights of stationary features, or NULL */
    void *standing_data;
    bool standing_given;
    double moving;    /* u_k/um of the features; NAN: unknown */
    double roughness; /* composite Rq of both surfaces; 0: unknown */
    double *S;        /* heights at the nodes, now and one step ago */
    double *S_past;
} ovr_shapes;

/* Sum of the heights on both surfaces at T: features and contributions of
 * physical models. */
void ovr_surface_heights(const ovr_simulation *sim, double T, size_t n,
                         const double *X, double *S);

/* Computes the heights that move with surface 1 or 2, at the nodes and time of
 * S. Returns false if that surface is smooth. */
bool ovr_heights_of(const ovr_simulation *sim, int surface, double *S);

/* True unless both surfaces are smooth. */
bool ovr_has_heights(const ovr_simulation *sim);

/* Sets S and the finest gap X^2/2 - S at time T. */
void ovr_simulation_gap(ovr_simulation *sim, double T);

/* Returns whether the gap of the smooth surfaces at T increases in the whole
 * domain. */
ovr_smooth ovr_simulation_smooth(const ovr_simulation *sim, double T);
ovr_status ovr_smooth_check(const ovr_simulation *sim, double T,
                            ovr_error *err);

#endif
