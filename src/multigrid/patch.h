/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A patch: one of the grids of a composite (composite.h).
 *
 * The base is the finest grid of the whole domain. A patch covers a window of
 * its parent (the base or the next larger patch) with half the parent's mesh
 * size.  Its nodes 0, 1, 2 and n-3, n-2, n-1 hold the parent's pressure (odd
 * ones cubic) and are never relaxed, so that node 3, the first unknown, has the
 * same upstream stencils as other nodes; nodes 2 and n-3 lie on parent nodes
 * J*, where the patch ends for the parent.  A patch that reaches an end of the
 * domain ends there as the whole grid does.
 *
 * Kernels process the fields of a level, in lanes. Arrays of the patch itself
 * are in the order of the nodes.
 */
#ifndef OVR_MULTIGRID_PATCH_H
#define OVR_MULTIGRID_PATCH_H

#include "multigrid/hierarchy.h"

enum {
    OVR_PATCH_EDGE = 2,    /* fine mesh sizes from the array's end to J* */
    OVR_PATCH_UNIT = 8,    /* parent mesh sizes; a multiple fits the lanes */
    OVR_PATCH_MARGIN = 16, /* minimum distance from the parent's end in parent
                            * nodes */
    OVR_PATCH_MIN = 40, /* minimum length in parent mesh sizes: leaves space for
                         * the next patch */
    OVR_FILM_NEAR = 18  /* parent nodes on each side in the interpolation at
                         * midpoints */
};

typedef struct ovr_patch {
    ovr_level *level; /* the base's level, or the patch's own */
    ovr_level own;
    size_t from, to;     /* first and last unknown */
    bool opens, closes;  /* the patch begins, ends inside the domain */
    double *P, *q, *eps; /* fields of the level, as last read */
    double *flow;        /* flow of the level; NULL: not stored */
    double *w;           /* deformation by the pressures of all grids */
    double *entry;       /* P at the time of restriction from the finer patch */
    double *rigid, *F;   /* gap and right-hand side without a finer patch */
    double *g;           /* fourth-order part of rigid (composite.h) */
    double *outer_w, *outer_P;  /* deformation and pressure of the parent at
                                 * these nodes */
    double *detail;             /* contribution of finer patches, as pressures
                                 * at this grid's nodes (composite.h) */
    double *detail_w;           /* deformation by `detail` */
    double *wide[2];            /* in lanes, with halos */
    double added;               /* load added to the parent's: difference of D
                                 * sum P */
    double near[OVR_FILM_NEAR]; /* c_t/D' of the parent (composite.h) */
} ovr_patch;

/* Allocates the arrays of the base that its level does not have. */
ovr_status ovr_patch_base(ovr_hierarchy *grids, ovr_patch *base,
                          ovr_arena *arena, ovr_error *err);

/* Creates the patch for a window of its parent, which precedes the patch in
 * memory: allocates it and computes its numbers. */
ovr_status ovr_patch_build(const ovr_hierarchy *grids, ovr_patch *patch,
                           ovr_window window, ovr_arena *arena, ovr_error *err);
void ovr_patch_fill(const ovr_hierarchy *grids, ovr_patch *patch,
                    const ovr_patch *parent);

/* Node of the patch at the position of the parent's node I. */
static inline size_t ovr_patch_node(const ovr_patch *patch, size_t I)
{
    return 2 * (I - patch->level->grid.first);
}

/* Parent nodes J* where the patch begins and ends for the parent, or the
 * parent's end nodes if the patch extends to the end of the domain. */
size_t ovr_patch_begin(const ovr_patch *patch);
size_t ovr_patch_end(const ovr_patch *patch);

/* Copies P, q, eps, w and flow from the level, to the order of the nodes. */
void ovr_patch_read(const ovr_hierarchy *grids, ovr_patch *patch);

/* Copies P to the level's lanes, with its edges. */
void ovr_patch_write(const ovr_hierarchy *grids, ovr_patch *patch);

/* Sets P at the edges from the parent's P. */
void ovr_patch_edges(ovr_patch *patch, const ovr_patch *parent);

/* Sets P at all nodes by cubic interpolation of the parent's P. */
void ovr_patch_begin_from(ovr_patch *patch, const ovr_patch *parent);

/* Computes residual and phase from the present film and properties; the edges
 * are constrained. */
void ovr_patch_settle(const ovr_hierarchy *grids, ovr_patch *patch);

/* One relaxation sweep. Film and residual must be up to date before, and are
 * out of date after it. */
void ovr_patch_relax(ovr_hierarchy *grids, ovr_patch *patch, double limit);

/* Mass flow rate at i + 1/2 by the stencil of the discrete equation, from the
 * values last read. */
/* Sum of 2 E at both half nodes next to node i. */
double ovr_patch_outflow(const ovr_patch *patch, size_t i);
double ovr_patch_flux(const ovr_hierarchy *grids, const ovr_patch *patch,
                      size_t i);

#endif
