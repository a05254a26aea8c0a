/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "multigrid/field.h"
#include "multigrid/flow.h"
#include "strip/across.h"
#include "strip/kernels.h"

extern const ovr_strip_kernels ovr_strip_kernels_base;
#if defined __x86_64__ && !defined OVR_NO_AVX2
extern const ovr_strip_kernels ovr_strip_kernels_avx2;
#ifndef OVR_NO_AVX512
extern const ovr_strip_kernels ovr_strip_kernels_avx512;
#endif
#endif

const ovr_strip_kernels *ovr_strip_kernels_of(const ovr_kernels *kernels)
{
    static const ovr_strip_kernels *const all[] = {
#if defined __x86_64__ && !defined OVR_NO_AVX2
#ifndef OVR_NO_AVX512
        &ovr_strip_kernels_avx512,
#endif
        &ovr_strip_kernels_avx2,
#endif
        &ovr_strip_kernels_base
    };
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        if (!strcmp(all[k]->name, kernels->name))
            return all[k];
    return &ovr_strip_kernels_base;
}

double *ovr_strip_field(size_t n, ovr_arena *arena, ovr_error *err)
{
    double *all = ovr_field(arena, n + OVR_STRIP_HALO, err);
    return all ? all + OVR_STRIP_HALO : NULL;
}

static void allocate_fields(ovr_strip_level *level, ovr_arena *arena,
                            ovr_error *err)
{
    const size_t count = sizeof level->f.all / sizeof *level->f.all;
    for (size_t k = 0; k < count; k++)
        level->f.all[k] = ovr_strip_field(ovr_strip_size(&level->grid), arena,
                                          err);
}

/* Number of elements in a row with its halos, in whole cache lines. */
static size_t stride_of(size_t lines)
{
    return (lines + 7) / 8 * 8 + 2 * OVR_STRIP_HALO;
}

int ovr_strip_halvings(size_t coarsest, size_t *n, size_t *lines)
{
    int halvings = 0;
    while (*n > coarsest && *n % 2 && *n > 9 && ovr_across_halved(*lines)) {
        *n = (*n + 1) / 2;
        *lines = ovr_across_halved(*lines);
        halvings++;
    }
    return halvings;
}

static ovr_status make_grids(ovr_strip *strip, const ovr_strip_shape *shape,
                             ovr_error *err)
{
    size_t n = shape->n, lines = shape->lines;
    int halvings = ovr_strip_halvings(shape->coarsest, &n, &lines);
    if (n < 9 || lines < 4 || halvings >= OVR_STRIP_LEVELS)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a strip of %zu x %zu nodes has no coarse grid",
                        shape->n, shape->lines);
    strip->finest = halvings;
    for (int l = 0; l <= halvings; l++) {
        ovr_strip_level *level = &strip->level[l];
        level->number = l;
        level->grid = (ovr_strip_grid){
            .n = ((n - 1) << l) + 1,
            .lines = lines << l,
            .stride = stride_of(lines << l),
            .X_a = shape->X_a,
            .D = (shape->X_b - shape->X_a) / (double)((n - 1) << l),
            .Dy = ovr_across_mesh(shape->width, lines << l)};
    }
    return OVR_OK;
}

/* Allocates the arrays for Newton's method on the coarsest grid. */
static void allocate_coarsest(ovr_strip *strip, ovr_arena *arena,
                              ovr_error *err)
{
    const ovr_strip_grid *g = &strip->level[0].grid;
    size_t most = (g->n - 2) * g->lines + 1;
    if (most < OVR_STRIP_SPOT)
        most = OVR_STRIP_SPOT;
    strip->influence = ovr_field(arena, g->n * (2 * g->lines + 8), err);
    strip->deps_dH = ovr_strip_field(ovr_strip_size(g), arena, err);
    strip->matrix = ovr_field(arena, most * (most + 16), err);
    strip->solution = ovr_field(arena, 2 * most + 32, err);
    strip->unknown = ovr_arena_take(arena, most, sizeof *strip->unknown, err);
    ovr_strip_fields *f = &strip->level[0].f;
    double **const by_film[] = {&f->along_by_film[0], &f->along_by_film[1],
                                &f->across_by_film[0], &f->across_by_film[1]};
    for (size_t k = 0; k < 4; k++)
        *by_film[k] = ovr_strip_field(ovr_strip_size(g), arena, err);
}

ovr_status ovr_strip_allocate(ovr_strip *strip, const ovr_strip_shape *shape,
                              const ovr_kernels *kernels, ovr_arena *arena,
                              ovr_error *err)
{
    ovr_status status = make_grids(strip, shape, err);
    if (status)
        return status;
    strip->kernels = kernels;
    strip->threads = shape->threads;
    strip->run = ovr_strip_kernels_of(kernels);
    const ovr_strip_grid *finest = &strip->level[strip->finest].grid;
    strip->spectrum = ovr_arena_take(arena, ovr_strip_spectrum_size(finest),
                                     sizeof *strip->spectrum, err);
    size_t newton = ovr_strip_size(&strip->level[0].grid);
    size_t members = strip->threads > 1 ? (size_t)strip->threads : 1;
    strip->work_size = ovr_strip_work(finest);
    if (strip->work_size < newton)
        strip->work_size = newton;
    strip->work = ovr_field(arena, members * strip->work_size, err);
    strip->sums = ovr_field(arena, finest->n, err);
    allocate_coarsest(strip, arena, err);
    for (int l = 0; l <= strip->finest; l++) {
        ovr_strip_level *level = &strip->level[l];
        allocate_fields(level, arena, err);
        ovr_strip_elastic_allocate(&level->elastic, &level->grid,
                                   strip->spectrum, arena, err);
    }
    return ovr_arena_status(arena);
}

ovr_status ovr_strip_plan(ovr_strip *strip, ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (int l = 0; l <= strip->finest && !status; l++) {
        ovr_strip_level *level = &strip->level[l];
        status = ovr_strip_elastic_plan(&level->elastic, &level->grid, level,
                                        l ? NULL : strip->influence, err);
    }
    if (!status)
        ovr_team_start(&strip->team, strip->threads);
    return status;
}

ovr_status ovr_strip_create(ovr_strip *strip, const ovr_strip_shape *shape,
                            const ovr_kernels *kernels, ovr_arena *arena,
                            ovr_error *err)
{
    ovr_status status = ovr_strip_allocate(strip, shape, kernels, arena, err);
    return status ? status : ovr_strip_plan(strip, err);
}

void ovr_strip_release(ovr_strip *strip)
{
    ovr_team_end(&strip->team);
    for (int l = 0; l <= strip->finest; l++)
        ovr_strip_elastic_release(&strip->level[l].elastic);
}

static void set_weights(ovr_strip_level *level, double speed, double time)
{
    double D = level->grid.D;
    ovr_strip_weights *w = &level->weights;
    *w = (ovr_strip_weights){
        {1.5 * speed / D + time, -2 * speed / D, 0.5 * speed / D},
        {speed / D + time, -speed / D, 0}};
}

void ovr_strip_wedge(ovr_strip *strip, double speed, double time)
{
    for (int l = 0; l <= strip->finest; l++)
        set_weights(&strip->level[l], speed, time);
}

void ovr_strip_characteristic(ovr_strip *strip, double time)
{
    for (int l = 0; l <= strip->finest; l++)
        set_weights(&strip->level[l], 0, time);
}

void ovr_strip_refresh(ovr_strip *strip, ovr_strip_level *level)
{
    ovr_strip_deform(strip, level, level->f.P, level->f.w);
    ovr_strip_properties(strip, level);
}

double ovr_strip_load(ovr_strip *strip, ovr_strip_level *level)
{
    const ovr_strip_grid *g = &level->grid;
    return ovr_strip_sum(strip, level, level->f.P) * g->D /
           (double)ovr_across_intervals(g->lines);
}

double ovr_strip_centre(const ovr_strip_level *level, const double *H)
{
    const ovr_strip_grid *g = &level->grid;
    double x = -g->X_a / g->D;
    size_t i = x < 1 ? 1 : (size_t)x;
    if (i + 3 > g->n)
        i = g->n - 3;
    double u = x - (double)i, sum = 0;
    const double c[4] = {-u * (u - 1) * (u - 2) / 6,
                         (u + 1) * (u - 1) * (u - 2) / 2,
                         -(u + 1) * u * (u - 2) / 2, (u + 1) * u * (u - 1) / 6};
    for (size_t j = 0; j < g->lines; j++)
        for (size_t m = 0; m < 4; m++)
            sum += c[m] * H[ovr_strip_row(g, i - 1 + m) + j];
    return sum / (double)ovr_across_intervals(g->lines);
}

ovr_strip_defect ovr_strip_defect_of(ovr_strip *strip, ovr_strip_level *level)
{
    const ovr_strip_grid *g = &level->grid;
    ovr_strip_defect d = {.centre = ovr_strip_centre(level, level->f.H)};
    d.imbalance = ovr_strip_imbalance(strip, level) * g->D /
                  ((double)ovr_across_intervals(g->lines) * d.centre);
    d.load = fabs(level->force - ovr_strip_load(strip, level)) / level->force;
    return d;
}

bool ovr_strip_below(ovr_strip_defect d, double tolerance)
{
    return d.imbalance >= 0 && d.imbalance <= tolerance &&
           d.load <= 10 * tolerance && d.centre > 0;
}

ovr_strip_cycling ovr_strip_steady(const ovr_fluid *fluid)
{
    ovr_strip_cycling how = {.smoothing = {.to_left = 0.5,
                                           .to_side = 0.25,
                                           .whole = 0.8,
                                           .plain = 0.8,
                                           .limit = 0.1,
                                           .tau = 2,
                                           .along = 1,
                                           .across = 1,
                                           .end_sweeps = 8,
                                           .end_share = 30},
                             .sweeps_before = 1,
                             .sweeps_after = 1,
                             .newton_steps = 1,
                             .correction = 1};
    /* With sliding, the flow along X is large in the whole contact. Line solves
     * treat it exactly, so nodes need not be relaxed individually. Larger tau
     * let a wave of two lines grow by 1.1 a cycle (M = 20, level 5). */
    if (ovr_flow_is_shear_thinning(fluid)) {
        how.smoothing.tau = 1;
        how.smoothing.along = 0.2;
    }
    return how;
}

ovr_strip_cycling ovr_strip_transient(const ovr_fluid *fluid)
{
    ovr_strip_cycling how = ovr_strip_steady(fluid);
    how.smoothing.to_left = how.smoothing.to_right = 0.25;
    how.smoothing.plain = 0.7;
    how.smoothing.limit = 0.5;
    how.smoothing.tau = 6;
    how.smoothing.end_share = 300;
    if (ovr_flow_is_shear_thinning(fluid))
        how.smoothing.along = 0;
    return how;
}
