/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/hierarchy.h"

#include <math.h>
#include <string.h>

#include "multigrid/coarsest.h"
#include "multigrid/field.h"
#include "multigrid/flow.h"
#include "multigrid/tripoles.h"

/* -------------------------------------------------------------------- grids */

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

static void grid_fill(ovr_grid *grid)
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

/* Number of nodes in lanes and halos, for any machine's kernels. */
static size_t capacity_of(const ovr_level *level)
{
    return level->grid.n + OVR_MAX_LANES;
}

/* True if a level has the field. */
static bool has(const ovr_hierarchy *grids, ovr_field_memory memory,
                bool newton)
{
    bool thins = ovr_flow_is_shear_thinning(&grids->fluid);
    bool gap = grids->fluid.by_gap;
    switch (memory) {
    case OVR_NEWTON: return newton;
    case OVR_FLUIDITY: return grids->fluid.logarithmic;
    case OVR_FLOW: return gap || thins;
    case OVR_SENSITIVE: return newton && (gap || thins);
    case OVR_CONTENT: return grids->content;
    case OVR_SKEWED: return grids->skewed;
    default: return true;
    }
}

void ovr_hierarchy_by_gap(ovr_hierarchy *grids)
{
    grids->fluid.logarithmic = grids->fluid.secants = false;
    for (int l = grids->coarsest; l <= grids->finest; l++)
        grids->level[l].f.log_fluidity = grids->level[l].f.log_slope = NULL;
}

static void allocate_sets(ovr_fields *f, size_t n, bool content,
                          ovr_arena *arena, ovr_error *err)
{
    unsigned char **const all[] = {&f->wet,   &f->held, &f->dried, &f->limited,
                                   &f->spent, &f->left, &f->right};
    for (size_t k = 0; k < (content ? sizeof all / sizeof *all : 2); k++)
        *all[k] = ovr_set(arena, n, err);
}

static void allocate_fields(const ovr_hierarchy *grids, ovr_level *level,
                            ovr_arena *arena, ovr_error *err)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++) {
        ovr_field_memory memory = ovr_field_rows[k].memory;
        if (!has(grids, memory,
                 level->number < grids->coarsest + grids->newton.levels))
            continue;
        level->f.all[k] = memory == OVR_WIDE
                              ? ovr_mlmi_field(&level->mlmi, arena, err)
                              : ovr_field(arena, capacity_of(level), err);
    }
    allocate_sets(&level->f, level->grid.n, grids->content, arena, err);
}

static void allocate_natural(ovr_hierarchy *grids, size_t n, ovr_arena *arena,
                             ovr_error *err)
{
    ovr_fields *f = &grids->natural;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].ordered &&
            has(grids, ovr_field_rows[k].memory, true))
            f->all[k] = ovr_field(arena, n, err);
    if (grids->content)
        allocate_sets(f, n, true, arena, err);
}

static void set_lanes(ovr_level *level, const ovr_kernels *kernels)
{
    level->lanes = (ovr_lanes){.n = level->grid.n,
                               .S = ovr_mlmi_lane(&level->mlmi, kernels->lanes),
                               .V = kernels->lanes};
}

ovr_status ovr_level_build(const ovr_hierarchy *grids, ovr_level *level,
                           ovr_mlmi_form mlmi, ovr_arena *arena, ovr_error *err)
{
    ovr_mlmi_plan(&level->mlmi, level->grid.n, mlmi, arena, err);
    level->mlmi.linear = grids->influence.linear;
    set_lanes(level, grids->kernels);
    allocate_fields(grids, level, arena, err);
    return ovr_arena_status(arena);
}

void ovr_hierarchy_kernels(ovr_hierarchy *grids, const ovr_kernels *kernels)
{
    grids->kernels = kernels;
    for (int l = grids->coarsest; l <= grids->finest; l++)
        set_lanes(&grids->level[l], kernels);
}

ovr_status ovr_hierarchy_build(ovr_hierarchy *grids,
                               const ovr_hierarchy_form *form, ovr_arena *arena,
                               ovr_error *err)
{
    const int coarsest = form->coarsest, finest = form->finest;
    grids->coarsest = coarsest;
    grids->finest = finest;
    grids->newton.levels = ovr_newton_levels(grids);
    ovr_grid *first = &grids->level[coarsest].grid;
    *first = (ovr_grid){.n = ovr_level_nodes(coarsest), .X_a = form->X_a};
    first->D = (form->X_b - form->X_a) / (double)(first->n - 1);
    first->X = ovr_arena_take(arena, first->n, sizeof *first->X, err);
    for (int l = coarsest; l <= finest; l++) {
        ovr_level *level = &grids->level[l];
        const ovr_grid *below = &(level - 1)->grid;
        level->number = l;
        if (l > coarsest)
            ovr_grid_refine(&level->grid, below, (ovr_window){0, below->n - 1},
                            arena, err);
        ovr_level_build(grids, level, form->mlmi[l], arena, err);
    }
    size_t capacity = capacity_of(&grids->level[finest]);
    ovr_band *band = &grids->band;
    OVR_TAKE_FIELDS(arena, capacity, err, &band->b[0], &band->b[1], &band->b[2],
                    &band->b[3], &band->b[4], &band->delta);
    allocate_natural(grids, grids->level[grids->ordered].grid.n, arena, err);
    double end = fmax(fmax(-form->X_a, form->X_b) / 4, 1);
    band->reach = end * end;
    grids->scratch[0] = band->b[0];
    grids->scratch[1] = band->b[1];
    ovr_hierarchy_kernels(grids, grids->kernels);
    return ovr_newton_prepare(grids, arena, err);
}

void ovr_level_fill(const ovr_hierarchy *grids, ovr_level *level,
                    const ovr_level *like)
{
    grid_fill(&level->grid);
    level->mlmi.part = grids->influence.part;
    level->mlmi.parts = grids->influence.parts;
    ovr_mlmi_fill(&level->mlmi, level->grid.D, like ? &like->mlmi : NULL);
    ovr_influence_band(&grids->influence, level->grid.D, level->k);
    level->local = ovr_influence_local(&grids->influence, level->grid.D);
}

void ovr_hierarchy_fill(ovr_hierarchy *grids)
{
    for (int l = grids->coarsest; l <= grids->finest; l++) {
        ovr_level *level = &grids->level[l];
        ovr_level_fill(grids, level, l > grids->coarsest ? level - 1 : NULL);
    }
    ovr_newton_fill(grids);
}

void ovr_level_operator(const ovr_operator *op, ovr_level *level)
{
    const ovr_weights before = level->weights;
    level->weights = ovr_reynolds_weights(op, level->grid.D);
    for (int m = 0; m < 3; m++) {
        level->weights.skew[m] = before.skew[m];
        level->weights.skew_first[m] = before.skew_first[m];
    }
    level->shares = ovr_reynolds_shares(op, level->grid.D);
    level->closed = false;
    memcpy(level->opened, level->weights.first, sizeof level->opened);
}

void ovr_hierarchy_operator(ovr_hierarchy *grids, const ovr_operator *op)
{
    grids->op = *op;
    for (int l = grids->coarsest; l <= grids->finest; l++)
        ovr_level_operator(op, &grids->level[l]);
}

/* Allocates memory for an additional pressure on the solids at the finest level
 * (asperity pressure). It is constant during a cycle, so that coarser levels do
 * not need it. */
static ovr_status hierarchy_bear(ovr_hierarchy *grids, ovr_arena *arena,
                                 ovr_error *err)
{
    ovr_level *finest = &grids->level[grids->finest];
    if (finest->asperity_P)
        return ovr_arena_status(arena);
    finest->pressed = ovr_mlmi_field(&finest->mlmi, arena, err);
    finest->asperity_P = ovr_mlmi_field(&finest->mlmi, arena, err);
    return ovr_arena_status(arena);
}

/* Allocates the fields that Newton's method needs on a level. */
static void allocate_newton_fields(const ovr_hierarchy *grids, ovr_level *level,
                                   ovr_arena *arena, ovr_error *err)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (!level->f.all[k] && has(grids, ovr_field_rows[k].memory, true))
            level->f.all[k] = ovr_field(arena, capacity_of(level), err);
}

/* Allocates the arrays that Newton's method needs on the finest level. */
static void allocate_newton(ovr_hierarchy *grids, ovr_arena *arena,
                            ovr_error *err)
{
    ovr_level *finest = &grids->level[grids->finest];
    allocate_newton_fields(grids, finest, arena, err);
    if (grids->ordered == grids->finest)
        return;
    grids->ordered = grids->finest;
    allocate_natural(grids, finest->grid.n, arena, err);
}

ovr_status ovr_hierarchy_take_asperities(ovr_hierarchy *grids, ovr_arena *arena,
                                         ovr_error *err)
{
    ovr_asperity *touch = &grids->touch;
    size_t n = grids->level[grids->finest].grid.n;
    size_t capacity = capacity_of(&grids->level[grids->finest]);
    OVR_TAKE_FIELDS(arena, n + 1, err, &touch->A, &touch->g, &touch->whole,
                    &touch->excess, &touch->step);
    touch->lift = ovr_field(arena, n, err);
    touch->gap = ovr_field(arena, capacity, err);
    touch->kernel = ovr_newton_kernel(n, arena, err);
    touch->dry = ovr_set(arena, n, err);
    touch->opened = ovr_set(arena, n, err);
    touch->tripoles = ovr_tripoles_take(n, arena, err);
    allocate_newton(grids, arena, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    ovr_newton_fill(grids);
    return hierarchy_bear(grids, arena, err);
}

ovr_status ovr_hierarchy_take_coarse_asperities(ovr_hierarchy *grids, int depth,
                                                ovr_arena *arena,
                                                ovr_error *err)
{
    ovr_asperity *touch = &grids->touch;
    int l = grids->finest - depth;
    touch->coarsest = l > grids->coarsest ? l : grids->coarsest;
    for (l = touch->coarsest; l < grids->finest; l++) {
        ovr_level *level = &grids->level[l];
        allocate_newton_fields(grids, level, arena, err);
        touch->kept_P[l] = ovr_mlmi_field(&level->mlmi, arena, err);
        touch->kept_pressed[l] = ovr_mlmi_field(&level->mlmi, arena, err);
    }
    return ovr_arena_status(arena);
}

static void allocate_skew(ovr_fields *f, size_t n, ovr_arena *arena,
                          ovr_error *err)
{
    if (!f->skew)
        f->skew = ovr_field(arena, n, err);
    if (!f->skew_by_P)
        f->skew_by_P = ovr_field(arena, n, err);
}

ovr_status ovr_hierarchy_skew(ovr_hierarchy *grids, bool second_order,
                              ovr_arena *arena, ovr_error *err)
{
    ovr_operator wedge = {.speed = 1};
    ovr_reynolds_wedge(&wedge, second_order, 1);
    grids->skewed = true;
    for (int l = grids->coarsest; l <= grids->finest; l++) {
        ovr_level *level = &grids->level[l];
        const ovr_weights w = ovr_reynolds_weights(&wedge, level->grid.D);
        for (int m = 0; m < 3; m++) {
            level->weights.skew[m] = w.a[m];
            level->weights.skew_first[m] = w.first[m];
        }
        allocate_skew(&level->f, capacity_of(level), arena, err);
    }
    allocate_skew(&grids->natural, grids->level[grids->ordered].grid.n, arena,
                  err);
    return ovr_arena_status(arena);
}

/* ------------------------------------------------------- Order of the nodes */

void ovr_level_read(const ovr_hierarchy *grids, const ovr_level *level,
                    const double *values, double *ordered)
{
    grids->kernels->unpack(&level->lanes, values, ordered);
}

void ovr_level_write(const ovr_hierarchy *grids, const ovr_level *level,
                     const double *ordered, double *values)
{
    grids->kernels->pack(&level->lanes, ordered, values);
}

const ovr_fields *ovr_level_ordered(const ovr_hierarchy *grids,
                                    const ovr_level *level)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].ordered && level->f.all[k])
            ovr_level_read(grids, level, level->f.all[k],
                           grids->natural.all[k]);
    return &grids->natural;
}
