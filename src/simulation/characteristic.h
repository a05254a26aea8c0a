/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The scheme along the characteristics, with the film before the inlet
 * (characteristic.c). */
#ifndef OVR_SIMULATION_CHARACTERISTIC_H
#define OVR_SIMULATION_CHARACTERISTIC_H

#include "simulation/simulation.h"

/* The characteristic scheme needs this beyond the inlet (characteristic.c). */
enum { OVR_GHOSTS = 256 };
typedef struct ovr_inflow {
    double *kernel;   /* K/pi at 0..n+OVR_GHOSTS mesh sizes */
    double *X, *S;    /* at X_a - D, X_a - 2 D, ... */
    double *extended; /* q with ghosts before it */
} ovr_inflow;

/* Memory for the characteristic scheme, and its history term:
 *     F_i = c1 q^k(X_i - a1) + c2 q^{k-1}(X_i - a2). */
ovr_status ovr_inflow_take(ovr_simulation *sim, ovr_error *err);
void ovr_inflow_fill(ovr_simulation *sim);
void ovr_inflow_history(ovr_simulation *sim, const double c[2],
                        const double a[2], double *F);

/* q of a past time at so many ghosts before the inlet, in extended[]. */
void ovr_inflow_ghosts(ovr_simulation *sim, int past, size_t ghosts);

/* Weights of six points at the place `at` among them, counted from 0. */
void ovr_lagrange(double at, double weight[6]);

/* q at T as the past predicts it along the characteristics: the sum of e_k
 * q^{k}(X_i - a_k); false if that is further than the ghosts reach. */
bool ovr_inflow_prediction(ovr_simulation *sim, double T, const double e[3],
                           double *q);

/* F_i += c q(X_i - a) of any q; worth nothing before the node returned, whose
 * departure point is inside. */
size_t ovr_inflow_departure(const ovr_simulation *sim, const double *q,
                            double c, double a, double *F);

/* q[t, t-1, t-2, t-3] of the newest solution, at T, and the past before it: the
 * third divided difference along the characteristics, at the nodes.  What is
 * before the start is a step of dT before what follows it.  False, and nothing
 * done, if that is further than the ghosts reach. */
bool ovr_inflow_third(ovr_simulation *sim, double T, double dT, double *third);

/* The way of a particle since the k-th time of the past, at T. */
double ovr_travel_since(const ovr_simulation *sim, int past, double T);

/* True if a characteristic step of this length has enough ghosts. */
bool ovr_inflow_reaches(const ovr_simulation *sim, double travel);

#endif
