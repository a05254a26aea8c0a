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
 *           deformation of what the patches add (composite_film.h)
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

#include "multigrid/composite_film.h"
#include "multigrid/cycle.h"

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
