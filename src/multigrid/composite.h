/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Composite grids: the finest grid of the whole domain (the base) and nested
 * patches around narrow regions. A patch has half the mesh size of its parent.
 * The full approximation scheme couples the grids:
 *
 *     cycle(l): relax; restrict; cycle(l - 1); correct; relax
 *
 * down to the base, which is solved by ordinary cycles (cycle.h). A node that
 * is not strictly inside a finer patch is a leaf; the solution consists of the
 * values at the leaves.
 *
 * Restriction to the parent, whose values have a prime:
 *     P'    under the patch: full weighting where three nodes are pressurized;
 *           injection elsewhere and within four nodes of the ends
 *     gap'  under the patch: injected H - H0 + w'; outside: rigid' less the
 *           deformation by the additional pressure of the patches (below)
 *     F'    under the patch: N' + full weighting of the residual; outside: F0';
 *           at J*, where the patch ends,
 *           N' + F0' - (Phi_{J+1/2} - Phi_{J-1/2})/D'
 *           with the mass flow Phi = eps dP/dX - Cu (1.5 q_i - 0.5 q_{i-1}).
 *           On the outer side Phi is that of the parent, on the inner side the
 *           mean of two values of the patch, D'/4 to either side. Thus the
 *           flow out of one grid equals the flow into the other.
 *     force of the base: required force less the additional force of the
 * patches
 *
 * Correction: P += I (P' - P' at entry) in pressurized nodes. The edges of the
 * patch and its film follow from the corrected pressures of the parent.
 *
 * After Bai & Brandt's and McCormick's fast adaptive composite grids; compared
 * with dense Newton solutions on the same leaves.
 */
#ifndef OVR_MULTIGRID_COMPOSITE_H
#define OVR_MULTIGRID_COMPOSITE_H

#include "multigrid/cycle.h"
#include "multigrid/patch.h"

/*
 * Film thickness on composite grids.
 *
 * The pressure is linear between the leaves.  The function spaces are therefore
 * nested: a parent's pressure P', continued linearly to the patch as I P', has
 * the same deformation on both grids at common nodes, whatever P' is under the
 * patch. With K_l the kernel of level l (deformation.h) and w' = K P' the
 * parent's whole deformation, the deformation of the patch is
 *
 *     w = o + K_l (P - I P')                           P = I P' at the edges
 *     o_{2I}   = w'_I
 *     o_{2I+1} = sum_{m<5} a_m (w'_{I-m} + w'_{I+1+m})
 *              + sum_{t<18} c_t (P'_{I-t} + P'_{I+1+t})
 *     c_t = k'(t + 1/2) - sum_m a_m [k'(t - m) + k'(t + 1 + m)]
 *
 * a_m are Lagrange's interpolation weights for the midpoint and k' is the
 * parent's kernel; for the logarithmic kernel c_t/D' does not depend on the
 * level. The formula is exact in every sweep, except for the neglected far
 * terms of c_t (about 1e-13).
 *
 * Outside the patch, its contribution P - I P' and the contribution V of still
 * finer patches are represented by pressures V' at the parent's nodes with the
 * same moments up to the fifth. (Hat functions of half the width have other
 * second moments.)
 *
 *     X = P - I P' + V
 *     Y_I = (X_{2I} + sum_{m<4} a_m (X_{2I+2m+1} + X_{2I-2m-1}))/2
 *     V' = (1 - delta2/16 + delta4/128) Y
 *
 * and the parent's film thickness there is computed from P' + V'.
 *
 * Fourth order on the base. The second moments of the hat functions at its
 * leaves are too large by those of D^2/12 P'' (fourth_order.h). With m = 1 at
 * leaves and m = 0 under the patch, the correction is
 *     g = K (m delta2 P/12) + m C D delta2 P
 * on the base, with C as there; in patches K's part alone, by cubic
 * interpolation of the parent's, which moves the minimum film thickness by less
 * than 1e-6 at M = 20, L = 10, base 8.
 */

enum { OVR_FILM_MIDDLE = 5, OVR_DETAIL_MIDDLE = 4 };

typedef struct ovr_composite_film {
    double near[OVR_FILM_NEAR];       /* c_t/D' of the logarithmic kernel */
    double middle[OVR_FILM_MIDDLE];   /* a_m for interpolating w */
    double detail[OVR_DETAIL_MIDDLE]; /* a_m for computing V' */
} ovr_composite_film;

/* Computes w of the base or of a patch from patch->P and from the parent's
 * values. Writes w to the level and to the patch's arrays. */
void ovr_patch_deform(const ovr_hierarchy *grids, ovr_patch *patch);

/* Computes the correction g for the P that has been read: of a base that has a
 * patch, or of a patch by interpolating its parent's. Adds g to the rigid gap.
 */
void ovr_base_fourth(const ovr_hierarchy *grids, ovr_patch *base,
                     const ovr_patch *patch);
void ovr_patch_fourth(ovr_patch *patch, const ovr_patch *parent);

typedef struct ovr_composite {
    ovr_hierarchy *grids;
    ovr_composite_film film;
    int patches;                /* number of patches, without the base */
    ovr_patch part[OVR_LEVELS]; /* part[0] is the base; part[k] is the parent of
                                 * part[k + 1] */
    double force;               /* required load */
    double *workspace[2];       /* for the nodes of any part */
    /* memory of patches, reused for each solution */
    ovr_arena memory;
    char *chunk;
    size_t size, used;
} ovr_composite;

/* Allocates memory for `patches` patches; patch k has at most maximum[k] nodes,
 * not more than the hierarchy's finest grid. */
ovr_status ovr_composite_prepare(ovr_composite *c, ovr_hierarchy *grids,
                                 const size_t *maximum, int patches,
                                 ovr_arena *arena, ovr_error *err);

/* Starts without patches, from the solved base: its gap and F are those of the
 * solution. */
void ovr_composite_begin(ovr_composite *c, double force);

/* Adds a patch that covers a window of the last patch. The caller fills the
 * patch's rigid gap and then calls ovr_composite_start, which interpolates the
 * first solution. */
ovr_status ovr_composite_add(ovr_composite *c, ovr_window window,
                             ovr_error *err);
void ovr_composite_start(ovr_composite *c);

/* Performs one cycle, starting on the last patch. */
void ovr_composite_cycle(ovr_composite *c, const ovr_cycling *how);

/* Returns residual of the leaves, load error and H at X = 0. Afterwards the
 * film on every grid is that of the whole solution. */
ovr_defect ovr_composite_defect(ovr_composite *c);

/* True if node i of a part is a leaf. */
bool ovr_composite_leaf(const ovr_composite *c, int part, size_t i);

#endif
