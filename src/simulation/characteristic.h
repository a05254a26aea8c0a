/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The characteristic scheme, including the film upstream of the inlet
 * (characteristic.c). */
#ifndef OVR_SIMULATION_CHARACTERISTIC_H
#define OVR_SIMULATION_CHARACTERISTIC_H

#include "simulation/simulation.h"

/* Ghost nodes upstream of the inlet, for the characteristic scheme
 * (characteristic.c). */
enum { OVR_GHOSTS = 256 };
typedef struct ovr_inflow {
    double *kernel;   /* K/pi at 0..n+OVR_GHOSTS mesh sizes */
    double *X, *S;    /* nodes X_a - D, X_a - 2 D, ... and heights there */
    double *extended; /* q with ghost nodes upstream of it */
} ovr_inflow;

/* Allocates memory for the characteristic scheme, and computes its history
 * term:
 *     F_i = c1 q^k(X_i - a1) + c2 q^{k-1}(X_i - a2). */
ovr_status ovr_inflow_take(ovr_simulation *sim, ovr_error *err);
void ovr_inflow_fill(ovr_simulation *sim);
void ovr_inflow_history(ovr_simulation *sim, const double c[2],
                        const double a[2], double *F);

/* Computes q of a past time at the first `ghosts` ghost nodes, in extended[].
 */
void ovr_inflow_ghosts(ovr_simulation *sim, int past, size_t ghosts);

/* Weights of six-point Lagrange interpolation at position `at`, counted from
 * point 0. */
void ovr_lagrange(double at, double weight[6]);

/* Predicts q at T from the past along the characteristics: the sum of e_k
 * q^{k}(X_i - a_k). Returns false if there are not enough ghost nodes. */
bool ovr_inflow_prediction(ovr_simulation *sim, double T, const double e[3],
                           double *q);

/* F_i += c q(X_i - a). Results before the returned node are invalid, because
 * their departure points are outside the grid. */
size_t ovr_inflow_departure(const ovr_simulation *sim, const double *q,
                            double c, double a, double *F);

/* Third divided difference q[t, t-1, t-2, t-3] along the characteristics, of
 * the newest solution q at T and the past, at the nodes. The time before the
 * first known one is assumed to be dT earlier. Returns false and does nothing
 * if there are not enough ghost nodes. */
bool ovr_inflow_third(ovr_simulation *sim, const double *q, double T, double dT,
                      double *third);

/* Distance travelled by a particle since the k-th past time, at T. */
double ovr_travel_since(const ovr_simulation *sim, int past, double T);

/* True if a characteristic step of this length has enough ghosts. */
bool ovr_inflow_reaches(const ovr_simulation *sim, double travel);

#endif
