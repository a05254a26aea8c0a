/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Properties of the discretization schemes: a constant record for each
 * ovr_scheme. */
#ifndef OVR_SIMULATION_SCHEME_H
#define OVR_SIMULATION_SCHEME_H

#include "overroll/simulation.h"

struct ovr_past;

typedef struct ovr_discretization {
    const char *name;
    int order;           /* order of wedge and time derivative; also the number
                          * of past steps needed */
    double upstream[2];  /* Couette flux at i + 1/2: u0 q_i + u1 q_{i-1} */
    bool characteristic; /* the wedge is in the history term */
    /* d/dT = cT q + c0 q^k + c1 q^{k-1} over dT after dT_old (0: none) */
    void (*difference)(double dT, double dT_old, double *cT, double c[2]);
    /* computes F for the step to T from the past with weights c */
    void (*history)(ovr_simulation *sim, const double c[2], double T);
    /* computes the weights e of the past in the extrapolation q_p over a step
     * h; returns the factor from q - q_p to the local error */
    double (*extrapolation)(const struct ovr_past *past, double h, double e[3]);
} ovr_discretization;

/* Returns the record of a scheme, or NULL if there is none. */
const ovr_discretization *ovr_scheme_record(ovr_scheme scheme);

#endif
