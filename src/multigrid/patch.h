/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A patch: one of the grids of a composite (composite.h).
 *
 * The base is the finest grid of the whole domain.  A patch covers a window of
 * its parent, the base or the next larger patch, with half its mesh.  Its
 * nodes 0, 1, 2 and n-3, n-2, n-1 hold the parent's pressure (odd ones cubic)
 * and are never relaxed, so that the upstream stencils of the first unknown,
 * node 3, are those of any other; nodes 2 and n-3 lie on parent nodes J*, where
 * the patch ends for the parent.  A patch that reaches an end of the domain
 * ends there as the whole grid does.
 *
 * What kernels work on are the fields of a level, in lanes; what is one patch's
 * own is in the order of the nodes.
 */
#ifndef OVR_MULTIGRID_PATCH_H
#define OVR_MULTIGRID_PATCH_H

#include "multigrid/hierarchy.h"

enum {
    OVR_PATCH_EDGE = 2,    /* fine mesh sizes from the array's end to J* */
    OVR_PATCH_UNIT = 8,    /* parent mesh sizes: lanes without a rest */
    OVR_PATCH_MARGIN = 16, /* parent nodes to the parent's own end */
    OVR_PATCH_MIN =
        40, /* parent mesh sizes: fewer leave no space for the next */
    OVR_FILM_NEAR = 18 /* parent nodes on each side that make a middle */
};

typedef struct ovr_patch {
    ovr_level *level; /* the base's, or own */
    ovr_level own;
    size_t from, to;     /* first and last unknown */
    bool opens, closes;  /* begins, ends inside the domain */
    double *P, *q, *eps; /* of the level, as last read */
    double *flow;        /* of it, where it has one */
    double *w;           /* deformation by all pressures */
    double *entry;       /* P when the cycle came from the finer patch */
    double *rigid, *F;   /* gap and right-hand side where no patch is finer */
    double *g;           /* of rigid: fourth order (composite_film.h) */
    double *outer_w, *outer_P;  /* the parent's deformation and pressure here */
    double *detail;             /* what finer patches add, as pressures of this
                                   grid (composite_film.h) */
    double *detail_w;           /* its deformation */
    double *wide[2];            /* in lanes, with halos */
    double added;               /* D sum of P less the parent's: load */
    double near[OVR_FILM_NEAR]; /* c_t/D' of the parent (composite_film.h) */
} ovr_patch;

/* The base: memory for what it needs beside its level. */
ovr_status ovr_patch_base(ovr_hierarchy *grids, ovr_patch *base,
                          ovr_arena *arena, ovr_error *err);

/* A window of its parent, which is the patch before it in memory: memory, and
 * its numbers. */
ovr_status ovr_patch_build(const ovr_hierarchy *grids, ovr_patch *patch,
                           ovr_window window, ovr_arena *arena, ovr_error *err);
void ovr_patch_fill(const ovr_hierarchy *grids, ovr_patch *patch,
                    const ovr_patch *parent);

/* Node of the patch on the parent's node I. */
static inline size_t ovr_patch_node(const ovr_patch *patch, size_t I)
{
    return 2 * (I - patch->level->grid.first);
}

/* Parent nodes J* where the patch begins and ends for the parent; those of
 * the domain's ends where it reaches them. */
size_t ovr_patch_begin(const ovr_patch *patch);
size_t ovr_patch_end(const ovr_patch *patch);

/* P, q, eps, w and flow in the order of the nodes. */
void ovr_patch_read(const ovr_hierarchy *grids, ovr_patch *patch);

/* P, as its edges and the level's lanes have it. */
void ovr_patch_write(const ovr_hierarchy *grids, ovr_patch *patch);

/* P at the edges from the parent's. */
void ovr_patch_edges(ovr_patch *patch, const ovr_patch *parent);

/* P everywhere by cubic interpolation of the parent's. */
void ovr_patch_begin_from(ovr_patch *patch, const ovr_patch *parent);

/* Residual and phase, for film and properties as they are; edges are held. */
void ovr_patch_settle(const ovr_hierarchy *grids, ovr_patch *patch);

/* One relaxation; film and residual are up to date before, not after. */
void ovr_patch_relax(ovr_hierarchy *grids, ovr_patch *patch, double limit);

/* Mass flow at i + 1/2 by the equation's own stencil, as last read. */
/* 2 E of both half nodes beside node i. */
double ovr_patch_outflow(const ovr_patch *patch, size_t i);
double ovr_patch_flux(const ovr_hierarchy *grids, const ovr_patch *patch,
                      size_t i);

#endif
