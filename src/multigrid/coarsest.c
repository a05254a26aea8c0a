/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/coarsest.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"

#include "multigrid/reynolds_row.h"

/* K/pi of a level is known at distances -(n + 1) .. n + 2, 0 at index n + 2. */
static size_t distances(const ovr_level *level)
{
    return 2 * level->grid.n + 5;
}

/* The levels solved by Newton's method: the coarsest and the next. */
static const ovr_level *newton_level(const ovr_hierarchy *grids, int k)
{
    bool single = grids->coarsest == grids->finest;
    return &grids->level[grids->coarsest + (k && !single)];
}

/* Values of a row: n + 1 unknowns, the right-hand side, whole vectors. */
static size_t stride_of(size_t n)
{
    return (n + 2 + 14) / 8 * 8;
}

ovr_status ovr_newton_prepare(ovr_hierarchy *grids, ovr_arena *arena,
                              ovr_error *err)
{
    const ovr_level *level = newton_level(grids, 1);
    ovr_newton *newton = &grids->newton;
    size_t m = level->grid.n + 1;
    newton->matrix = ovr_field(arena, m * stride_of(level->grid.n), err);
    newton->change = ovr_field(arena, m, err);
    for (int k = 0; k < 2; k++)
        newton->kernel[k] = ovr_field(arena, distances(newton_level(grids, k)),
                                      err);
    if (!newton->matrix || !newton->change || !newton->kernel[0] ||
        !newton->kernel[1])
        return OVR_NO_MEMORY;
    return OVR_OK;
}

void ovr_newton_fill(ovr_hierarchy *grids)
{
    for (int k = 0; k < 2; k++) {
        const ovr_level *level = newton_level(grids, k);
        for (size_t d = 0; d < distances(level); d++)
            grids->newton.kernel[k][d] = ovr_deformation_kernel(
                (double)d - (double)(level->grid.n + 2), level->grid.D);
    }
}

/* Row i of the Jacobian: elastic terms through dH at i-2..i+1, then the local
 * ones; the last column is dN_i/dH0. */
static void jacobian_row(const ovr_hierarchy *grids, const ovr_level *level,
                         const ovr_fields *f, size_t i, double *row)
{
    const ovr_weights *w = &level->weights;
    row_weights c = i == 1 ? row_first(w, f->flow) : row_inner(w, f->flow);
    size_t n = level->grid.n;
    ptrdiff_t J = (ptrdiff_t)i;
    /* dH_{i+d}/dP_j = -k(j - i - d) for d = -2, -1, 0, 1 */
    const double *k = grids->newton.kernel[level->number - grids->coarsest] +
                      n + 2 - i; /* k[j] = k(j - i) */
    double e[4] = {0}, local[4] = {0};
    row_by_film(f, &c, J, e);
    row_flow_by_film(f, &c, J, e);
    row_by_pressure(f, &c, J, local);
    grids->kernels->dense_row(n, e, k, row);
    for (size_t d = i == 1; d < 4; d++)
        row[i + d - 2] += local[d];
    row[n] = -(e[0] + e[1] + e[2] + e[3]);
}

static void hold(size_t n, size_t i, double *row)
{
    memset(row, 0, (n + 2) * sizeof *row);
    row[i] = 1;
}

/* Rows 0..n-1 pressures, row n the force; right-hand side in column n + 1. */
static void assemble(const ovr_hierarchy *grids, const ovr_level *level,
                     const ovr_fields *f)
{
    size_t n = level->grid.n, stride = stride_of(n);
    double *row = grids->newton.matrix;
    for (size_t i = 0; i < n; i++, row += stride) {
        bool end = i == 0 || i == n - 1;
        if (end || ovr_lanes_has(&level->lanes, level->f.held, i)) {
            hold(n, i, row);
            continue;
        }
        jacobian_row(grids, level, f, i, row);
        row[n + 1] = f->r[i];
    }
    for (size_t j = 0; j < n; j++)
        row[j] = level->grid.D;
    row[n] = 0;
    row[n + 1] = level->force - ovr_level_load(grids, level);
}

static double clipped(double x, double limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

bool ovr_newton_step(ovr_hierarchy *grids, ovr_level *level, double limit)
{
    const ovr_newton *newton = &grids->newton;
    const ovr_fields *f;
    size_t n = level->grid.n;
    double H;
    ovr_level_residual(grids, level);
    f = ovr_level_ordered(grids, level);
    assemble(grids, level, f);
    if (!grids->kernels->dense_solve(n + 1, stride_of(n), newton->matrix,
                                     newton->change))
        return false;
    for (size_t i = 1; i < n - 1; i++) {
        double P = f->P[i] + clipped(newton->change[i], limit);
        f->P[i] = P > 0 ? P : 0;
    }
    ovr_level_write(grids, level, f->P, level->f.P);
    /* in proportion where the film is thick: rigid contacts */
    H = fabs(ovr_level_centre(level, level->f.H));
    grids->H0 += clipped(newton->change[n], limit * 2 / 3 * (H > 1 ? H : 1));
    return isfinite(grids->H0);
}
