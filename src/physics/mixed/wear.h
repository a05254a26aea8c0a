/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Running-in under constant operating conditions. In each step of the run the
 * two profiles wear in N passes, and their contact model changes. In a pass of
 * surface s
 *
 *     c_s = k_s ph (R/b) |V|/|u_s|
 *     dz_s(x) = -c_s N sum_j w_j P_sj(x)     (surface/rough_pair.h)
 *
 * k_s is Archard's coefficient divided by the hardness. V and u_s are relative
 * to um. The w_j are those of the film before the step. The step is long enough
 * for the film to become steady. N is `jump`, or such that no point loses more
 * than 2 % of the initial combined Rq.
 */
#ifndef OVR_PHYSICS_MIXED_WEAR_H
#define OVR_PHYSICS_MIXED_WEAR_H

#include "physics/mixed/mixed.h"
#include "surface/statistics.h"

/* Time step of a running-in solution, b/u_m, and maximum number of steps. */
#define OVR_WEAR_STEP 1e3
enum { OVR_WEAR_MAX = 4000 };

/* Wear up to the last completed step, or of the step in progress. */
typedef struct ovr_worn {
    double passes;
    double depth[2]; /* mean wear depth, b^2/R: volume per area */
    double *z[2];    /* NULL: smooth */
} ovr_worn;

typedef struct ovr_wear {
    const ovr_boundary_form *given;
    double c[2];
    ovr_rough_pair pair;      /* worn surfaces with the heights of `now` */
    ovr_asperity_law bears;   /* asperity contact model of the worn surfaces */
    ovr_asperity_table spare; /* memory of the next model */
    ovr_worn before, now;
    double *w;            /* weights w_j of the last film */
    double share, change; /* asperity load share; its change in the last step */
    bool lost;            /* no contact model was found for the heights */
} ovr_wear;

/* Allocates memory; does not initialize the wear. */
ovr_status ovr_wear_take(ovr_wear *wear, const ovr_boundary_form *given,
                         const ovr_contact *contact, ovr_arena *arena,
                         ovr_error *err);

/* Starts from the profiles of the case. */
void ovr_wear_begin(ovr_wear *wear);

/* Records the film of a completed step: asperity pressure A at n nodes with
 * weights dX, and asperity load share. */
void ovr_wear_see(ovr_wear *wear, size_t n, const double *A,
                  const double *weights, double share);

/* Computes a step, or a part of it, from the last completed state; accepts it;
 * restores the last completed state. */
void ovr_wear_step(ovr_wear *wear, double part);
void ovr_wear_taken(ovr_wear *wear);
void ovr_wear_back(ovr_wear *wear);

bool ovr_wear_over(const ovr_wear *wear);

void ovr_wear_visit(ovr_wear *wear, ovr_pieces *state);

/* Reduced peak height Rpk and valley depth Rvk of a surface, initially or at
 * present; NAN: smooth surface. */
ovr_core ovr_wear_core(const ovr_wear *wear, int surface, bool given);

/* The wear of a simulation; NULL: no wear. */
const ovr_wear *ovr_wear_of(const ovr_simulation *sim);

extern const struct ovr_companion ovr_wear_companion;

#endif
