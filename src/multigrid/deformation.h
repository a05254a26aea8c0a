/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elastic deformation by multilevel multi-integration (MLMI).
 *
 *     w_i = (1/pi) sum_j K_ij P_j,   K_ij = K(|i - j| D),
 *     K(d D) = D [f(d) + ln D],
 *     f(d) = (d + 1/2) ln|d + 1/2| - (d - 1/2) ln|d - 1/2| - 1
 *
 * Method (Brandt & Lubrecht 1990), with every grid split into its even and
 * odd nodes so that each stencil has unit stride:
 *  1. The kernel is smooth away from d = 0.  K from an odd node j is replaced
 *     by its interpolation of order p between even nodes, so the sum over odd
 *     j moves to the even nodes: U = (even P) + (transposed interpolation of
 *     odd P).  The sum over even nodes is the same problem at half the size,
 *     with the same kernel sampled at twice the distance.
 *  2. Even outputs: the interpolation error of the kernel is largest near
 *     d = 0 and is corrected at the odd distances up to the range m.
 *  3. Odd outputs are interpolated between even outputs, also of order p, and
 *     corrected within the range for the effective kernel of step 2.
 *  4. Repeated until few nodes are left: a dense Toeplitz sum.
 * Coarse grids carry p/2 ghost nodes at both ends (P = 0 there), so that all
 * stencils are centred.  Cost O(n), error that of the kernel's interpolation,
 * independent of P.
 */
#ifndef OVR_MULTIGRID_DEFORMATION_H
#define OVR_MULTIGRID_DEFORMATION_H

#include <stddef.h>

#include "base/arena.h"

enum { OVR_MLMI_DEPTH = 24, OVR_MLMI_MOST = 16 };

/* One coarsening: from n nodes to `coarse`. */
typedef struct ovr_mlmi_step {
    size_t n, coarse;
    double *even, *odd; /* P at the nodes 2j and 2j+1, zero outside */
    double *sum;        /* even outputs, ghosts included */
    double near_even[OVR_MLMI_MOST];    /* odd distances 1, 3, ... */
    double near_odd[2 * OVR_MLMI_MOST]; /* distances 0, 1, ..., m */
} ovr_mlmi_step;

typedef struct ovr_mlmi {
    size_t n;
    size_t half_order;            /* p/2: also the ghosts at each end */
    size_t half_range;            /* m/2 */
    int depth;                    /* coarsenings */
    double scale;                 /* D/pi */
    double weight[OVR_MLMI_MOST]; /* interpolation from +-1, +-3, ... */
    ovr_mlmi_step step[OVR_MLMI_DEPTH];
    size_t dense;   /* nodes of the last grid */
    double *kernel; /* f + ln D at d = -(dense-1) .. dense-1, and padding */
    double *values; /* P and its transfers, contiguous */
    double *output; /* results of one grid, contiguous */
} ovr_mlmi;

/* Plan for n nodes of mesh size D, order p (even, 4..12) and range m (even,
 * up to 2 OVR_MLMI_MOST). */
ovr_status ovr_mlmi_plan(ovr_mlmi *plan, size_t n, double D, int order,
                         int range, ovr_arena *arena, ovr_error *err);

/* Order and range whose error stays below `wanted` of |w|. */
void ovr_mlmi_choose(double wanted, int *order, int *range);

/* K(d D)/pi, the influence of a node on one d meshes away. */
double ovr_deformation_kernel(double d, double D);

/* w = K P/pi by direct summation, O(n^2): the reference. */
void ovr_deformation_direct(size_t n, double D, const double *P, double *w);

#endif
