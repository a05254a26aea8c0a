/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A steady solution with patches about its spike: the composite grids
 * (multigrid/spike.h) over the finest grid of the whole domain, and their
 * leaves as the solution that all others see. */
#ifndef OVR_SIMULATION_REFINED_H
#define OVR_SIMULATION_REFINED_H

#include "simulation/internal.h"

/* Patches need a grid that has nodes for the first of them, and memory for the
 * last. */
enum { OVR_LEAST_REFINED = 6, OVR_MOST_REFINED = 22 };

typedef struct ovr_refined {
    ovr_composite composite;
    size_t most;   /* leaves */
    double *X;     /* of the leaves */
    double *whole; /* weights of the whole domain's nodes */
    ovr_spike_found found;
} ovr_refined;

/* Memory, for options that refine; the grids are built. */
ovr_status ovr_refined_take(ovr_simulation *sim, ovr_error *err);

/* The nodes of the whole domain's finest grid alone. */
void ovr_refined_forget(ovr_simulation *sim);

/* Patches over the solution on it, until its cycles are done; then the
 * solution is that of the leaves. */
void ovr_refined_solve(ovr_simulation *sim, const ovr_full *how,
                       ovr_outcome *outcome);

/* What is observed of patches. */
void ovr_refined_observe(const ovr_simulation *sim, ovr_observation *o);

/* Mean mass flow of the patches' own fluxes where the film is wet: those of the
 * whole domain's grid are of second order, its solution of fourth. */
double ovr_refined_flow(const ovr_simulation *sim);

#endif
