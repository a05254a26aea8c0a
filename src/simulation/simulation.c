/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creation, release and access; the work is in steady.c and step.c. */
#include "simulation/simulation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/given.h"
#include "multigrid/field.h"
#include "multigrid/hybrid.h"
#include "multigrid/line.h"
#include "simulation/conflicts.h"
#include "simulation/observe.h"
#include "simulation/physics.h"

/* ------------------------------------------------------------- work arrays */

static void allocate_work(ovr_simulation *sim, ovr_error *err)
{
    sim->work = ovr_arena_take(&sim->arena, 1, sizeof *sim->work, err);
    for (int k = 0; sim->work && k < OVR_WORK_ARRAYS; k++)
        OVR_TAKE_NODES(sim, err, &sim->work->array[k]);
}

double *ovr_work_take(const ovr_simulation *sim)
{
    ovr_work *work = sim->work;
#ifdef OVR_CHECKED
    if (work->taken == OVR_WORK_ARRAYS)
        abort();
    for (size_t i = 0; i < sim->maximum; i++)
        work->array[work->taken][i] = NAN;
#endif
    return work->array[work->taken++];
}

void ovr_work_give(const ovr_simulation *sim, const double *array)
{
    ovr_work *work = sim->work;
#ifdef OVR_CHECKED
    if (work->taken == 0 || array != work->array[work->taken - 1])
        abort();
#endif
    (void)array;
    work->taken--;
}

/* -------------------------------------------------------------- simulation */

static ovr_status allocate_arrays(ovr_simulation *sim, ovr_error *err)
{
    OVR_TAKE_NODES(sim, err, &sim->now.weights, &sim->shapes.S,
                   &sim->shapes.S_past, &sim->start.saved,
                   &sim->start.saved_before, &sim->start.lacking,
                   &sim->shear.stress);
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++) {
        if (ovr_field_rows[k].shown && sim->finest->f.all[k])
            OVR_TAKE_NODES(sim, err, &sim->now.all[k]);
        for (int ago = 0; ago < ovr_field_rows[k].past; ago++)
            OVR_TAKE_NODES(sim, err, &sim->past.all[k][ago]);
    }
    allocate_work(sim, err);
    ovr_inflow_take(sim, err);
    return ovr_arena_status(&sim->arena);
}

ovr_cycling ovr_simulation_cycling(const ovr_simulation *sim, int finer_bottom)
{
    enum { LARGEST = 7 }; /* on level 8 a dense solve takes a second */
    const ovr_options *o = &sim->options;
    const ovr_hierarchy *grids = &sim->grids;
    bool finer = grids->coarsest + finer_bottom <
                 (grids->finest < LARGEST + 1 ? grids->finest : LARGEST + 1);
    return (ovr_cycling){
        .smoothing = {.relax = o->smoother == OVR_LINE ? ovr_relax_line
                                                       : ovr_relax_hybrid,
                      .limit = 0.1,
                      .switch_value = o->smoother == OVR_GAUSS_SEIDEL ? -1
                                      : o->smoother == OVR_DIPOLE
                                          ? INFINITY
                                          : o->switch_value,
                      .relax_seidel = o->relax_seidel,
                      .relax_dipole = o->relax_dipole},
        .sweeps_before = o->sweeps_before,
        .sweeps_after = o->sweeps_after,
        .index = o->cycle_index,
        .bottom = grids->coarsest + (finer ? finer_bottom : 0),
        .newton_steps = 1,
        .newton_limit = 0.3,
        .paper_balance = o->paper_balance,
        .correction = 1};
}

/* The finest level that is not relaxed in lanes: Newton's, or all. */
static int ordered_level(const ovr_options *o, const ovr_hierarchy *grids)
{
    if (o->smoother != OVR_LINE || o->paper_balance)
        return o->level;
    int newton = grids->content ? 2 : 1;
    int above = o->level - o->coarsest_level;
    return o->coarsest_level + (newton < above ? newton : above);
}

/* True if the mean between nodes is logarithmic. If the mesh size exceeds 0.5
 * H^(2/3), the length of the inlet's pressure rise (failure.c), the pressure
 * rises within one or two mesh sizes and ln m changes by tens. Cycles with the
 * logarithmic mean then do not converge (M = 900, L = 5 on level 6: no
 * solution, with the mean by the gap 173 cycles; M = 300, L = 5: 898 and 50
 * cycles). The film thickness has an error of tens of per cent with either
 * mean. */
static bool is_logarithmic(const ovr_options *o, const ovr_target *target)
{
    const double widest = 0.5;
    double D = (o->outlet - o->inlet) / (double)(ovr_level_nodes(o->level) - 1);
    return o->faces == OVR_FACES_LOGARITHMIC &&
           !(D > widest * pow(ovr_target_film(target, 1), 2. / 3));
}

static ovr_status build(ovr_simulation *sim, ovr_error *err)
{
    const ovr_options *o = &sim->options;
    ovr_hierarchy *grids = &sim->grids;
    ovr_hierarchy_form form = {.coarsest = o->coarsest_level,
                               .finest = o->level,
                               .X_a = o->inlet,
                               .X_b = o->outlet};
    for (int l = 0; l < OVR_LEVELS; l++)
        form.mlmi[l] = ovr_options_mlmi(o, l);
    grids->kernels = ovr_kernels_choose(NULL);
    grids->fluid = (ovr_fluid){.lubricant = sim->lubricant,
                               .lambda = sim->contact.lambda,
                               .sliding = ovr_sliding(sim, 0),
                               .by_gap = o->faces != OVR_FACES_ARITHMETIC};
    sim->target = (ovr_target){
        .M = sim->contact.M, .L = sim->contact.L, .Cw = 1, .Cu = 1, .c = 1};
    grids->fluid.logarithmic = is_logarithmic(o, &sim->target);
    sim->target.fluid = grids->fluid;
    ovr_physics_prepare(sim);
    grids->ordered = ordered_level(o, grids);
    if (ovr_hierarchy_build(grids, &form, &sim->arena, err))
        return OVR_NO_MEMORY;
    sim->finest = &grids->level[o->level];
    sim->now.n = sim->finest->grid.n;
    sim->now.X = sim->finest->grid.X;
    sim->maximum = sim->now.n;
    if (ovr_physics_choose(sim, err))
        return OVR_NO_MEMORY;
    sim->now.n = sim->maximum;
    ovr_status status = allocate_arrays(sim, err);
    sim->now.n = sim->finest->grid.n;
    return status;
}

/* Sets up a simulation and allocates all its memory; hardly any of it is
 * written. */
static ovr_simulation *set_up(ovr_arena arena, const ovr_contact *contact,
                              const ovr_lubricant *lubricant,
                              const ovr_options *options, ovr_error *err)
{
    ovr_simulation *sim = ovr_arena_take(&arena, 1, sizeof *sim, err);
    if (!sim)
        return NULL;
    sim->arena = arena;
    sim->contact = *contact;
    sim->lubricant = *lubricant;
    sim->options = *options;
    ovr_statistics_unknown(&sim->statistics);
    sim->physics.list = ovr_physics_list;
    sim->shapes.moving = NAN;
    sim->scheme = ovr_scheme_record(sim->options.scheme);
    if (build(sim, err)) {
        ovr_simulation_free(sim);
        sim = NULL;
    }
    return sim;
}

ovr_simulation *ovr_simulation_create(const ovr_contact *contact,
                                      const ovr_lubricant *lubricant,
                                      const ovr_options *options,
                                      const ovr_allocator *allocator,
                                      ovr_error *err)
{
    ovr_options resolved;
    ovr_contact of;
    ovr_lubricant oil;
    ovr_simulation *sim;
    if (OVR_TAKE(ovr_options, &resolved, options, err) ||
        OVR_TAKE(ovr_contact, &of, contact, err) ||
        OVR_TAKE(ovr_lubricant, &oil, lubricant, err))
        return NULL;
    if (ovr_options_resolve(&of, &resolved, err))
        return NULL;
    if (ovr_conflict_check(
            ovr_model_features_of(&resolved) |
                ovr_model_feature_bit(OVR_MODEL_FLOW_LAW,
                                      oil.rheology != OVR_NEWTONIAN),
            err))
        return NULL;
    sim = set_up(ovr_arena_make(allocator), &of, &oil, &resolved, err);
    if (!sim)
        return NULL;
    ovr_simulation_fill(sim);
    return sim;
}

ovr_simulation *ovr_simulation_counted(const ovr_options *options)
{
    const ovr_contact contact = {.M = 20, /* used for automatic options */
                                 .L = 10};
    const ovr_lubricant lubricant = {0};
    ovr_options o = ovr_options_default();
    if (OVR_TAKE(ovr_options, &o, options, NULL))
        return NULL;
    if (ovr_options_resolve(&contact, &o, NULL))
        return NULL;
    return set_up(ovr_arena_counting(), &contact, &lubricant, &o, NULL);
}

double ovr_simulation_memory(const ovr_options *options)
{
    ovr_simulation *sim = ovr_simulation_counted(options);
    double bytes = sim ? (double)sim->arena.bytes : INFINITY;
    ovr_simulation_free(sim);
    return bytes;
}

void ovr_simulation_free(ovr_simulation *sim)
{
    if (sim) {
        ovr_arena arena = sim->arena;
        OVR_EACH_PHYSICS(sim, p, in_solve, release)
            p->is->in_solve->release(p->own);
        ovr_arena_release(&arena);
    }
}

const ovr_options *ovr_simulation_options(const ovr_simulation *sim)
{
    return !sim ? NULL : &sim->options;
}

void ovr_simulation_sides(ovr_simulation *sim, ovr_heights *heights_1,
                          ovr_heights *heights_2)
{
    if (!sim)
        return;
    sim->shapes.sides[0] = heights_1;
    sim->shapes.sides[1] = heights_2;
    sim->shapes.sides_of = sim->shapes.heights;
    sim->shapes.sides_data = sim->shapes.data;
}

void ovr_simulation_surface(ovr_simulation *sim, ovr_heights *heights,
                            void *data)
{
    if (!sim)
        return;
    sim->shapes.heights = heights;
    sim->shapes.data = data;
    sim->shapes.across = NULL;
    if (heights)
        return;
    memset(sim->shapes.S, 0, sim->now.n * sizeof *sim->shapes.S);
    memset(sim->shapes.S_past, 0, sim->now.n * sizeof *sim->shapes.S_past);
}

void ovr_simulation_across(ovr_simulation *sim, ovr_heights_across *heights)
{
    if (!sim)
        return;
    sim->shapes.across = heights;
}

void ovr_simulation_show(ovr_simulation *sim, size_t line)
{
    if (!sim || !sim->physics.solver)
        return;
    size_t lines, shown;
    ovr_simulation_lines(sim, &lines, &shown);
    sim->physics.solver->is->in_solve->solver->show(
        sim, sim->physics.solver->own, line);
    sim->state.line = line < lines ? line : shown;
}

const double *ovr_simulation_lines(const ovr_simulation *sim, size_t *count,
                                   size_t *shown)
{
    *count = 1;
    *shown = 0;
    return sim && sim->physics.solver
               ? sim->physics.solver->is->in_solve->solver->lines(
                     sim->physics.solver->own, count, shown)
               : NULL;
}

void ovr_simulation_histories(ovr_simulation *sim, const ovr_history *load,
                              const ovr_history *speed)
{
    if (!sim)
        return;
    sim->histories.load = load;
    sim->histories.speed = speed;
}

void ovr_simulation_radius(ovr_simulation *sim, const ovr_history *radius,
                           const ovr_history *radius_1, bool convected)
{
    if (!sim)
        return;
    sim->histories.radius = radius;
    sim->histories.radius_1 = radius_1;
    sim->histories.convected = convected;
}

const ovr_state *ovr_simulation_state(const ovr_simulation *sim)
{
    return !sim ? NULL : &sim->state;
}

const ovr_observation *ovr_simulation_observation(const ovr_simulation *sim)
{
    return !sim ? NULL : &sim->observation;
}

const ovr_statistics *ovr_simulation_statistics(const ovr_simulation *sim)
{
    return !sim ? NULL : &sim->statistics;
}

ovr_status ovr_simulation_begin(ovr_simulation *sim, const char *what,
                                ovr_error *err)
{
    if (sim->busy)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: functions called by a running simulation must "
                        "not advance it",
                        what);
    sim->busy = true;
    return OVR_OK;
}

void ovr_simulation_end(ovr_simulation *sim)
{
    sim->busy = false;
}
