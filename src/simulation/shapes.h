/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shapes of the surfaces: smooth gap, features, and what physics add. */
#ifndef OVR_SIMULATION_SHAPES_H
#define OVR_SIMULATION_SHAPES_H

#include "contact/curvature.h"
#include "simulation/simulation.h"

/* The surfaces of a simulation. */
typedef struct ovr_shapes {
    ovr_heights *heights;
    void *data;
    ovr_heights *sides[2]; /* heights of surface 1 and 2, or both NULL */
    ovr_heights *sides_of; /* the heights whose parts these are, and data */
    void *sides_data;
    /* Features that vary across, of the same data, or NULL.  `Y` belongs to the
     * line that the solution `now` holds (solver.h). */
    ovr_heights_across *across;
    double Y;
    ovr_heights *standing; /* of what stands still, or NULL */
    void *standing_data;
    bool standing_given;
    double moving;    /* u_k/um of the features; NAN: nobody told */
    double roughness; /* composite Rq of both surfaces; 0: not known */
    double *S;        /* heights at the nodes, now and one step ago */
    double *S_past;
} ovr_shapes;

/* Height of what is on both surfaces at T: features, and what physics add. */
void ovr_surface_heights(const ovr_simulation *sim, double T, size_t n,
                         const double *X, double *S);

/* Computes the heights that move with surface 1 or 2 at the nodes and at the
 * time of S.  Returns false if it is smooth. */
bool ovr_heights_of(const ovr_simulation *sim, int surface, double *S);

/* True if there is anything but the smooth surfaces. */
bool ovr_has_heights(const ovr_simulation *sim);

/* Sets S and the finest gap X^2/2 - S at time T. */
void ovr_simulation_gap(ovr_simulation *sim, double T);

/* Returns whether the gap of the smooth surfaces at T increases in the whole
 * domain. */
ovr_smooth ovr_simulation_smooth(const ovr_simulation *sim, double T);
ovr_status ovr_smooth_check(const ovr_simulation *sim, double T,
                            ovr_error *err);

#endif
