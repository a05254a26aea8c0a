/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A grid: nodes X_i = X_a + i D, i = 0..n-1.
 *
 * It covers the whole domain or a window of its parent, the next coarser grid:
 * its node 2 k lies on the parent's node first + k.
 */
#ifndef OVR_MULTIGRID_GRID_H
#define OVR_MULTIGRID_GRID_H

#include "base/arena.h"

typedef struct ovr_grid {
    size_t n;
    double D;     /* mesh size */
    double X_a;   /* of node 0 */
    double *X;    /* of all nodes, after ovr_grid_fill */
    size_t first; /* node of the parent where node 0 lies */
} ovr_grid;

/* Part of a parent: so many mesh sizes from its node `first` on. */
typedef struct ovr_window {
    size_t first, meshes;
} ovr_window;

/* A window of the parent with half its mesh size. */
ovr_status ovr_grid_refine(ovr_grid *grid, const ovr_grid *parent,
                           ovr_window window, ovr_arena *arena, ovr_error *err);

void ovr_grid_fill(ovr_grid *grid);

/* The smallest mesh: what floors above ask for in place of D. */
double ovr_grid_mesh(const ovr_grid *grid);

/* Weights of the trapezoidal rule. */
void ovr_grid_weights(const ovr_grid *grid, double *weights);

/* Integral of |a - b| over the grid, a at every so many of its values; both
 * zero at the ends. */
double ovr_grid_distance(const ovr_grid *grid, const double *a, size_t stride,
                         const double *b);

/* Nodes of a grid over the whole domain in the paper's numbering. */
static inline size_t ovr_level_nodes(int number)
{
    return ((size_t)7 << number) + 1;
}

#endif
