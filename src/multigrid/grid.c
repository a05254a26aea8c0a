/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/grid.h"

#include <math.h>

ovr_status ovr_grid_refine(ovr_grid *grid, const ovr_grid *parent,
                           ovr_window window, ovr_arena *arena, ovr_error *err)
{
    *grid = (ovr_grid){.n = 2 * window.meshes + 1,
                       .D = parent->D / 2,
                       .X_a = parent->X_a + (double)window.first * parent->D,
                       .first = window.first};
    grid->X = ovr_arena_take(arena, grid->n, sizeof *grid->X, err);
    return grid->X ? OVR_OK : OVR_NO_MEMORY;
}

double ovr_grid_mesh(const ovr_grid *grid)
{
    return grid->D;
}

void ovr_grid_fill(ovr_grid *grid)
{
    for (size_t i = 0; i < grid->n; i++)
        grid->X[i] = grid->X_a + (double)i * grid->D;
}

void ovr_grid_weights(const ovr_grid *grid, double *weights)
{
    for (size_t i = 0; i < grid->n; i++)
        weights[i] = grid->D;
    weights[0] = weights[grid->n - 1] = grid->D / 2;
}

double ovr_grid_distance(const ovr_grid *grid, const double *a, size_t stride,
                         const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < grid->n; i++)
        sum += fabs(a[stride * i] - b[i]);
    return grid->D * sum;
}
