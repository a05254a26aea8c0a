/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Composite grids: the whole domain's finest grid, the base, and nested
 * patches about what is narrow, each of half its parent's mesh, in the full
 * approximation scheme:
 *
 *     cycle(l): relax; restrict; cycle(l - 1); correct; relax
 *
 * down to the base, which has cycles of its own (cycle.h).  A node that is not
 * strictly inside a finer patch is a leaf; the solution is that of the leaves.
 *
 * Restriction to the parent, ' its values:
 *     P'    under the patch: full weighting where three nodes are wet, else,
 *           and within four nodes of the ends, injection
 *     gap'  under the patch injected H - H0 + w', outside rigid' less the
 *           deformation of what the patches add (below)
 *     F'    under the patch N' + full weighting of the residual, outside F0';
 *           at J*, where it ends,
 *           N' + F0' - (Phi_{J+1/2} - Phi_{J-1/2})/D'
 *           with Phi = eps dP/dX - Cu (1.5 q_i - 0.5 q_{i-1}) of the parent
 *           outside and inside the mean of the two of the patch that lie a
 *           quarter of D' on either side: what flows out of one grid flows
 *           into the other
 *     force of the base: asked for less what the patches add
 *
 * Correction: P += I (P' - P' at entry) in pressurized nodes, the edges and the
 * film by the parent's pressures as they have become.
 *
 * After Bai & Brandt's and McCormick's fast adaptive composite grids; measured
 * with dense Newton solutions on the same leaves.
 */
#ifndef OVR_MULTIGRID_COMPOSITE_H
#define OVR_MULTIGRID_COMPOSITE_H

#include "multigrid/cycle.h"
#include "multigrid/patch.h"

/*
 * The film of composite grids.
 *
 * The pressure is linear between the leaves.  So the spaces are nested: a
 * parent's pressure P', continued linearly to the patch as I P', has the same
 * deformation on both grids at common nodes, whatever P' is under the patch.
 * With K_l the kernel of level l (deformation.h) and w' = K P' the parent's
 * whole deformation, that of the patch is
 *
 *     w = o + K_l (P - I P')                           P = I P' at the edges
 *     o_{2I}   = w'_I
 *     o_{2I+1} = sum_{m<5} a_m (w'_{I-m} + w'_{I+1+m})
 *              + sum_{t<18} c_t (P'_{I-t} + P'_{I+1+t})
 *     c_t = k'(t + 1/2) - sum_m a_m [k'(t - m) + k'(t + 1 + m)]
 *
 * a_m Lagrange's weights of the midpoint, k' the parent's kernel; c_t/D' of the
 * logarithm does not depend on the level.  It is exact except for the far terms
 * of c_t, about 1e-13, in every sweep.
 *
 * Outside the patch what it adds to its parent, P - I P' and what still finer
 * patches add, V, counts as pressures V' of the parent's nodes with the same
 * moments up to the fifth (hats of half the width have others of the second):
 *
 *     X = P - I P' + V
 *     Y_I = (X_{2I} + sum_{m<4} a_m (X_{2I+2m+1} + X_{2I-2m-1}))/2
 *     V' = (1 - delta2/16 + delta4/128) Y
 *
 * and the parent's film there is that of P' + V'.
 *
 * Fourth order on the base.  The hats of its leaves have the second moments
 * of D^2/12 P'' too much (fourth_order.h), m being 1 at leaves and 0 under the
 * patch:
 *     g = K (m delta2 P/12) + m C D delta2 P
 * on the base, with C as there; in patches K's part alone, by cubic
 * interpolation of the parent's, which moves the minimum film thickness by less
 * than 1e-6 at M = 20, L = 10, base 8.
 */

enum { OVR_FILM_MIDDLE = 5, OVR_DETAIL_MIDDLE = 4 };

typedef struct ovr_composite_film {
    double near[OVR_FILM_NEAR];       /* c_t/D', of the logarithm */
    double middle[OVR_FILM_MIDDLE];   /* a_m of w */
    double detail[OVR_DETAIL_MIDDLE]; /* a_m of V */
} ovr_composite_film;

/* w of the base, or a patch, for patch->P and what it has of its parent; in
 * its level and read. */
void ovr_patch_deform(const ovr_hierarchy *grids, ovr_patch *patch);

/* g of a base with a patch, for the P it has read, and of a patch by that of
 * its parent; added to the rigid gap. */
void ovr_base_fourth(const ovr_hierarchy *grids, ovr_patch *base,
                     const ovr_patch *patch);
void ovr_patch_fourth(ovr_patch *patch, const ovr_patch *parent);

typedef struct ovr_composite {
    ovr_hierarchy *grids;
    ovr_composite_film film;
    int patches;                /* beside the base */
    ovr_patch part[OVR_LEVELS]; /* 0: the base; each the next one's parent */
    double force;               /* target load */
    double *workspace[2];       /* for the nodes of any part */
    /* Memory of patches, taken again for each solution. */
    ovr_arena memory;
    char *chunk;
    size_t size, used;
} ovr_composite;

/* Memory for `patches` patches of so many nodes at most, none with more than
 * the hierarchy's finest grid. */
ovr_status ovr_composite_prepare(ovr_composite *c, ovr_hierarchy *grids,
                                 const size_t *maximum, int patches,
                                 ovr_arena *arena, ovr_error *err);

/* No patches: the base alone, solved, its gap and F those of the solution. */
void ovr_composite_begin(ovr_composite *c, double force);

/* One more patch, of a window of the last one; its rigid gap is to be filled
 * by the caller, then ovr_composite_start gives it its first solution. */
ovr_status ovr_composite_add(ovr_composite *c, ovr_window window,
                             ovr_error *err);
void ovr_composite_start(ovr_composite *c);

/* One cycle from the last patch down. */
void ovr_composite_cycle(ovr_composite *c, const ovr_cycling *how);

/* Residual of the leaves, load, film at X = 0; leaves every grid with the film
 * of the whole solution. */
ovr_defect ovr_composite_defect(ovr_composite *c);

/* True if node i of a part is a leaf. */
bool ovr_composite_leaf(const ovr_composite *c, int part, size_t i);

#endif
