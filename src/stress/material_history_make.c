/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creation and release of a stress history. */
#include <math.h>
#include <string.h>

#include "base/given.h"
#include "stress/material_history.h"
#include "stress/stress.h"

static double least_depth(const ovr_stress_options *o,
                          const ovr_material_range *range)
{
    return range->least_depth > 0 ? range->least_depth : 8 * o->mesh;
}

/* Level c covers the range with two additional points on either side. */
static ovr_material_grid grid_of(const ovr_material_range *range, double step)
{
    ovr_material_grid grid = {.first = (long)floor(range->from / step) - 1};
    long last = (long)ceil(range->to / step) + 1;
    grid.points = (size_t)(last - grid.first) + 1;
    return grid;
}

static void find_grids(ovr_material_history *p)
{
    const ovr_stress *s = p->stress;
    for (size_t j = s->depths; j-- > 0;) {
        int c = s->depth[j].level;
        p->grid[c] = grid_of(&p->range, ldexp(s->options.mesh, c));
        p->grid[c].top = s->depth[j].z;
    }
    p->finest = s->depth[0].level;
    p->first = p->grid[p->finest].first + 1;
    p->points = p->grid[p->finest].points - 2;
}

/* State without load: zero except for residual stresses. */
static void find_rest(ovr_material_history *p)
{
    const ovr_material_range *range = &p->range;
    const ovr_layered *layers = p->stress->options.layers;
    int last = layers ? layers->layers : 0;
    for (int m = 0; m <= last; m++) {
        double z = m < last ? ovr_layered_bottom(layers, m) * (1 - OVR_BESIDE)
                            : INFINITY;
        ovr_at_rest at = ovr_layered_rest(&p->stress->options, range, z);
        float zero[2] = {0, 0}, d, tau, h, in_plane;
        p->constants[m] = (ovr_state_constants){(float)at.poisson,
                                                (float)(at.x / 2),
                                                (float)(at.x / 2), (float)at.y};
        ovr_node_states to = {&d,
                              &tau,
                              &h,
                              &in_plane,
                              &p->rest[m][OVR_ROW_VON_MISES],
                              &p->rest[m][OVR_ROW_TRESCA]};
        p->stress->loops->states(1, zero, zero, &p->constants[m], &to);
    }
}

static void start_at_rest(ovr_material_history *p)
{
    for (size_t j = 0; j < p->stress->depths; j++) {
        size_t points = p->grid[p->stress->depth[j].level].points;
        const float *rest =
            p->rest[ovr_material_history_layer(p, p->stress->z[j])];
        for (size_t r = 0; r < OVR_ROWS; r++) {
            p->smooth[j * OVR_ROWS + r] = rest[r];
            for (size_t k = 0; k < points; k++)
                p->row[j][r * points + k] = rest[r];
        }
    }
    memset(p->complete, 1, p->points);
}

static size_t values_of_all(const ovr_material_history *p)
{
    size_t values = 0;
    for (size_t j = 0; j < p->stress->depths; j++)
        values += OVR_ROWS * p->grid[p->stress->depth[j].level].points;
    return values;
}

/* Size of work arrays: nodes at one time, or points of a level. */
static size_t scratch_workspace(const ovr_material_history *p)
{
    size_t points = p->grid[p->finest].points;
    return points > p->stress->capacity ? points : p->stress->capacity;
}

static bool allocate_scratch(ovr_material_history *p, ovr_error *err)
{
    size_t capacity = scratch_workspace(p);
    float **scratch[] = {&p->d,        &p->tau,       &p->h,
                         &p->in_plane, &p->von_mises, &p->tresca};
    for (size_t k = 0; k < sizeof scratch / sizeof *scratch; k++) {
        *scratch[k] = ovr_arena_take(&p->arena, capacity, sizeof(float), err);
        if (!*scratch[k])
            return false;
    }
    return true;
}

/* Allocates the sums of strips of pressure for a plastic body. */
static ovr_status allocate_sums(ovr_material_history *p, ovr_error *err)
{
    size_t n = p->stress->options.nodes;
    if (!(p->range.yield > 0))
        return OVR_OK;
    p->sums.nodes = n;
    p->sums.sum = ovr_arena_take(&p->arena, n + 1, sizeof(double), err);
    p->piece[p->pieces++] = (ovr_memory_piece){"passage strip", &p->strip,
                                               sizeof p->strip};
    return p->sums.sum ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status allocate_arrays(ovr_material_history *p, ovr_error *err)
{
    size_t depths = p->stress->depths, all = values_of_all(p);
    float *rows = ovr_arena_take(&p->arena, all, sizeof *rows, err);
    p->row = ovr_arena_take(&p->arena, depths, sizeof *p->row, err);
    p->smooth = ovr_arena_take(&p->arena, depths * OVR_ROWS, sizeof(float),
                               err);
    p->complete = ovr_arena_take(&p->arena, p->points, 1, err);
    if (!rows || !p->row || !p->smooth || !p->complete ||
        !allocate_scratch(p, err))
        return OVR_NO_MEMORY;
    p->row[0] = rows;
    for (size_t j = 1; j < depths; j++)
        p->row[j] = p->row[j - 1] +
                    OVR_ROWS * p->grid[p->stress->depth[j - 1].level].points;
    ovr_memory_piece pieces[] = {
        {"passage", rows, all * sizeof *rows},
        {"passage smooth", p->smooth, depths * OVR_ROWS * sizeof(float)},
        {"passage complete", p->complete, p->points},
        {"passage numbers", &p->numbers, sizeof p->numbers},
        /* Depends on the end time of the run, so a continued run must keep it
         */
        {"passage reference", &p->range.reference, sizeof p->range.reference},
    };
    memcpy(p->piece, pieces, sizeof pieces);
    p->pieces = sizeof pieces / sizeof *pieces;
    if (p->stress->options.layers)
        p->piece[p->pieces++] = (ovr_memory_piece){"passage layers", &p->layers,
                                                   sizeof p->layers};
    return allocate_sums(p, err);
}

static ovr_status check(const ovr_stress_options *o,
                        const ovr_material_range *range, ovr_error *err)
{
    if (!(range->to > range->from))
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "material from %g to %g: the lower limit must be below the upper "
            "limit",
            range->from, range->to);
    if ((range->to - range->from) / o->mesh > OVR_MATERIAL_POINTS_MAX)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "material from %g to %g has more than %.2g points",
                        range->from, range->to,
                        (double)OVR_MATERIAL_POINTS_MAX);
    if (!(range->reach > 0) || range->reach > o->to || range->reach > -o->from)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "paths within |X| <= %g need fields from %g to %g",
                        range->reach, -range->reach, range->reach);
    if (!(range->poisson >= 0 && range->poisson <= 0.5))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "Poisson's ratio %g must be between 0 and 0.5",
                        range->poisson);
    return OVR_OK;
}

static ovr_status prepare(ovr_material_history *p, ovr_error *err)
{
    for (int m = 0; m < OVR_HALF_DIRECTIONS; m++) {
        p->cosine[m] = (float)ovr_direction_cos(m);
        p->sine[m] = (float)ovr_direction_sin(m);
    }
    find_grids(p);
    find_rest(p);
    ovr_status status = allocate_arrays(p, err);
    if (!status)
        start_at_rest(p);
    return status;
}

static ovr_status copy_options(const ovr_stress_options *o,
                               const ovr_material_range *range,
                               ovr_stress_options *to,
                               ovr_material_range *to_range, ovr_error *err)
{
    ovr_status status = OVR_TAKE(ovr_stress_options, to, o, err);
    return status ? status : OVR_TAKE(ovr_material_range, to_range, range, err);
}

ovr_material_history *
ovr_material_history_create(const ovr_stress_options *given,
                            const ovr_material_range *given_range,
                            const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_stress_options own, *options = &own;
    ovr_material_range own_range, *range = &own_range;
    if (copy_options(given, given_range, options, range, err) ||
        ovr_stress_check(options, err) || check(options, range, err))
        return NULL;
    ovr_material_history *p = ovr_arena_take(&arena, 1, sizeof *p, err);
    if (!p)
        return NULL;
    p->arena = arena;
    p->range = *range;
    p->range.least_depth = least_depth(options, range);
    p->stress = ovr_stress_create(options, allocator, err);
    if (!p->stress || prepare(p, err)) {
        ovr_material_history_free(p);
        return NULL;
    }
    return p;
}

void ovr_material_history_free(ovr_material_history *history)
{
    if (!history)
        return;
    ovr_stress_free(history->stress);
    ovr_arena arena = history->arena;
    ovr_arena_release(&arena);
}

double ovr_material_history_memory(const ovr_stress_options *given,
                                   const ovr_material_range *given_range)
{
    ovr_stress_options own, *o = &own;
    ovr_material_range own_range, *range = &own_range;
    double bytes = ovr_stress_memory(given);
    if (isnan(bytes) || copy_options(given, given_range, o, range, NULL) ||
        check(o, range, NULL))
        return NAN;
    double minimum = o->depth_min > 0 ? o->depth_min : 4 * o->mesh;
    double scratch = (double)ovr_stress_capacity(o);
    for (size_t j = 0; j < ovr_depths(o, NULL); j++) {
        double z = minimum * exp2((double)j / o->per_octave);
        double step = ldexp(o->mesh, ovr_depth_level(o, z));
        double points = (range->to - range->from) / step + 3;
        bytes += 4 * OVR_ROWS * points;
        scratch = fmax(scratch, points);
    }
    if (range->yield > 0)
        bytes += 8 * ((double)o->nodes + 1);
    return bytes + 24 * scratch;
}
