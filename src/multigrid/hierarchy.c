/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/hierarchy.h"

#include <math.h>

#include "multigrid/coarsest.h"
#include "multigrid/field.h"

static ovr_status take_fields(ovr_level *level, ovr_arena *arena,
                              ovr_error *err)
{
    double *a[12];
    for (size_t k = 0; k < 12; k++)
        if (!(a[k] = ovr_field(arena, level->n, err)))
            return OVR_NO_MEMORY;
    level->f = (ovr_fields){.P = a[0],
                            .H = a[1],
                            .rho = a[2],
                            .dq = a[3],
                            .eps = a[4],
                            .deps = a[5],
                            .q = a[6],
                            .F = a[7],
                            .r = a[8]};
    level->gap = a[9];
    level->w = a[10];
    level->P_entry = a[11];
    return OVR_OK;
}

static ovr_status take_band(ovr_band *band, size_t n, ovr_arena *arena,
                            ovr_error *err)
{
    double **all[] = {&band->b[0],  &band->b[1], &band->b[2],
                      &band->b[3],  &band->b[4], &band->delta,
                      &band->minus, &band->plus, &band->moves};
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!(*all[k] = ovr_field(arena, n + OVR_BAND_PAD, err)))
            return OVR_NO_MEMORY;
    return OVR_OK;
}

static ovr_status build_level(ovr_hierarchy *grids, int number, int order,
                              int range, ovr_arena *arena, ovr_error *err)
{
    ovr_level *level = &grids->level[number];
    level->number = number;
    level->n = ovr_level_nodes(number);
    level->D = (grids->X_b - grids->X_a) / (double)(level->n - 1);
    for (int d = 0; d < 6; d++)
        level->k[d] = ovr_deformation_kernel(d, level->D);
    if (take_fields(level, arena, err))
        return OVR_NO_MEMORY;
    return ovr_mlmi_plan(&level->mlmi, level->n, level->D, order, range, arena,
                         err);
}

ovr_status ovr_hierarchy_build(ovr_hierarchy *grids, int coarsest, int finest,
                               double X_a, double X_b,
                               const int order[OVR_LEVELS],
                               const int range[OVR_LEVELS], ovr_arena *arena,
                               ovr_error *err)
{
    grids->coarsest = coarsest;
    grids->finest = finest;
    grids->X_a = X_a;
    grids->X_b = X_b;
    for (int l = coarsest; l <= finest; l++)
        if (build_level(grids, l, order[l], range[l], arena, err))
            return OVR_NO_MEMORY;
    if (take_band(&grids->band, ovr_level_nodes(finest), arena, err))
        return OVR_NO_MEMORY;
    grids->bottom = coarsest;
    return ovr_newton_prepare(grids, arena, err);
}

void ovr_hierarchy_operator(ovr_hierarchy *grids, const ovr_operator *op)
{
    grids->op = *op;
    for (int l = grids->coarsest; l <= grids->finest; l++) {
        ovr_level *level = &grids->level[l];
        level->weights = ovr_reynolds_weights(op, level->D);
        ovr_reynolds_shares(op, level->D, &level->minus, &level->plus);
    }
}

void ovr_level_film(const ovr_hierarchy *grids, ovr_level *level)
{
    const ovr_kernels *run = grids->kernels;
    run->deformation(&level->mlmi, level->f.P, level->w);
    run->film(&grids->fluid, grids->H0, level->n, level->gap, level->w,
              &level->f);
}

void ovr_level_residual(const ovr_hierarchy *grids, ovr_level *level)
{
    grids->kernels->residual(level->n, &level->weights, &level->f);
}

void ovr_level_refresh(const ovr_hierarchy *grids, ovr_level *level)
{
    ovr_level_film(grids, level);
    ovr_level_residual(grids, level);
}

double ovr_level_imbalance(const ovr_hierarchy *grids, const ovr_level *level)
{
    double sum = grids->kernels->imbalance(level->n, &level->weights,
                                           &level->f);
    return sum * level->D / fabs(ovr_level_centre(grids, level, level->f.H));
}

double ovr_level_load(const ovr_hierarchy *grids, const ovr_level *level)
{
    return level->D * grids->kernels->sum(level->n, level->f.P);
}

double ovr_level_centre(const ovr_hierarchy *grids, const ovr_level *level,
                        const double *values)
{
    double at = -grids->X_a / level->D, s;
    size_t i = (size_t)at;
    const double *v = values + i;
    s = at - (double)i;
    return -s * (s - 1) * (s - 2) / 6 * v[-1] +
           (s + 1) * (s - 1) * (s - 2) / 2 * v[0] -
           (s + 1) * s * (s - 2) / 2 * v[1] + (s + 1) * s * (s - 1) / 6 * v[2];
}
