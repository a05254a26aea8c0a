/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lubricant supply at the inlet, and lubricant content along the
 * characteristics (content_history.c). */
#ifndef OVR_SIMULATION_ARRIVAL_H
#define OVR_SIMULATION_ARRIVAL_H

#include "simulation/restart.h"

/* Lubricant content convected along the characteristic (content_history.c). */
typedef struct ovr_carriage {
    double *came;   /* `coming` of the last step */
    double *coming; /* content at the last time, at the departure points of this
                       step */
    double *coming_twice;
    double *extended; /* q with ghost nodes upstream of the inlet */
    /* Content, in cells, that crossed the first and the last face one step ago
     * and in this step; whether the inlet was and is closed. */
    double crossed[2], crossing[2];
    bool closed, closes;
    double flow[2]; /* flow rates through these faces */
    double arrives; /* content that the supplied film would add */
} ovr_carriage;

/* The supplied content q = rho H at the inlet at time T >= 0 (before: that of
 * T = 0). For layers h1, h2 it is (u1 h1 + u2 h2)/um. */
typedef double ovr_supply(void *data, double T);

/* Lubricant supply (supply.c). */
typedef struct ovr_arrival {
    ovr_supply *supply; /* NULL: flooded */
    void *data;
    double before;    /* volume in the inlet reservoir at the start */
    double reservoir; /* present volume in the reservoir */
    bool closed;      /* inflow is limited to the supply */
    double flooded;   /* central film thickness of the flooded start */
    double flow;      /* flow rate rho H of the flooded start */
    double q, face; /* inflow of this step at X_a, and D/2 downstream of X_a */
    double *kept;   /* contents of a solution during continuation, and its
                     * inlet */
    bool closed_kept;
    ovr_carriage carriage;
} ovr_arrival;

/* True if cavitation is mass-conserving (multigrid/content.h). */
bool ovr_conserves(const ovr_simulation *sim);

/* History term with mass-conserving cavitation (content_history.c). */
void ovr_content_history(ovr_simulation *sim, double dT, const double c[2]);

/* History term along the characteristic (content_history.c): allocation, update
 * after a step, checkpoint. */
ovr_status ovr_carriage_take(ovr_simulation *sim, ovr_error *err);
void ovr_carriage_taken(ovr_simulation *sim);

/* Evaluates x at the departure points between the last time and T; x is 0
 * upstream of the inlet. */
void ovr_carriage_move(ovr_simulation *sim, double T, const double *x,
                       double *to);
void ovr_carriage_visit(ovr_simulation *sim, ovr_pieces *state);

/* True if the inlet is closed in the next step. The second function writes q of
 * the supply at X_a - D, X_a - 2 D, ... at T, downwards from `last`. */
bool ovr_arrival_closes(const ovr_simulation *sim);
void ovr_arrival_ghosts(const ovr_simulation *sim, double T, size_t ghosts,
                        double *last);

#endif
