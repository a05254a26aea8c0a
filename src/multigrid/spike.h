/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Patches about the pressure spike: full multigrid from a solved base up.
 *
 * The next patch is laid about the spike of the solution so far, some 24 to 96
 * mesh sizes of its parent to each side, the first three to behind the rupture
 * of the film as well (with two the minimum film thickness is off by 3e-6 at M
 * = 20, L = 10, base 8, with three by 1e-6).  The spike is the highest local
 * maximum of P at X > 0.3, of nodes; where there is none, the sharpest bend.
 * One cycle a patch, from cubic interpolation, until the target level is
 * reached, or the height of the spike has changed less than was asked for on
 * two levels running (once may be by chance); then cycles to the tolerance.
 */
#ifndef OVR_MULTIGRID_SPIKE_H
#define OVR_MULTIGRID_SPIKE_H

#include "multigrid/composite.h"

typedef struct ovr_spike_search {
    ovr_cycling cycling;
    int level;        /* maximum level */
    double change;    /* relative change of the spike height at which refinement
                         stops; 0: refine up to `level` */
    double half;      /* half-width of a patch in mesh sizes of its parent */
    double tolerance; /* tolerance of the residual on the finest nodes */
    int max_cycles;   /* maximum number of cycles on the finest patch */
    bool fourth;      /* the solution on the base grid is of fourth order */
    /* X^2/2 - S at the n nodes X */
    void (*rigid)(void *data, size_t n, const double *X, double *gap);
    void *data;
} ovr_spike_search;

typedef struct ovr_spike_found {
    int level;     /* of the finest patch; the base's where none fits */
    double D;      /* its mesh */
    double P, X;   /* height, at a node: NAN without a maximum; place */
    double change; /* relative, of P from the level below; NAN */
    ovr_defect defect;
} ovr_spike_found;

/* Nodes of the k-th patch at most (k = 1, 2, ...) over a base. */
size_t ovr_spike_max(int k, double half, const ovr_grid *base);

/* From the base as it is; adds to the number of cycles. */
ovr_status ovr_spike_solve(ovr_composite *c, const ovr_spike_search *how,
                           ovr_spike_found *found, int *cycles, ovr_error *err);

#endif
