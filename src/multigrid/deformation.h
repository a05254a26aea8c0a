/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elastic deformation by multilevel multi-integration (MLMI).
 *
 *     w_i = (1/pi) sum_j K_ij P_j,   K_ij = K(|i - j| D),
 *     K(d D) = D [f(d) + ln D],
 *     f(d) = (d + 1/2) ln|d + 1/2| - (d - 1/2) ln|d - 1/2| - 1
 *
 * for a pressure that is constant around each node. For a pressure that is
 * linear between nodes, as on composite grids (composite.h),
 *     f(d) = g(d + 1) - 2 g(d) + g(d - 1),  g(d) = d^2/2 ln|d| - 3/4 d^2
 *
 * Method (Brandt & Lubrecht 1990):
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
 * The interpolation weights minimize the maximum error beyond the range for
 * this kernel. Lagrange's weights, which are optimal at infinite distance,
 * would need a longer range for the same error.  Coarse grids carry ghost nodes
 * at both ends (P = 0 there), so that all stencils are centred. The cost is
 * O(n). The error is that of the kernel's interpolation and does not depend on
 * P.
 */
#ifndef OVR_MULTIGRID_DEFORMATION_H
#define OVR_MULTIGRID_DEFORMATION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Computes the weights at distances 1, 3, ..., 2h - 1 on either side for
 * interpolating the kernel beyond the range. Lagrange's weights if 2h > range
 * or h > 6. */
void ovr_mlmi_weights(size_t h, size_t range, double weight[]);

/* Computes the same weights by fitting, even if they are tabulated. */
void ovr_mlmi_fit_weights(size_t h, size_t range, double weight[]);

/* BLOCK: maximum number of vectors that the kernel computes together */
enum { OVR_MLMI_DEPTH = 24, OVR_MLMI_MAX = 16, OVR_MLMI_BLOCK = 8 };

/* A part of the influence in addition to the logarithmic kernel: dw_i/dP_j for
 * nodes a distance X apart and mesh size D, smooth beyond the range of the
 * corrections. For a pressure that is linear between nodes the same function is
 * used unless another one is given. `wave`: ratio of w to that of the
 * logarithmic kernel for a pressure e^(ikX). If unknown, there are no
 * fourth-order corrections. */
typedef struct ovr_influence_part {
    double (*at)(const void *data, double X, double D);
    const void *data;
    double (*linear)(const void *data, double X, double D);
    double (*wave)(const void *data, double k);
} ovr_influence_part;

static inline double ovr_influence_part_at(const ovr_influence_part *part,
                                           double X, double D, bool linear)
{
    return linear && part->linear ? part->linear(part->data, X, D)
                                  : part->at(part->data, X, D);
}

/* One grid of the integral transform; grid 0 is the caller's, with u = P and
 * out = w. */
typedef struct ovr_mlmi_grid {
    double *u;             /* P restricted to this grid */
    double *out;           /* results */
    ptrdiff_t left, right; /* number of ghost nodes before the first node, and
                            * after it including the nodes */
    double *near_even;     /* OVR_MLMI_MAX, of odd distances 1, 3, ... */
    double *near_odd;      /* twice that and 1, of distances 0, 1, ..., m */
} ovr_mlmi_grid;

typedef struct ovr_mlmi {
    size_t n;
    bool linear; /* P is linear between the nodes; set before the fill */
    const ovr_influence_part *part; /* added to the logarithmic kernel; NULL:
                                     * none */
    int parts;
    double D;
    ptrdiff_t half_order;        /* p/2 */
    ptrdiff_t range;             /* m */
    int depth;                   /* number of coarsenings */
    ptrdiff_t pad;               /* vectors reserved before and after P and w */
    double weight[OVR_MLMI_MAX]; /* interpolation from +-1, +-3, ... */
    ovr_mlmi_grid grid[OVR_MLMI_DEPTH + 1];
    double *kernel;           /* kernel of the dense sum, D/pi (f + ln D) */
    double *natural, *result; /* coarsest grid in the order of the nodes */
} ovr_mlmi;

/* Nodes per lane for this number of lanes. The lanes hold at least n - 1 nodes,
 * and a lane can be halved `depth` times. */
static inline size_t ovr_mlmi_lane(const ovr_mlmi *plan, size_t lanes)
{
    size_t share = (plan->n - 2 + lanes) / lanes,
           unit = (size_t)1 << plan->depth;
    return (share + unit - 1) / unit * unit;
}

/* Order p (even, 2..16) and range m (even, up to 2 OVR_MLMI_MAX). */
typedef struct ovr_mlmi_form {
    int order, range;
} ovr_mlmi_form;

/* Allocates a plan for n nodes. */
ovr_status ovr_mlmi_plan(ovr_mlmi *plan, size_t n, ovr_mlmi_form form,
                         ovr_arena *arena, ovr_error *err);

/* Computes the numbers of a plan for mesh size D. The weights take a
 * millisecond to compute; they are copied from `like` (a plan or NULL) if order
 * and range are the same. */
void ovr_mlmi_fill(ovr_mlmi *plan, double D, const ovr_mlmi *like);

/* Allocates an array for P or w, arranged in lanes for any machine, with its
 * halos. */
double *ovr_mlmi_field(const ovr_mlmi *plan, ovr_arena *arena, ovr_error *err);

/* Returns order and range for which the error is below `target` times |w|. */
ovr_mlmi_form ovr_mlmi_choose(double target);

/* K(d D)/pi, the deformation at a distance of d mesh sizes from a node with P =
 * 1. */
double ovr_deformation_kernel(double d, double D);

/* Deformation by a pressure that is linear between the nodes. */
double ovr_deformation_linear(double d, double D);

#endif
