/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The film that arrives, and oil content along the characteristics
 * (content_history.c). */
#ifndef OVR_SIMULATION_ARRIVAL_H
#define OVR_SIMULATION_ARRIVAL_H

#include "simulation/restart.h"

/* Oil that is carried along the characteristic (content_history.c). */
typedef struct ovr_carriage {
    double *came;   /* at the nodes now: the content of a step ago there, */
    double *coming; /* and that of now, in a step's time; two steps ago */
    double *coming_twice;
    double *extended; /* the history with ghosts before it */
    /* cells across the first and the last face, a step ago and in this one;
     * whether the inlet was closed then */
    double crossed[2], crossing[2];
    bool closed, closes;
    double flow[2]; /* there, in a time */
    double arrives; /* would flow in, of the film that is supplied */
} ovr_carriage;

/* The film that arrives (supply.c). */
typedef struct ovr_arrival {
    ovr_supply *supply; /* NULL: flooded */
    void *data;
    double before;    /* in the inlet reservoir at the start */
    double reservoir; /* now */
    bool closed;      /* only what arrives flows in */
    double flooded;   /* central film thickness of the flooded start */
    double flow;      /* what that takes, rho H */
    double q, face;   /* of this step: at X_a, half a mesh further */
    double *kept;     /* contents of a solution on a path, and its inlet */
    bool closed_kept;
    ovr_carriage carriage;
} ovr_arrival;

/* True if cavitation is mass-conserving (multigrid/content.h). */
bool ovr_conserves(const ovr_simulation *sim);

/* The history term where cavitation is mass-conserving (content_history.c). */
void ovr_content_history(ovr_simulation *sim, double dT, const double c[2]);

/* The same along the characteristic (content_history.c): memory, the history
 * term, a step that is taken, its checkpoint. */
ovr_status ovr_carriage_take(ovr_simulation *sim, ovr_error *err);
void ovr_carriage_history(ovr_simulation *sim, double dT, const double c[2]);
void ovr_carriage_taken(ovr_simulation *sim);

/* x at the departure points, from the last time reached to T; nothing is before
 * the inlet.
 */
void ovr_carriage_move(ovr_simulation *sim, double T, const double *x,
                       double *to);
void ovr_carriage_visit(ovr_simulation *sim, ovr_pieces *state);

/* True if only what arrives enters in the step to come; q at X_a - D, X_a - 2
 * D, ... at T, of what arrives later, written downwards from `last`. */
bool ovr_arrival_closes(const ovr_simulation *sim);
void ovr_arrival_ghosts(const ovr_simulation *sim, double T, size_t ghosts,
                        double *last);

#endif
