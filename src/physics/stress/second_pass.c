/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dang Van's criterion with its single line asks for the centre of the circle
 * round a path, which its extents give badly: the stored pressure is gone over
 * a second time, depth by depth, whole paths are kept, and the circle is
 * exact.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "physics/stress/stress.h"
#include "stress/cubic.h"
#include "stress/layered.h"
#include "stress/stress.h"

/* Material histories move their nodes by less than this, for every level at
 * once. */
enum { WHOLE = 32 };

typedef struct pass {
    const ovr_setup *setup;
    const ovr_stress_plan *plan;
    ovr_stress_report *report; /* whose amplitudes it finds */
    ovr_result *result;
    size_t snapshots;
    double *T, *P, *Q; /* T of all; one P and Q, NULL: none */
    /* one depth */
    ovr_stress *stress;
    long first; /* point k is at xi = (first + k) 2^c D */
    size_t points, capacity;
    float *path, *hydro; /* `capacity` values of each point */
    size_t *count;
} pass;

static double hydrostatic(const pass *p, double h)
{
    ovr_at_rest at = ovr_layered_rest(&p->plan->options, &p->plan->range,
                                      ovr_stress_at(p->stress, 0).z);
    return (at.x + at.y) / 3 - 2. / 3 * (1 + at.poisson) * h;
}

static void keep(pass *p, size_t k, const ovr_stress_row *row, size_t i)
{
    size_t n = p->count[k];
    if (n == p->capacity)
        return;
    p->path[2 * (k * p->capacity + n)] = row->shear[2 * i];
    p->path[2 * (k * p->capacity + n) + 1] = row->shear[2 * i + 1];
    p->hydro[k * p->capacity + n] = (float)hydrostatic(
        p, (double)row->mean[2 * i]);
    p->count[k]++;
}

/* Rows around the contact: node i is at point i + *offset. */
static ovr_stress_row look(pass *p, double U, long *offset)
{
    const ovr_stress_plan *plan = p->plan;
    double D = plan->options.mesh, start, t, whole;
    ovr_stress_row row;
    start = plan->options.inlet +
            ceil((plan->options.from - plan->options.inlet) / D - 1e-9) * D;
    t = (U + plan->range.reference - start) / D;
    whole = floor(t / WHOLE);
    ovr_stress_solve(p->stress, p->P, p->Q, t - whole * WHOLE,
                     OVR_STRESS_ALL_LEVELS);
    row = ovr_stress_at(p->stress, 0);
    *offset = -(long)whole * (WHOLE >> row.level) - p->first;
    return row;
}

static bool within(const pass *p, const ovr_stress_row *row, size_t i)
{
    return fabs(row->start + (double)i * row->step) <= p->plan->range.reach;
}

/* One moment; `side` -1: all earlier places too, 1: all later ones. */
static void follow(pass *p, const ovr_moment *m, int side)
{
    long offset;
    ovr_stress_row row = look(p, m->U, &offset);
    bool upward = m->direction > 0;
    for (size_t k = 0; k < p->points; k++) {
        long own = (long)k - offset;
        for (size_t i = 0; i < row.count; i++) {
            bool behind = upward ? (long)i < own : (long)i > own;
            bool ahead = (long)i != own && !behind;
            if (within(p, &row, i) &&
                ((long)i == own || (side < 0 && behind) || (side > 0 && ahead)))
                keep(p, k, &row, i);
            if (!side && own >= 0 && (long)i < own)
                i = (size_t)own < row.count ? (size_t)own - 1 : row.count;
            else if (!side && (long)i >= own)
                break;
        }
    }
}

static ovr_status read_loads(pass *p, size_t k, ovr_error *err)
{
    ovr_status status = ovr_result_snapshot(p->result, "pressure", k,
                                            OVR_HERTZIAN, p->P, err);
    return status ? status
                  : ovr_traction_stored(p->plan, p->result, k, p->Q, err);
}

/* The steady contact at the start, from one side to the other. */
static double smooth_value(pass *p, ovr_arena *arena)
{
    ovr_stress_row row = ovr_stress_at(p->stress, 0);
    float *s = ovr_arena_take(arena, 2 * row.count + 2, sizeof *s, NULL);
    float *hydro = ovr_arena_take(arena, row.count + 1, sizeof *hydro, NULL);
    size_t n = 1;
    if (!s || !hydro)
        return NAN;
    hydro[0] = (float)hydrostatic(p, 0);
    for (size_t i = 0; i < row.count; i++)
        if (within(p, &row, i)) {
            s[2 * n] = row.shear[2 * i];
            s[2 * n + 1] = row.shear[2 * i + 1];
            hydro[n++] = (float)hydrostatic(p, (double)row.mean[2 * i]);
        }
    return ovr_dang_van(n, s, hydro, ovr_setup_stress(p->setup)->alpha);
}

static ovr_status make_depth(pass *p, double z, ovr_arena *arena,
                             ovr_error *err)
{
    ovr_stress_options o = p->plan->options;
    const ovr_material_range *range = &p->plan->range;
    double shortest = INFINITY, way[2] = {0, 0};
    o.depth_min = o.depth_max = z;
    p->stress = ovr_stress_create(&o, &arena->allocator, err);
    if (!p->stress)
        return OVR_NO_MEMORY;
    ovr_stress_row row = ovr_stress_at(p->stress, 0);
    for (size_t k = 1; k < p->snapshots; k++) {
        way[k & 1] = ovr_stress_distance(p->setup, p->plan, p->T[k]);
        shortest = fmin(shortest, fmax(fabs(way[1] - way[0]), 1e-9));
    }
    if (p->plan->direction == 0)
        shortest = 1e-9; /* points may stay, or come again */
    p->first = (long)floor(range->from / row.step) - 1;
    p->points = (size_t)((long)ceil(range->to / row.step) + 2 - p->first);
    p->capacity = 3 * row.count + 8 +
                  (size_t)fmin(2 * range->reach / shortest,
                               (double)p->snapshots);
    p->path = ovr_arena_take(arena, 2 * p->points * p->capacity,
                             sizeof *p->path, err);
    p->hydro = ovr_arena_take(arena, p->points * p->capacity, sizeof *p->hydro,
                              err);
    p->count = ovr_arena_take(arena, p->points, sizeof *p->count, err);
    if (!p->path || !p->hydro || !p->count)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < p->points; k++) { /* before all: no load */
        p->hydro[k * p->capacity] = (float)hydrostatic(p, 0);
        p->count[k] = 1;
    }
    return OVR_OK;
}

static ovr_status follow_all(pass *p, double *smooth, ovr_arena *arena,
                             ovr_error *err)
{
    for (size_t k = 0; k < p->snapshots; k++) {
        ovr_moment m = ovr_stress_moment(p->setup, p->plan, p->T[k], p->T[k]);
        if (read_loads(p, k, err))
            return err ? err->status : OVR_IO;
        follow(p, &m, k == 0 ? -1 : 0);
        if (k == 0)
            *smooth = smooth_value(p, arena);
        if (k + 1 == p->snapshots)
            follow(p, &m, 1);
    }
    return OVR_OK;
}

/* Onto the finest points, cubic between those of the level. */
static void spread(const pass *p, float *to)
{
    const ovr_material *m = &p->report->material;
    double step = ovr_stress_at(p->stress, 0).step;
    for (size_t k = 0; k < p->points; k++)
        p->hydro[k * p->capacity] = (float)ovr_dang_van(
            p->count[k], p->path + 2 * k * p->capacity,
            p->hydro + k * p->capacity, ovr_setup_stress(p->setup)->alpha);
    for (size_t i = 0; i < m->points; i++) {
        double at = (m->start + (double)i * m->step) / step - (double)p->first;
        size_t k = (size_t)fmax(at, 1);
        k = k + 3 > p->points ? p->points - 3 : k;
        to[i] = (float)ovr_cubic(p->hydro + k * p->capacity,
                                 (ptrdiff_t)p->capacity, at - (double)k);
    }
}

static ovr_status one_depth(pass *p, size_t j, ovr_error *err)
{
    const ovr_material *m = &p->report->material;
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_status status = make_depth(p, m->z[j], &arena, err);
    if (!status)
        status = follow_all(p, &p->report->amplitude_smooth[j], &arena, err);
    if (!status)
        spread(p, p->report->amplitude + j * m->points);
    ovr_stress_free(p->stress);
    p->stress = NULL;
    ovr_arena_release(&arena);
    return status;
}

static ovr_status all_depths(pass *p, ovr_error *err)
{
    const ovr_result_info *info = ovr_result_get_info(p->result);
    ovr_status status;
    p->snapshots = info->snapshots;
    if (info->nodes != p->plan->options.nodes || p->snapshots < 2)
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van needs the pressure of "
                              "all nodes in the file at two or more times");
    if (p->Q && !ovr_traction_is_stored(p->plan, p->result))
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van with traction needs "
                              "shear_stress_%d in output.fields",
                              p->plan->surface);
    status = ovr_result_times(p->result, OVR_HERTZIAN, p->T, err);
    for (size_t j = 0; !status && j < p->report->material.depths; j++)
        status = one_depth(p, j, err);
    return status;
}

ovr_status ovr_stress_second_pass(const ovr_stress_source *of,
                                  const ovr_stress_plan *plan,
                                  ovr_stress_report *r, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(NULL);
    pass p = {.setup = of->setup, .plan = plan, .report = r};
    ovr_status status = OVR_NO_MEMORY;
    p.result = ovr_result_open(of->path, NULL, err);
    if (!p.result)
        return OVR_IO;
    const ovr_result_info *info = ovr_result_get_info(p.result);
    p.T = ovr_arena_take(&arena, info->snapshots + 1, sizeof *p.T, err);
    p.P = ovr_arena_take(&arena, info->nodes, sizeof *p.P, err);
    if (plan->options.traction)
        p.Q = ovr_arena_take(&arena, info->nodes, sizeof *p.Q, err);
    if (p.T && p.P && (p.Q || !plan->options.traction))
        status = all_depths(&p, err);
    ovr_result_close(p.result);
    ovr_arena_release(&arena);
    return status;
}
