/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elastic deformation by multilevel multi-integration (MLMI).
 *
 *     w_i = (1/pi) sum_j K_ij P_j,   K_ij = K(|i - j| D),
 *     K(d D) = D [f(d) + ln D],
 *     f(d) = (d + 1/2) ln|d + 1/2| - (d - 1/2) ln|d - 1/2| - 1
 *
 * for a pressure that is constant about each node.  Where it is linear between
 * them, on composite grids (composite.h),
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
 * The weights of the interpolation are those whose largest error beyond the
 * range is least for this kernel, not Lagrange's, which are best infinitely
 * far away: the same error from a shorter range.  Coarse grids carry ghost
 * nodes at both ends (P = 0 there), so that all stencils are centred.  Cost
 * O(n), error that of the kernel's interpolation, independent of P.
 */
#ifndef OVR_MULTIGRID_DEFORMATION_H
#define OVR_MULTIGRID_DEFORMATION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Weights at the distances 1, 3, ..., 2h - 1 to either side for interpolating
 * the kernel beyond the range.  Lagrange's for 2h > range or h > 6. */
void ovr_mlmi_weights(size_t h, size_t range, double weight[]);

/* The same by the fit itself, also where a table has its result. */
void ovr_mlmi_fit_weights(size_t h, size_t range, double weight[]);

/* BLOCK: vectors that the kernel makes in one go, at most */
enum { OVR_MLMI_DEPTH = 24, OVR_MLMI_MAX = 16, OVR_MLMI_BLOCK = 8 };

/* A part of the influence beside the logarithm: dw_i/dP_j of nodes X apart on a
 * mesh D, smooth beyond the range of the corrections; where the pressure is
 * linear between the nodes, the same unless it says otherwise.  Of a wave
 * e^(ikX) its w over that of the logarithm; where that is not known there are
 * no corrections to fourth order. */
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

/* One grid of the transfers; grid 0 is the caller's, u = P and out = w. */
typedef struct ovr_mlmi_grid {
    double *u;             /* transfers of P */
    double *out;           /* results */
    ptrdiff_t left, right; /* ghost nodes before the first and from the last */
    double *near_even;     /* OVR_MLMI_MAX, of odd distances 1, 3, ... */
    double *near_odd;      /* twice that and 1, of distances 0, 1, ..., m */
} ovr_mlmi_grid;

typedef struct ovr_mlmi {
    size_t n;
    bool linear; /* P between the nodes; set before the fill */
    const ovr_influence_part *part; /* beside the logarithm, as well */
    int parts;
    double D;
    ptrdiff_t half_order;        /* p/2 */
    ptrdiff_t range;             /* m */
    int depth;                   /* coarsenings */
    ptrdiff_t pad;               /* vectors before and after P and w */
    double weight[OVR_MLMI_MAX]; /* interpolation from +-1, +-3, ... */
    ovr_mlmi_grid grid[OVR_MLMI_DEPTH + 1];
    double *kernel;           /* of the dense sum, D/pi (f + ln D) */
    double *natural, *result; /* the coarsest grid in order */
} ovr_mlmi;

/* Nodes a lane when the grid is cut into this many; the lanes hold at least
 * n - 1 nodes and can be halved `depth` times. */
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

/* Memory of a plan for n nodes. */
ovr_status ovr_mlmi_plan(ovr_mlmi *plan, size_t n, ovr_mlmi_form form,
                         ovr_arena *arena, ovr_error *err);

/* Its numbers, for mesh size D.  The weights take a millisecond to find: those
 * of `like`, a plan or NULL, are taken over if they are of the same order and
 * range. */
void ovr_mlmi_fill(ovr_mlmi *plan, double D, const ovr_mlmi *like);

/* An array for P or w of a plan: in lanes for any machine, with space for its
 * halos. */
double *ovr_mlmi_field(const ovr_mlmi *plan, ovr_arena *arena, ovr_error *err);

/* Order and range whose error stays below `target` of |w|. */
ovr_mlmi_form ovr_mlmi_choose(double target);

/* K(d D)/pi, the influence of a node on one d mesh sizes away. */
double ovr_deformation_kernel(double d, double D);

/* The same of a pressure that is linear between the nodes. */
double ovr_deformation_linear(double d, double D);

/* w = K P/pi by direct summation, O(n^2): the reference. */
void ovr_deformation_direct(size_t n, double D, const double *P, double *w);

#endif
