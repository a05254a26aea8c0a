/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses of a run: an observer of its steps, with a follower for each
 * surface, and stress fields at some snapshots. */
#include "physics/stress/stress.h"
#include "base/error.h"
#include "physics/companion.h"
#include "results/results.h"
#include "simulation/physics.h"
#include "stress/layered.h"
#include "stress/stress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { FIELDS = 8, SURFACES = 2 };

/* Fields of one surface to be written to the file. */
typedef struct shown {
    ovr_group group;
    ovr_group_axis axis[3]; /* time, depth, x */
    ovr_group_array array[FIELDS];
    ovr_group_attribute attribute[3];
    int which[FIELDS];
    float *values;
    size_t stride; /* nodes of the grid per stored node */
} shown;

typedef struct run_stress {
    ovr_arena arena;
    const ovr_setup *setup;
    const char *path; /* path of the run's file */
    ovr_stress_plan plan[SURFACES];
    ovr_follower *follower[SURFACES];
    ovr_stress_report *report[SURFACES];
    ovr_writer *writer;
    double *P;                   /* space for the total pressure on the solids
                                  */
    double *Q[SURFACES];         /* shear stress at the last time; NULL: none */
    ovr_stress *field[SURFACES]; /* NULL: no fields are stored */
    shown shown[SURFACES];
    double *x;
    /* state of the run */
    double before;    /* T of the previous step */
    double rows;      /* number of stored field rows */
    double snapshots; /* number of observed snapshots */
} run_stress;

/* ----------------------------------------------------------------- fields */

static double state_value(const ovr_at_rest *at, int which, double h, double d,
                          double tau)
{
    return ovr_stress_value((ovr_stress_field)which, (ovr_in_plane){h, d, tau},
                            at->poisson, at->x, at->y);
}

/* Reads the values at the nodes of the shallowest row. */
static ovr_status fill_depth(run_stress *s, int surface, size_t j,
                             ovr_error *err)
{
    const shown *f = &s->shown[surface];
    size_t n = f->axis[2].count, all = f->axis[1].count * n;
    ovr_stress_row row;
    if (ovr_stress_at_every_node(s->field[surface], j, &row, err))
        return OVR_NO_MEMORY;
    const ovr_at_rest at = ovr_layered_rest(&s->plan[surface].options,
                                            &s->plan[surface].range, row.z);
    for (size_t a = 0; a < f->group.arrays; a++)
        for (size_t i = 0; i < n; i++)
            f->values[a * all + j * n + i] = (float)state_value(
                &at, f->which[a], (double)row.mean[2 * i * f->stride],
                (double)row.shear[2 * i * f->stride],
                (double)row.shear[2 * i * f->stride + 1]);
    return OVR_OK;
}

static ovr_status store_fields(run_stress *s, const double *P, double T,
                               ovr_error *err)
{
    for (int k = 0; k < SURFACES; k++) {
        shown *f = &s->shown[k];
        size_t count = f->axis[1].count * f->axis[2].count;
        if (!s->follower[k])
            continue;
        ovr_stress_solve(s->field[k], P, s->Q[k], 0, OVR_STRESS_ALL_LEVELS);
        ovr_status status = OVR_OK;
        for (size_t j = 0; !status && j < f->axis[1].count; j++)
            status = fill_depth(s, k, j, err);
        if (!status)
            status = ovr_writer_append(s->writer, &f->group, (size_t)s->rows, T,
                                       f->values, count, err);
        if (status)
            return status;
    }
    s->rows++;
    return OVR_OK;
}

static void name_fields(const run_stress *s, shown *f)
{
    static const char *const texts[FIELDS] = {
        "normal stress along the surface",
        "normal stress across the surface",
        "orthogonal shear stress",
        "normal stress along the line of contact",
        "von Mises stress",
        "maximum shear stress in the plane",
        "maximum shear stress on any plane",
        "hydrostatic stress"};
    for (int a = 0; a < FIELDS; a++) {
        if (!(ovr_setup_stress(s->setup)->fields >> a & 1))
            continue;
        f->which[f->group.arrays] = a;
        f->array[f->group.arrays++] = (ovr_group_array){
            .name = ovr_stress_field_name((ovr_stress_field)a),
            .long_name = texts[a],
            .kind = OVR_KIND_PRESSURE,
            .rank = 3,
            .along = {0, 1, 2}};
    }
}

static ovr_status open_fields(run_stress *s, int surface, ovr_error *err)
{
    shown *f = &s->shown[surface];
    const double *z;
    size_t depths = ovr_stress_depths(s->field[surface], &z);
    ovr_stress_row row = ovr_stress_at(s->field[surface], 0);
    size_t n = (size_t)(5.2 / row.step) + 1;
    f->stride = (size_t)1 << row.level;
    f->axis[0] = (ovr_group_axis){"time", "time", OVR_KIND_TIME, 0, NULL};
    f->axis[1] = (ovr_group_axis){"depth", "depth below the surface",
                                  OVR_KIND_LENGTH, depths, z};
    s->x = ovr_arena_take(&s->arena, n, sizeof *s->x, err);
    for (size_t i = 0; s->x && i < n; i++)
        s->x[i] = row.start + (double)i * row.step;
    f->axis[2] = (ovr_group_axis){"x", "position along the contact",
                                  OVR_KIND_LENGTH, n, s->x};
    f->group = (ovr_group){surface ? "stress/surface_2" : "stress/surface_1",
                           3,
                           0,
                           2,
                           f->axis,
                           f->array,
                           f->attribute};
    f->attribute[0] = (ovr_group_attribute){
        "poisson", NULL, ovr_setup_stress(s->setup)->poisson[surface]};
    f->attribute[1] = (ovr_group_attribute){
        "traction", NULL, s->plan[surface].options.traction ? 1 : 0};
    const ovr_layered *layers = s->plan[surface].options.layers;
    if (layers)
        f->attribute[f->group.attributes++] = (ovr_group_attribute){
            "layers_end", NULL, ovr_layered_bottom(layers, layers->layers - 1)};
    name_fields(s, f);
    f->values = ovr_arena_take(&s->arena, f->group.arrays * depths * n,
                               sizeof *f->values, err);
    if (ovr_arena_status(&s->arena))
        return OVR_NO_MEMORY;
    return ovr_writer_group(s->writer, &f->group, true, err);
}

/* ------------------------------------------------------------------- state */

static ovr_status visit_material_history(ovr_material_history *p, int k,
                                         ovr_visit *visit, void *context,
                                         ovr_error *err)
{
    const ovr_memory_piece *piece;
    size_t pieces = ovr_material_history_state(p, &piece);
    ovr_status status = OVR_OK;
    for (size_t i = 0; !status && i < pieces; i++) {
        char name[64];
        snprintf(name, sizeof name, "surface %d %s", k + 1, piece[i].name);
        status = visit(context, name, piece[i].memory, piece[i].bytes, err);
    }
    return status;
}

static ovr_status visit_state(void *data, ovr_visit *visit, void *context,
                              ovr_error *err)
{
    run_stress *s = data;
    ovr_status status = visit(context, "stress before", &s->before,
                              sizeof s->before, err);
    if (!status)
        status = visit(context, "stress rows", &s->rows, sizeof s->rows, err);
    if (!status)
        status = visit(context, "stress snapshots", &s->snapshots,
                       sizeof s->snapshots, err);
    for (int k = 0; !status && k < SURFACES; k++)
        if (s->follower[k])
            status = visit_material_history(ovr_follower_wait(s->follower[k]),
                                            k, visit, context, err);
    for (int k = 0; !status && k < SURFACES; k++)
        if (s->Q[k])
            status = visit(
                context, k ? "surface 2 traction" : "surface 1 traction",
                s->Q[k], s->plan[k].options.nodes * sizeof(double), err);
    return status;
}

/* ---------------------------------------------------------------- creation */

/* Creates the field of a surface; both have the same options except for layers.
 */
static ovr_status make_field(run_stress *s, int k,
                             const ovr_allocator *allocator, ovr_error *err)
{
    const ovr_layered *none = s->plan[0].options.layers;
    if (k && s->field[0] && !none && !s->plan[k].options.layers) {
        s->field[k] = s->field[0];
        return OVR_OK;
    }
    s->field[k] = ovr_stress_create(&s->plan[k].options, allocator, err);
    return s->field[k] ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status follow(run_stress *s, const ovr_state *state,
                         const ovr_allocator *allocator, ovr_error *err)
{
    ovr_stress_sight seen = ovr_stress_sight_of(s->setup);
    seen.nodes = state->n;
    s->P = ovr_arena_take(&s->arena, state->n, sizeof *s->P, err);
    if (!s->P)
        return OVR_NO_MEMORY;
    for (int k = 0; k < SURFACES; k++) {
        if (!(ovr_setup_stress(s->setup)->surfaces >> k & 1))
            continue;
        if (ovr_stress_planned(s->setup, k + 1, seen, &s->plan[k], err))
            return OVR_BAD_INPUT;
        s->follower[k] = ovr_follower_create(&s->plan[k], allocator, err);
        if (s->plan[k].options.traction)
            s->Q[k] = ovr_arena_take(&s->arena, state->n, sizeof(double), err);
        if (!s->follower[k] || (s->plan[k].options.traction && !s->Q[k]))
            return OVR_NO_MEMORY;
        if (ovr_setup_stress(s->setup)->every &&
            make_field(s, k, allocator, err))
            return OVR_NO_MEMORY;
    }
    return OVR_OK;
}

/* Checks before the run that everything read by the second pass will be stored.
 */
static ovr_status check_second_pass(const ovr_setup *setup, const char *output,
                                    ovr_error *err)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    const ovr_output *o = setup->output;
    if (!s->fatigue || s->criterion != OVR_CRITERION_DANG_VAN)
        return OVR_OK;
    if (!output || !isnan(o->from) || !isnan(o->to) || o->stride > 1)
        return ovr_fail_about(err, "criterion",
                              "criterion = dang-van needs the stored "
                              "pressure of all nodes; set output.file");
    for (int k = 0; s->traction && k < SURFACES; k++)
        if ((s->surfaces >> k & 1) &&
            !(o->fields &
              ovr_field_bit(k ? "shear_stress_2" : "shear_stress_1")))
            return ovr_fail_about(err, "criterion",
                                  "criterion = dang-van with traction needs "
                                  "the stored shear stress; add "
                                  "shear_stress_%d to output.fields",
                                  k + 1);
    return OVR_OK;
}

static void release(void *own)
{
    run_stress *s = own;
    for (int k = 0; k < SURFACES; k++)
        ovr_follower_free(s->follower[k]);
    if (s->field[1] != s->field[0])
        ovr_stress_free(s->field[1]);
    ovr_stress_free(s->field[0]);
    ovr_arena arena = s->arena;
    ovr_arena_release(&arena);
}

static ovr_status make(const ovr_accompanied_run *run, void **own,
                       ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena->allocator;
    ovr_arena arena = ovr_arena_make(allocator);
    run_stress *s = NULL;
    ovr_status status = check_second_pass(run->setup, run->output, err);
    if (!status)
        s = ovr_arena_take(&arena, 1, sizeof *s, err);
    if (!s)
        return status ? status : OVR_NO_MEMORY;
    s->arena = arena;
    s->setup = run->setup;
    status = follow(s, ovr_simulation_state(run->sim), allocator, err);
    if (status)
        release(s);
    else
        *own = s;
    return status;
}

static void set_path(void *own, const ovr_accompanied_run *run)
{
    ((run_stress *)own)->path = run->output;
}

static ovr_status open_file(void *own, const ovr_accompanied_run *run,
                            ovr_error *err)
{
    run_stress *s = own;
    ovr_status status = OVR_OK;
    s->writer = run->writer;
    set_path(s, run);
    for (int k = 0; !status && k < SURFACES; k++)
        if (s->field[k])
            status = open_fields(s, k, err);
    return status;
}

static ovr_status restored(void *own, double T, ovr_error *err)
{
    const run_stress *s = own;
    if (s->before != T)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the checkpoint at T = %g contains no stresses; run "
                        "the case again from its start",
                        T);
    return OVR_OK;
}

/* --------------------------------------------------------------- observing */

static ovr_status observe(void *data, const ovr_simulation *sim, ovr_error *err)
{
    run_stress *s = data;
    const ovr_state *state = ovr_simulation_state(sim);
    const double *P = ovr_solid_pressure(sim, s->P);
    double before = s->before;
    for (int k = 0; k < SURFACES; k++) {
        if (!s->follower[k])
            continue;
        ovr_moment m = ovr_stress_moment(s->setup, &s->plan[k], state->T,
                                         before);
        if (s->Q[k])
            ovr_traction_now(&s->plan[k], sim, s->Q[k]);
        ovr_follower_post(s->follower[k],
                          state->step ? OVR_POST_STEP : OVR_POST_BEGIN, P,
                          s->Q[k], &m);
    }
    s->before = state->T;
    if (!(s->field[0] || s->field[1]) || !s->writer ||
        !ovr_writer_stores(s->writer, state->step, state->T))
        return OVR_OK;
    bool due = fmod(s->snapshots, (double)ovr_setup_stress(s->setup)->every) ==
               0;
    s->snapshots++;
    return due ? store_fields(s, P, state->T, err) : OVR_OK;
}

/* ------------------------------------------------------------- end of a run */

/* The end closes a stress history; a run that is continued later must remain
 * open. */
static void **save(ovr_material_history *p, ovr_arena *arena, ovr_error *err)
{
    const ovr_memory_piece *piece;
    size_t pieces = ovr_material_history_state(p, &piece);
    void **saved = ovr_arena_take(arena, pieces, sizeof *saved, err);
    for (size_t i = 0; saved && i < pieces; i++) {
        saved[i] = ovr_arena_take(arena, piece[i].bytes, 1, err);
        if (!saved[i])
            return NULL;
        memcpy(saved[i], piece[i].memory, piece[i].bytes);
    }
    return saved;
}

static void restore(ovr_material_history *p, void **saved)
{
    const ovr_memory_piece *piece;
    size_t pieces = ovr_material_history_state(p, &piece);
    for (size_t i = 0; i < pieces; i++)
        memcpy(piece[i].memory, saved[i], piece[i].bytes);
}

static ovr_status finish_surface(run_stress *s, int k,
                                 const ovr_simulation *sim, ovr_error *err)
{
    double T = ovr_simulation_state(sim)->T;
    ovr_moment m = ovr_stress_moment(s->setup, &s->plan[k], T, T);
    ovr_material_history *history = ovr_follower_wait(s->follower[k]);
    ovr_arena arena = ovr_arena_make(&s->arena.allocator);
    void **saved = save(history, &arena, err);
    s->plan[k].range.reference = ovr_material_history_reference(history);
    /* The second pass reads what is stored */
    if (saved && s->writer && ovr_writer_flush(s->writer, err))
        saved = NULL;
    if (saved) {
        ovr_material_history_end(history, ovr_solid_pressure(sim, s->P),
                                 s->Q[k], &m);
        const ovr_stress_source of = {
            s->setup, s->path,
            ovr_simulation_statistics(sim)->P_max_unresolved};
        s->report[k] = ovr_stress_report_make(&of, &s->plan[k], history,
                                              &s->arena, err);
        restore(history, saved);
    }
    ovr_arena_release(&arena);
    if (!s->report[k])
        return err->status;
    return s->writer ? ovr_stress_store(s->writer, s->setup, s->report[k], err)
                     : OVR_OK;
}

/* Closes the material histories and writes their groups. */
static ovr_status finish(void *own, const ovr_accompanied_run *run,
                         ovr_error *err)
{
    run_stress *s = own;
    ovr_status status = OVR_OK;
    for (int k = 0; !status && k < SURFACES; k++)
        if (s->follower[k])
            status = finish_surface(s, k, run->sim, err);
    for (int k = 0; k < SURFACES; k++)
        run->stress[k] = s->report[k];
    return status;
}

static const ovr_companion companion = {.make = make,
                                        .release = release,
                                        .open = open_file,
                                        .set_path = set_path,
                                        .observe = observe,
                                        .visit = visit_state,
                                        .restored = restored,
                                        .finish = finish};

/* ------------------------------------------------------------------ case */

static double memory(const void *form)
{
    return ovr_material_histories_memory(
        ((const ovr_stress_setup *)form)->setup);
}

static void report_limit(const ovr_setup *setup, int k, ovr_physics_line *line,
                         void *data)
{
    const ovr_stress_setup *s = ovr_setup_stress(setup);
    double ph = setup->contact->ph * 1e-6, z;
    double hertz = ovr_hertz_criterion(s->criterion, s->alpha, s->poisson[k],
                                       &z);
    char text[160], limit[80] = "no limit";
    if (s->life.limits) {
        snprintf(text, sizeof text,
                 "%s: limit by depth, %.4g MPa at %.3g um to %.4g MPa at %.3g "
                 "um; smooth contact %.4g p_h at Z = %.3g",
                 ovr_criterion_name(s->criterion), s->life.limit_A[0] * ph,
                 s->life.limit_z[0] * setup->contact->b * 1e6,
                 s->life.limit_A[s->life.limits - 1] * ph,
                 s->life.limit_z[s->life.limits - 1] * setup->contact->b * 1e6,
                 hertz, z);
        line(data, "fatigue", text);
        return;
    }
    if (s->limit_pressure > 0 && isfinite(ph))
        snprintf(limit, sizeof limit, "limit %.4g p_h = %.4g MPa",
                 hertz * s->limit_pressure, hertz * s->limit_pressure * ph);
    else if (s->limit_pressure > 0)
        snprintf(limit, sizeof limit, "limit %.4g p_h",
                 hertz * s->limit_pressure);
    snprintf(text, sizeof text, "%s: %s; smooth contact %.4g p_h at Z = %.3g",
             ovr_criterion_name(s->criterion), limit, hertz, z);
    line(data, "fatigue", text);
}

static void report_yield(const ovr_setup *setup, int k, ovr_physics_line *line,
                         void *data)
{
    double Y = ovr_setup_stress(setup)->yield[k],
           ph = setup->contact->ph * 1e-6;
    double first = ovr_first_yield(ovr_setup_stress(setup)->poisson[k]) * Y;
    double shakedown = ovr_shakedown_limit() * Y;
    char text[240], megapascals[80] = "";
    if (isfinite(ph))
        snprintf(megapascals, sizeof megapascals,
                 " (%.4g MPa: %.4g and %.4g MPa)", Y * ph, first * ph,
                 shakedown * ph);
    snprintf(text, sizeof text,
             "surface %d: Y = %.4g p_h, first yield of the smooth "
             "contact at %.4g p_h, shakedown limit %.4g p_h%s",
             k + 1, Y, first, shakedown, megapascals);
    line(data, "yield stress", text);
}

/* Reports depths, memory, and the limits in MPa. */
static void report_case(const ovr_physics_case *of, const void *form,
                        ovr_physics_line *line, void *data)
{
    const ovr_stress_setup *s = form;
    const ovr_setup *setup = s->setup;
    char text[160];
    double minimum;
    (void)of;
    if (ovr_setup_stress_depth(setup, &minimum, NULL))
        return;
    snprintf(text, sizeof text,
             "Z = %.4g to %.4g, %g depths per octave; %.3g MB, doubles the "
             "computing time",
             minimum, s->depth_max, s->per_octave, memory(s) / 1e6);
    line(data, "stress grid", text);
    snprintf(text, sizeof text, "%s%s",
             s->traction ? "shear stress of the film" : "none: ",
             s->traction ? "" : s->no_traction);
    line(data, "traction", text);
    for (int k = 0; k < SURFACES; k++)
        if ((s->surfaces >> k & 1) && s->yield[k] > 0)
            report_yield(setup, k, line, data);
    for (int k = 0; s->fatigue && k < SURFACES; k++)
        if (s->surfaces >> k & 1)
            report_limit(setup, k, line, data);
}

static const ovr_physics_in_case in_case = {.section = ovr_stress_sections,
                                            .sections = 2,
                                            .behind = "paper",
                                            .form = sizeof(ovr_stress_setup),
                                            .resolve = ovr_stress_resolve,
                                            .effects = ovr_stress_state,
                                            .node_seconds = 2.5e-7,
                                            .describe = report_case,
                                            .memory = memory};

static const ovr_physics_in_output in_output = {.companion = &companion};

const ovr_physics ovr_physics_stress = {
    .name = "stresses", .in_case = &in_case, .in_output = &in_output};
