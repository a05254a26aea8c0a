/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Report of a stress history: maxima, amplitudes, life. */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "case/setup.h"
#include "physics/stress/stress.h"
#include "stress/cubic.h"
#include "stress/layered.h"
#include "stress/material_history.h"
#include "stress/stress.h"

/* -------------------------------------------------------------- second pass */

/*
 * Dang Van's criterion needs the centre of the circle around each shear stress
 * path, which its extent determines poorly. Therefore the stored pressure is
 * processed a second time, depth by depth; whole paths are stored and the
 * circle is exact.
 */

/* Stress histories shift their nodes by less than this, on every level. */
enum { WHOLE = 32 };

typedef struct pass {
    const ovr_setup *setup;
    const ovr_stress_plan *plan;
    ovr_stress_report *report; /* the report to be completed */
    ovr_result *result;
    size_t snapshots;
    double *T, *P, *Q; /* all times; pressure and traction of one time; Q NULL:
                        * none */
    /* data of one depth */
    ovr_stress *stress;
    long first; /* point k is at xi = (first + k) 2^c D */
    size_t points, capacity;
    float *path, *hydro; /* `capacity` values for each point */
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

/* Computes the rows around the contact: node i is at point i + *offset. */
static ovr_stress_row solve_rows(pass *p, double U, long *offset)
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

/* Adds one time to the paths; side = -1: all positions before the contact too,
 * 1: all positions after it too. */
static void follow(pass *p, const ovr_moment *m, int side)
{
    long offset;
    ovr_stress_row row = solve_rows(p, m->U, &offset);
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

/* Value of the steady contact at the start, for material that passes through
 * it. */
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
    double shortest = INFINITY, distance[2] = {0, 0};
    o.depth_min = o.depth_max = z;
    p->stress = ovr_stress_create(&o, &arena->allocator, err);
    if (!p->stress)
        return OVR_NO_MEMORY;
    ovr_stress_row row = ovr_stress_at(p->stress, 0);
    for (size_t k = 1; k < p->snapshots; k++) {
        distance[k & 1] = ovr_stress_distance(p->setup, p->plan, p->T[k]);
        shortest = fmin(shortest, fmax(fabs(distance[1] - distance[0]), 1e-9));
    }
    if (p->plan->direction == 0)
        shortest = 1e-9; /* points may stay, or return */
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
    for (size_t k = 0; k < p->points; k++) { /* without load before the contact
                                              */
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

/* Interpolates from the level's points to the finest points by cubics. */
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

/* Computes Dang Van's amplitudes of a report from the pressure in the file. */
static ovr_status stress_second_pass(const ovr_stress_source *of,
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

static bool allocate_arrays(ovr_stress_report *r, ovr_arena *arena,
                            ovr_error *err)
{
    size_t n = r->material.points, depths = r->material.depths;
    bool ok = true;
    for (int m = 0; ok && m < OVR_MEASURES; m++) {
        r->measure[m] = ovr_arena_take(arena, n * depths, sizeof(float), err);
        r->smooth[m] = ovr_arena_take(arena, depths, sizeof(double), err);
        ok = r->measure[m] && r->smooth[m];
    }
    if (!ok)
        return false;
    r->amplitude = ovr_arena_take(arena, n * depths, sizeof(float), err);
    r->amplitude_smooth = ovr_arena_take(arena, depths, sizeof(double), err);
    r->risk = ovr_arena_take(arena, n, sizeof(double), err);
    r->length = ovr_arena_take(arena, depths, sizeof(double), err);
    return r->amplitude && r->amplitude_smooth && r->risk && r->length;
}

/* Copies the arrays that the stress history owns. */
static bool copy_material(ovr_stress_report *r, ovr_arena *arena,
                          ovr_error *err)
{
    ovr_material *m = &r->material;
    double *z = ovr_arena_take(arena, m->depths, sizeof *z, err);
    unsigned char *complete = ovr_arena_take(arena, m->points, 1, err);
    if (!z || !complete)
        return false;
    memcpy(z, m->z, m->depths * sizeof *z);
    memcpy(complete, m->complete, m->points);
    m->z = z;
    m->complete = complete;
    return true;
}

/* Finds the largest circle of complete points from the minimum depth on. */
static void find_worst(ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const float *R = r->measure[OVR_MEASURE_CIRCLE];
    r->R_max = r->incomplete < m->points ? 0 : NAN;
    for (size_t j = 0; j < m->depths; j++) {
        if (m->z[j] < r->least_depth * (1 - 1e-9))
            continue;
        r->R_smooth = fmax(r->R_smooth, r->smooth[OVR_MEASURE_CIRCLE][j]);
        for (size_t k = 0; k < m->points; k++)
            if (m->complete[k] && (double)R[j * m->points + k] > r->R_max) {
                r->R_max = R[j * m->points + k];
                r->xi_R_max = m->start + (double)k * m->step;
                r->Z_R_max = m->z[j];
            }
    }
}

/* Computes the criterion's amplitude from the quantities already known. */
static void combine(const ovr_stress_setup *s, ovr_stress_report *r)
{
    static const ovr_measure of[] = {
        [OVR_CRITERION_CIRCLE] = OVR_MEASURE_CIRCLE,
        [OVR_CRITERION_ORTHOGONAL] = OVR_MEASURE_ORTHOGONAL,
        [OVR_CRITERION_CRITICAL_PLANE] = OVR_MEASURE_CRITICAL,
        [OVR_CRITERION_DANG_VAN] = OVR_MEASURE_CIRCLE,
        [OVR_CRITERION_VON_MISES] = OVR_MEASURE_VON_MISES,
        [OVR_CRITERION_TRESCA] = OVR_MEASURE_TRESCA};
    size_t n = r->material.points, depths = r->material.depths;
    bool tension = s->criterion == OVR_CRITERION_CIRCLE;
    const float *hydro = r->measure[OVR_MEASURE_HYDRO_MAX];
    for (size_t k = 0; k < n * depths; k++)
        r->amplitude[k] = r->measure[of[s->criterion]][k] +
                          (tension && hydro[k] > 0 ? (float)s->alpha * hydro[k]
                                                   : 0);
    for (size_t j = 0; j < depths; j++)
        r->amplitude_smooth[j] =
            r->smooth[of[s->criterion]][j] +
            (tension ? s->alpha * fmax(r->smooth[OVR_MEASURE_HYDRO_MAX][j], 0)
                     : 0);
}

static ovr_status find_amplitude(const ovr_stress_source *of,
                                 const ovr_stress_plan *plan,
                                 ovr_stress_report *r, ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(of->setup);
    combine(s, r);
    if (s->criterion != OVR_CRITERION_DANG_VAN)
        return OVR_OK;
    if (!of->path)
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van needs the stored "
                              "pressure of all nodes; set output.file");
    return stress_second_pass(of, plan, r, err);
}

/* Points at both ends of the material, a tenth each, are hardly affected by a
 * feature: their risk error is an estimate of the method's error at all points.
 */
static double length_error(const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    size_t ends = m->points / 10 + 1, counted = 0;
    double off = 0;
    for (size_t k = 0; k < m->points; k++)
        if ((k < ends || k + ends >= m->points) && m->complete[k]) {
            off += fabs(r->risk[k] / r->life->smooth_risk - 1);
            counted++;
        }
    return counted ? off / (double)counted * (double)m->points * m->step : NAN;
}

/* The von Mises stress below a smooth contact relative to its p_h, with a
 * margin for traction. */
static const double SMOOTH_VON_MISES = 0.6;

/* Returns why an elastic stress history has no life, or NULL. */
static const char *why_lifeless(const ovr_setup *setup,
                                const ovr_stress_report *r)
{
    double bearable = setup->bearable / setup->contact->ph;
    if (r->incomplete == r->material.points)
        return "no material point passes the whole contact within the run; "
               "set a later time.end";
    if (!(ovr_setup_physics(setup) & OVR_PHYSICS_PLASTIC) &&
        r->von_mises.value > SMOOTH_VON_MISES * bearable)
        return "the elastic stresses are those of a pressure above "
               "contact.bearable_pressure, at which the body yields";
    return NULL;
}

static ovr_status find_life(const ovr_setup *setup, ovr_stress_report *r,
                            ovr_life_result *result, ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    ovr_life_options life = s->life;
    double z;
    r->hertz = ovr_hertz_criterion(s->criterion, s->alpha,
                                   s->poisson[r->surface - 1], &z);
    r->limit = r->hertz * s->limit_pressure;
    life.limit = r->limit;
    life.least_depth = r->least_depth;
    const ovr_amplitudes of = {&r->material, r->amplitude, r->amplitude_smooth};
    if (ovr_life(&life, &of, r->risk, r->length, result, err))
        return OVR_BAD_INPUT;
    if (life.limits)
        r->limit = result->used_limit;
    r->length_error = length_error(r);
    r->ratio = NAN;
    r->lifeless = why_lifeless(setup, r);
    if (r->lifeless)
        *result = (ovr_life_result){
            .equivalent_length = NAN, .utilisation = NAN, .smooth_risk = NAN};
    if (s->raceway > 0 && !r->lifeless)
        r->ratio = ovr_life_ratio(&life, r->life->equivalent_length, s->raceway,
                                  s->count);
    return OVR_OK;
}

/* True if the stresses exceed those of any material: the film's law is outside
 * the range of real lubricants (Newtonian at high sliding speed and pressure).
 */
static bool is_beyond(const ovr_stress_report *r)
{
    const double maximum = 1e3;
    return !(r->max_shear.value < maximum && r->von_mises.value < maximum &&
             !(r->R_max >= maximum));
}

static const ovr_stress_extreme none = {NAN, NAN, NAN, NAN};

static void find_layers(const ovr_stress_plan *plan,
                        const ovr_material_history *history,
                        ovr_stress_report *r)
{
    const ovr_layer_extremes of = ovr_material_history_layers(history);
    const ovr_layered *layers = plan->options.layers;
    r->layer_von_mises = r->interface_shear = r->interface_tension = none;
    r->surface_tension = none;
    r->layer_utilisation = r->interface_utilisation = r->layer_fatigue = NAN;
    /* The time interval is too large to resolve any depth in the topmost layer
     */
    if (!layers || plan->options.depth_min >= layers->thickness[0])
        return;
    r->layer_von_mises = of.von_mises[0];
    for (int j = 1; j < layers->layers; j++)
        if (of.von_mises[j].value > r->layer_von_mises.value)
            r->layer_von_mises = of.von_mises[j];
    for (int j = 0; j < layers->layers; j++) {
        if (layers->yield[j] > 0)
            r->layer_utilisation = fmax(
                r->layer_utilisation, of.von_mises[j].value / layers->yield[j]);
        if (layers->strength[j] > 0)
            r->interface_utilisation = fmax(r->interface_utilisation,
                                            of.shear[j].value /
                                                layers->strength[j]);
    }
    r->interface_shear = of.shear[0];
    for (int j = 1; j < layers->layers; j++)
        if (of.shear[j].value > r->interface_shear.value)
            r->interface_shear = of.shear[j];
    r->interface_tension = of.tension;
    r->surface_tension = of.surface;
}

/* Maximum amplitude of complete points at the depths of a layer. */
static double layer_amplitude(const ovr_layered *layers, int layer,
                              const ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    double maximum = 0;
    for (size_t j = 0; j < m->depths; j++)
        for (size_t k = 0;
             ovr_layered_at(layers, m->z[j]) == layer && k < m->points; k++)
            if (m->complete[k])
                maximum = fmax(maximum,
                               (double)r->amplitude[j * m->points + k]);
    return maximum;
}

/* Utilization of the layers' own fatigue limits: amplitude relative to that of
 * a smooth dry contact of their material at the limiting pressure. */
static void find_layer_fatigue(const ovr_setup *setup,
                               const ovr_stress_plan *plan,
                               ovr_stress_report *r)
{
    const ovr_layered *layers = plan->options.layers;
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    if (isnan(r->layer_von_mises.value))
        return;
    for (int j = 0; j < layers->layers; j++) {
        double z, hertz = ovr_hertz_criterion(s->criterion, s->alpha,
                                              layers->layer[j].poisson, &z);
        if (layers->limit[j] > 0)
            r->layer_fatigue = fmax(r->layer_fatigue,
                                    layer_amplitude(layers, j, r) /
                                        (hertz * layers->limit[j]));
    }
}

/* Counts points above yield from the minimum depth on, and finds the maximum
 * depth of any. */
static void count_yielding(ovr_stress_report *r)
{
    const ovr_material *m = &r->material;
    const float *von_mises = r->measure[OVR_MEASURE_VON_MISES];
    size_t counted = 0, beyond = 0;
    r->yielding_depth = 0;
    for (size_t j = 0; j < m->depths; j++) {
        bool counts = m->z[j] >= r->least_depth * (1 - 1e-9);
        for (size_t k = 0; k < m->points; k++) {
            if (!m->complete[k])
                continue;
            bool yields = (double)von_mises[j * m->points + k] > r->yield;
            counted += counts;
            beyond += counts && yields;
            if (yields)
                r->yielding_depth = m->z[j];
        }
    }
    r->yielding_share = counted ? (double)beyond / (double)counted : NAN;
}

static void find_yield(const ovr_stress_plan *plan,
                       const ovr_material_history *history,
                       ovr_stress_report *r)
{
    double Y = plan->range.yield > 0 ? plan->range.yield : NAN;
    r->yield = Y;
    r->yield_ratio = r->von_mises;
    r->yield_ratio.value = r->von_mises.value / Y - 1;
    r->strip = ovr_material_history_strip(history);
    r->strip.value /= ovr_strip_collapse() * Y;
    r->of_first_yield = 1 / (ovr_first_yield(plan->range.poisson) * Y);
    r->of_shakedown = 1 / (ovr_shakedown_limit() * Y);
    r->yielding_share = r->yielding_depth = NAN;
    if (!isnan(Y))
        count_yielding(r);
}

static void withhold(ovr_stress_report *r, ovr_life_result *life)
{
    size_t n = r->material.points, depths = r->material.depths;
    r->none = "the shear stress of the film is far above what lubricants "
              "sustain; set lubricant.rheology, or stress.traction = no";
    r->max_shear = r->von_mises = r->layer_von_mises = none;
    r->interface_shear = r->interface_tension = r->surface_tension = none;
    r->layer_utilisation = r->interface_utilisation = r->layer_fatigue = NAN;
    r->yielding_share = r->yielding_depth = NAN;
    r->yield_ratio = none;
    r->R_max = r->xi_R_max = r->Z_R_max = r->R_smooth = NAN;
    for (int m = 0; m < OVR_MEASURES; m++) {
        for (size_t k = 0; k < n * depths; k++)
            r->measure[m][k] = NAN;
        for (size_t j = 0; j < depths; j++)
            r->smooth[m][j] = NAN;
    }
    r->fatigue = false;
    *life = (ovr_life_result){.equivalent_length = NAN, .utilisation = NAN};
}

/* Depth down to which maxima are not resolved: that of a pressure spike, or the
 * smallest depth of the plan; 0: all are resolved. */
static double unresolved_depth(const ovr_stress_source *of, double least)
{
    double spike = ovr_unresolved_depth(of->setup->mesh);
    return of->unresolved ? fmax(spike, (1 + 1e-6) * least) : 0;
}

ovr_stress_report *ovr_stress_report_make(const ovr_stress_source *of,
                                          const ovr_stress_plan *plan,
                                          const ovr_material_history *history,
                                          ovr_arena *arena, ovr_error *err)
{
    const ovr_setup *setup = of->setup;
    ovr_stress_report *r = ovr_arena_take(arena, 1, sizeof *r, err);
    ovr_life_result *life = ovr_arena_take(arena, 1, sizeof *life, err);
    if (!r || !life)
        return NULL;
    life->equivalent_length = NAN;
    r->life = life;
    r->surface = plan->surface;
    r->feature = plan->feature;
    r->fatigue = ovr_setup_stress(setup)->fatigue;
    r->direction = plan->direction;
    r->traction = plan->options.traction;
    r->no_traction = plan->no_traction;
    r->material = ovr_material_history_points(history);
    r->least_depth = plan->range.least_depth;
    if (!copy_material(r, arena, err))
        return NULL;
    r->ratio = r->limit = NAN;
    if (ovr_material_history_widest(history) * 4 > r->least_depth * (1 + 1e-6))
        r->least_depth = 4 * ovr_material_history_widest(
                                 history); /* adaptive steps */
    r->unresolved_depth = unresolved_depth(of, r->least_depth);
    if (!allocate_arrays(r, arena, err))
        return NULL;
    for (int m = 0; m < OVR_MEASURES; m++)
        ovr_material_history_measure(history, (ovr_measure)m, r->measure[m],
                                     r->smooth[m]);
    r->max_shear = ovr_material_history_max_shear(history);
    r->von_mises = ovr_material_history_von_mises(history);
    find_layers(plan, history, r);
    find_yield(plan, history, r);
    for (size_t k = 0; k < r->material.points; k++)
        r->incomplete += !r->material.complete[k];
    find_worst(r);
    if (is_beyond(r))
        withhold(r, life);
    if (r->fatigue &&
        (find_amplitude(of, plan, r, err) || find_life(setup, r, life, err)))
        return NULL;
    if (r->fatigue)
        find_layer_fatigue(setup, plan, r);
    return r;
}
