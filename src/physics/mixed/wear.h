/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Running-in under constant operating conditions: in each step of the run the
 * two profiles wear in N passes, and their contact model changes.
 *     in a pass, of surface s: c_s = k_s ph (R/b) |V|/|u_s|
 *     dz_s(x) = -c_s N sum_j w_j P_sj(x)     (surface/rough_pair.h)
 *
 * k_s is Archard's coefficient over the hardness, V and u_s over um; w_j are
 * those of the film before the step.  A step is so long that the film has
 * settled.  N: `jump`, or so that no place loses more than 2 % of the Rq that
 * both had at first.
 */
#ifndef OVR_PHYSICS_MIXED_WEAR_H
#define OVR_PHYSICS_MIXED_WEAR_H

#include "physics/mixed/mixed.h"
#include "surface/statistics.h"

/* Time step of a running-in solution, b/u_m, and maximum number of steps. */
#define OVR_WEAR_STEP 1e3
enum { OVR_WEAR_MAX = 4000 };

/* The wear so far: of the state that was reached last, or of the step that is
 * under way. */
typedef struct ovr_worn {
    double passes;
    double depth[2]; /* mean, b^2/R: volume over area */
    double *z[2];    /* NULL: smooth */
} ovr_worn;

typedef struct ovr_wear {
    const ovr_boundary_form *given;
    double c[2];
    ovr_rough_pair pair;    /* its heights are those of `now` */
    ovr_asperity_law bears; /* what they bear */
    ovr_worn before, now;
    double *w;            /* of the film reached last */
    double share, change; /* of it; by which the last step changed it */
    bool lost;            /* no law was found for the heights */
} ovr_wear;

/* Memory; `wear` is nothing yet. */
ovr_status ovr_wear_take(ovr_wear *wear, const ovr_boundary_form *given,
                         const ovr_contact *contact, ovr_arena *arena,
                         ovr_error *err);

/* From the profiles as they are given. */
void ovr_wear_begin(ovr_wear *wear);

/* The film that was reached bears A over n weights dX; share: of the load. */
void ovr_wear_see(ovr_wear *wear, size_t n, const double *A,
                  const double *weights, double share);

/* A step, a part of it, from what was reached last; it is reached; back to
 * that. */
void ovr_wear_step(ovr_wear *wear, double part);
void ovr_wear_taken(ovr_wear *wear);
void ovr_wear_back(ovr_wear *wear);

bool ovr_wear_over(const ovr_wear *wear);

void ovr_wear_visit(ovr_wear *wear, ovr_pieces *state);

/* Peaks above the core of a surface (Rpk) and valleys below it (Rvk), as it was
 * given or as it is now; NAN: it is smooth. */
ovr_core ovr_wear_core(const ovr_wear *wear, int surface, bool given);

/* The wear of a simulation; NULL: it has none. */
const ovr_wear *ovr_wear_of(const ovr_simulation *sim);

extern const struct ovr_companion ovr_wear_companion;

#endif
