/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A steady solution with patches about its spike: the composite grids
 * (multigrid/spike.h) over the finest grid of the whole domain, and their
 * leaves as the solution that all others see. */
#ifndef OVR_SIMULATION_REFINED_H
#define OVR_SIMULATION_REFINED_H

#include "simulation/internal.h"

/* Patches need a grid that has nodes for the first of them, and memory for the
 * last. */
enum { OVR_MIN_REFINED = 6, OVR_MAX_REFINED = 22 };

/* The relative change of the spike by one patch more: unless it is given, and
 * at most. */
#define OVR_REFINE_CHANGE 1e-3
#define OVR_REFINE_CHANGE_MAX 0.5

typedef struct ovr_refined {
    ovr_composite composite;
    size_t maximum; /* leaves */
    double *X;      /* of the leaves */
    double *whole;  /* weights of the whole domain's nodes */
    ovr_spike_found found;
} ovr_refined;

/* Computes the mean mass flow of patches; false: there are none. */
bool ovr_refined_mean_flow(const ovr_simulation *sim, double *flow);

#endif
