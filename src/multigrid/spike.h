/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Patches around the pressure spike: full multigrid, starting on a solved base.
 *
 * The next patch is centred at the spike of the present solution and extends 24
 * to 96 parent mesh sizes to each side. The first three patches also include
 * the film rupture (with two the minimum film thickness is off by 3e-6 at M =
 * 20, L = 10, base 8, with three by 1e-6).  The spike is the highest local
 * maximum of the nodal pressures at X > 0.3, or the point of largest curvature
 * if there is no maximum. Each new patch starts from cubic interpolation and
 * gets one cycle, until the target level is reached or the spike height has
 * changed by less than `change` on two consecutive levels (one could be
 * accidental). Then cycles are performed until the tolerance is reached.
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
    int level;     /* level of the finest patch, or of the base grid if no patch
                      fits */
    double D;      /* mesh size of the finest patch */
    double P, X;   /* height (nodal value; NAN without a maximum) and position
                    */
    double change; /* relative change of P from the next coarser level; NAN:
                    * unknown */
    ovr_defect defect;
} ovr_spike_found;

/* Maximum number of nodes of the k-th patch (k = 1, 2, ...) on a base. */
size_t ovr_spike_max(int k, double half, const ovr_grid *base);

/* Computes the patches from the present base. Adds to the number of cycles. */
ovr_status ovr_spike_solve(ovr_composite *c, const ovr_spike_search *how,
                           ovr_spike_found *found, int *cycles, ovr_error *err);

#endif
