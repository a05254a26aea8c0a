/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady solution with patches around the pressure spike: composite grids
 * (multigrid/spike.h) over the finest grid of the whole domain, whose leaves
 * are the nodes of the solution. */
#ifndef OVR_SIMULATION_REFINED_H
#define OVR_SIMULATION_REFINED_H

#include "simulation/internal.h"

/* Range of levels: the grid must have enough nodes for the first patch, and
 * there is memory up to the last level. */
enum { OVR_MIN_REFINED = 6, OVR_MAX_REFINED = 22 };

/* Relative change of the spike height per patch at which refinement stops:
 * default, and maximum. */
#define OVR_REFINE_CHANGE 1e-3
#define OVR_REFINE_CHANGE_MAX 0.5

typedef struct ovr_refined {
    ovr_composite composite;
    size_t maximum; /* maximum number of leaves */
    double *X;      /* positions of the leaves */
    double *whole;  /* integration weights of the nodes of the whole domain */
    ovr_spike_found found;
} ovr_refined;

/* Computes the mean mass flow with patches. Returns false if there are none. */
bool ovr_refined_mean_flow(const ovr_simulation *sim, double *flow);

#endif
