/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/patch.h"

#include <math.h>
#include <string.h>

#include "multigrid/content.h"
#include "multigrid/field.h"

/* ------------------------------------------------------------------ memory */

static ovr_status allocate(ovr_patch *p, ovr_arena *arena, ovr_error *err)
{
    size_t capacity = p->level->grid.n + OVR_MAX_LANES;
    OVR_TAKE_FIELDS(arena, capacity, err, &p->P, &p->q, &p->eps, &p->flow,
                    &p->w, &p->entry, &p->rigid, &p->F, &p->g, &p->outer_w,
                    &p->outer_P, &p->detail, &p->detail_w);
    for (int k = 0; k < 2; k++)
        p->wide[k] = ovr_mlmi_field(&p->level->mlmi, arena, err);
    return ovr_arena_status(arena);
}

ovr_status ovr_patch_base(ovr_hierarchy *grids, ovr_patch *base,
                          ovr_arena *arena, ovr_error *err)
{
    *base = (ovr_patch){.level = &grids->level[grids->finest], .from = 1};
    base->to = base->level->grid.n - 2;
    return allocate(base, arena, err);
}

ovr_status ovr_patch_build(const ovr_hierarchy *grids, ovr_patch *patch,
                           ovr_window window, ovr_arena *arena, ovr_error *err)
{
    const ovr_level *parent = patch[-1].level;
    const ovr_grid *outer = &parent->grid;
    *patch = (ovr_patch){.level = &patch->own};
    ovr_level *level = &patch->own;
    patch->opens = window.first > 0;
    patch->closes = window.first + window.meshes < outer->n - 1;
    ovr_grid_refine(&level->grid, outer, window, arena, err);
    patch->from = patch->opens ? OVR_PATCH_EDGE + 1 : 1;
    patch->to = level->grid.n - 2 - (patch->closes ? OVR_PATCH_EDGE : 0);
    level->number = parent->number + 1;
    const ovr_mlmi_form mlmi = {2 * (int)parent->mlmi.half_order,
                                (int)parent->mlmi.range};
    ovr_level_build(grids, level, mlmi, arena, err);
    return allocate(patch, arena, err);
}

void ovr_patch_fill(const ovr_hierarchy *grids, ovr_patch *patch,
                    const ovr_patch *parent)
{
    ovr_level *level = patch->level;
    ovr_level_fill(grids, level, parent->level);
    ovr_level_operator(&grids->op, level);
    if (patch->opens) /* one more node is needed for the upstream stencil */
        memcpy(level->weights.first, level->weights.a,
               sizeof level->weights.first);
}

/* --------------------------------------------------------------- geometry */

size_t ovr_patch_begin(const ovr_patch *patch)
{
    return patch->level->grid.first + (patch->opens ? OVR_PATCH_EDGE / 2 : 0);
}

size_t ovr_patch_end(const ovr_patch *patch)
{
    return patch->level->grid.first + (patch->level->grid.n - 1) / 2 -
           (patch->closes ? OVR_PATCH_EDGE / 2 : 0);
}

/* ------------------------------------------------------------------ values */

void ovr_patch_read(const ovr_hierarchy *grids, ovr_patch *patch)
{
    const ovr_level *level = patch->level;
    ovr_level_read(grids, level, level->f.P, patch->P);
    ovr_level_read(grids, level, level->f.q, patch->q);
    ovr_level_read(grids, level, level->f.eps, patch->eps);
    ovr_level_read(grids, level, level->f.w, patch->w);
    if (level->f.flow)
        ovr_level_read(grids, level, level->f.flow, patch->flow);
}

/* 2 E at i + 1/2 */
static double through(const ovr_patch *patch, size_t i)
{
    return patch->level->f.flow ? patch->flow[i]
                                : patch->eps[i] + patch->eps[i + 1];
}

double ovr_patch_outflow(const ovr_patch *patch, size_t i)
{
    const double *eps = patch->eps + i;
    if (patch->level->f.flow)
        return patch->flow[i - 1] + patch->flow[i];
    return eps[-1] + 2 * eps[0] + eps[1];
}

void ovr_patch_write(const ovr_hierarchy *grids, ovr_patch *patch)
{
    ovr_level_write(grids, patch->level, patch->P, patch->level->f.P);
}

/* The parent's P at node i of the patch. */
static double outer_at(const ovr_patch *patch, const double *P, size_t i)
{
    const double *at = P + patch->level->grid.first + i / 2;
    if (i % 2 == 0)
        return *at;
    return fmax(0, (9 * (at[0] + at[1]) - at[-1] - at[2]) / 16);
}

void ovr_patch_edges(ovr_patch *patch, const ovr_patch *parent)
{
    size_t n = patch->level->grid.n;
    for (size_t i = 0; i < patch->from; i++)
        patch->P[i] = outer_at(patch, parent->P, i);
    for (size_t i = patch->to + 1; i < n; i++)
        patch->P[i] = outer_at(patch, parent->P, i);
}

void ovr_patch_begin_from(ovr_patch *patch, const ovr_patch *parent)
{
    for (size_t i = 0; i < patch->level->grid.n; i++)
        patch->P[i] = outer_at(patch, parent->P, i);
}

/* -------------------------------------------------------------- relaxation */

static void hold(ovr_level *level, size_t i)
{
    level->f.r[ovr_lanes_place(&level->lanes, i)] = 0;
    ovr_content_mark(level, level->f.held, i, true);
}

void ovr_patch_settle(const ovr_hierarchy *grids, ovr_patch *patch)
{
    ovr_level *level = patch->level;
    ovr_level_residual(grids, level);
    for (size_t i = 1; i < patch->from; i++)
        hold(level, i);
    for (size_t i = patch->to + 1; i + 1 < level->grid.n; i++)
        hold(level, i);
}

/* The change of the first unknown is not distributed, as at node 1 of a whole
 * grid. */
void ovr_patch_relax(ovr_hierarchy *grids, ovr_patch *patch, double limit)
{
    const ovr_kernels *run = grids->kernels;
    ovr_level *level = patch->level;
    if (patch->opens)
        ovr_content_mark(level, level->f.wet, patch->from, false);
    run->band_assemble(&level->lanes, &level->weights, level->k, &level->shares,
                       &level->f, &grids->band);
    run->band_solve(&level->lanes, &grids->band);
    run->distribute(&level->lanes, limit, &level->shares, &grids->band,
                    &level->f);
    double *P = level->f.P, ends[2] = {patch->P[0], 0};
    size_t last = level->grid.n - 1;
    ends[1] = patch->P[last];
    ovr_level_read(grids, level, P, patch->P);
    patch->P[0] = ends[0];
    patch->P[last] = ends[1];
}

double ovr_patch_flux(const ovr_hierarchy *grids, const ovr_patch *patch,
                      size_t i)
{
    const double *P = patch->P + i, *q = patch->q + i;
    const double *w = grids->op.w;
    return 0.5 * through(patch, i) * (P[1] - P[0]) / patch->level->grid.D -
           (w[0] * q[0] - w[2] * q[-1]);
}
