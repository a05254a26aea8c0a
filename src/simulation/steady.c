/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady solution: full multigrid (multigrid/full.h) and, if it fails,
 * other strategies; then the effects of the physical models (physics.h).
 */
#include "simulation/steady.h"

#include <math.h>
#include <string.h>

#include "base/given.h"
#include "contact/contact.h"
#include "contact/film_formula.h"
#include "multigrid/starved.h"
#include "simulation/internal.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/physics.h"
#include "simulation/simulation.h"
#include "simulation/step_cycles.h"

/* ---------------------------------------------------- Record of refinements */

/*
 * Convergence to the truncation error, checked as in the paper by comparing
 * converged solutions of successive levels. The norm is
 *     |P| = D sum |P_i| / (pi/2),
 * the load that a pressure carries relative to the nominal one.
 *   difference  |P^l - P^(l-1)| at the nodes of level l-1: the discretization
 *               error of the coarser one, nearly;
 *   change      |dP| of the last cycle on level l;
 *   algebraic   change q/(1 - q), q the residual reduction factor of the last
 *               cycle: the change by all further cycles
 */

static double distance(const ovr_level *level, const double *a, size_t stride,
                       const double *b)
{
    return ovr_grid_distance(&level->grid, a, stride, b) / OVR_NOMINAL_LOAD;
}

static void note(ovr_simulation *sim, const ovr_level *level,
                 const ovr_full_status *status)
{
    ovr_refinement *to = &sim->start.refinement[sim->start.refinements++];
    double *now = ovr_work_take(sim), *before = ovr_work_take(sim);
    double q = status->factor < 0.95 ? status->factor : 0.95;
    *to = (ovr_refinement){.level = level->number,
                           .nodes = level->grid.n,
                           .cycles = status->cycles,
                           .residual = isfinite(status->defect.imbalance)
                                           ? status->defect.imbalance
                                           : NAN,
                           .factor = status->factor,
                           .H_cen = status->defect.centre};
    ovr_level_read(&sim->grids, level, level->f.H, now);
    to->H_min =
        now[1 + sim->grids.kernels->extreme(level->grid.n - 2, 1, now + 1)];
    ovr_level_read(&sim->grids, level, level->f.P, now);
    ovr_level_read(&sim->grids, level, level->f.entry, before);
    if (status->cycles)
        to->change = distance(level, now, 1, before);
    to->algebraic = to->change * q / (1 - q);
    to->difference = distance(level - 1, now, 2, sim->start.saved);
    ovr_work_give(sim, before);
    ovr_work_give(sim, now);
}

/* Records the progress of full multigrid (steady.c). */
static void refinement_watch(void *data, const ovr_level *level,
                             ovr_full_event event,
                             const ovr_full_status *status)
{
    ovr_simulation *sim = data;
    if (event == OVR_FULL_ENDS)
        note(sim, level, status);
    if (event == OVR_FULL_BEGINS)
        ovr_level_read(&sim->grids, level, level->f.P, sim->start.saved);
    if (event == OVR_FULL_CYCLES) {
        double *P = ovr_work_take(sim);
        ovr_level_read(&sim->grids, level, level->f.P, P);
        ovr_level_write(&sim->grids, level, P, level->f.entry);
        ovr_work_give(sim, P);
    }
}

const ovr_refinement *ovr_simulation_refinements(const ovr_simulation *sim,
                                                 int *count)
{
    if (!sim || !count)
        return NULL;
    *count = sim->start.refinements;
    return sim->start.refinement;
}

/* ------------------------------------------------------- Film of a strategy */

/* Computes the film of a steady solve for the present strategy, also for
 * physical models with their own solution method. */

/*
 * Returns a tolerance that keeps the algebraic error of smooth films far below
 * the discretization error.  R = 1e-7 leaves at most 6e-12 of H_cen and 1e-10
 * of H_min (levels 7 to 10, M = 5 to 200).  The discretization error of order 4
 * is at least 4e-9 and 1.8e-7 there.  On finer grids the tolerance follows D^2,
 * as the discretization errors do.  With mass-conserving cavitation the error
 * is larger at the same R.
 */
static double smooth_tolerance(const ovr_simulation *sim,
                               const ovr_level *level)
{
    double meshes = ovr_grid_mesh(&level->grid) / (5.5 / 7168);
    return sim->grids.conserving ? 0 : 1e-7 * fmin(1, meshes * meshes);
}

/*
 * Tolerance of a level on which H at X = 0 is the given value. On coarser
 * levels of nested iteration fifty times the final tolerance suffices. Usually
 * one cycle reaches it, with an algebraic error below the discretization error
 * of the level, and the solve is a fifth faster than with two cycles per level.
 * After two cycles on the finest level, the ratio of algebraic to
 * discretization error is 0.020, 0.022 and 0.006 (M = 20, L = 10, levels 8, 10
 * and 12). With two cycles on all levels it is 0.015, 0.017 and 0.000. Rough
 * surfaces contain waves of a few mesh sizes. An error that is negligible for
 * smooth films is far below the discretization error of these waves.
 */
double ovr_steady_tolerance(const void *data, const ovr_level *level, double H)
{
    const ovr_simulation *sim = data;
    const double on_the_way = 50, rough = 1e-6;
    double enough = sim->start.grown ? rough : smooth_tolerance(sim, level);
    const ovr_options *o = &sim->options;
    double truncation = ovr_truncation_tolerance(
        sim, ovr_grid_mesh(&level->grid), H);
    if (level != sim->finest)
        return on_the_way * truncation;
    if (o->tolerance > 0)
        return o->tolerance;
    if (o->stop == OVR_STOP_TRUNCATION)
        return truncation;
    return fmax(enough,
                ovr_negligible_tolerance(sim, ovr_grid_mesh(&level->grid), H));
}

int ovr_steady_max_cycles(const ovr_simulation *sim, int unless_given)
{
    return sim->options.max_cycles ? sim->options.max_cycles : unless_given;
}

ovr_defect ovr_steady_cycles(ovr_simulation *sim, const ovr_full *how,
                             int *cycles)
{
    ovr_full last = *how;
    last.fixed = false;
    if (sim->start.grown)
        return ovr_steady_settled(sim, how, cycles);
    if (sim->grids.conserving)
        return ovr_content_cycles(&sim->grids, &last, sim->finest, cycles);
    ovr_level_refresh(&sim->grids, sim->finest);
    return ovr_full_cycles(&sim->grids, sim->finest, &last, cycles);
}

ovr_defect ovr_steady_film(ovr_simulation *sim, const ovr_full *how,
                           int *cycles)
{
    if (sim->start.grown)
        return ovr_steady_grown(sim, how, cycles);
    return ovr_full_multigrid(&sim->grids, &sim->target, *how, cycles);
}

/* A fixed number of cycles must reach the discretization error. */
bool ovr_steady_found(const ovr_simulation *sim, const ovr_outcome *outcome)
{
    int done = sim->start.refinements;
    if (!ovr_surfaces_apart(sim))
        return false;
    if (sim->options.stop == OVR_STOP_FIXED && done)
        return sim->start.refinement[done - 1].algebraic <=
               sim->start.refinement[done - 1].difference;
    return ovr_below(
        outcome->defect,
        ovr_steady_tolerance(sim, sim->finest, outcome->defect.centre));
}

/* --------------------------------------------------------------- Strategies */

/* Strategies that a solve tries in this order until it converges: the ordinary
 * one; with surface features, features that grow from smooth surfaces; with a
 * rheological model more sweeps, then the Newtonian film first; smaller steps
 * in load on a finer level, also with a finer coarsest grid, more sweeps and
 * stronger damping; the same with faces = gap, whose derivatives are smaller at
 * the flanks of a spike narrower than a mesh size (M = 5, L = 15, level 10, of
 * 5 p_h: 258 cycles, no solution with the logarithmic mean); finally, for
 * smooth surfaces, steps in time. */
typedef struct strategy {
    bool flow_law;      /* only with a rheological model */
    bool thin_last;     /* rheological model applied last, from the Newtonian
                         * film */
    double load_factor; /* largest step of the continuation in load */
    double mesh;        /* maximum D/H^(2/3), mesh size relative to the length
                         * of the inlet */
    int sweeps, newton_steps, finer_bottom;
    double limit, newton_limit; /* maximum changes of P */
    const char *what;
    bool grown; /* pseudo-time steps in which features grow */
    bool gap;   /* use faces = gap in place of the logarithmic mean */
    bool other; /* of solvers other than that of the line contact */
} strategy;

static const strategy strategies[] = {
    {false, false, 1.6, 0.3, 0, 1, 0, 0.1, 0.3, "", false, false, false},
    [OVR_STRATEGY_GROWTH] = {false, false, 1.6, 0.3, 0, 1, 0, 0.1, 0.3,
                             "from smooth surfaces, with growing features",
                             true, false, false},
    {true, false, 1.6, 0.3, 2, 1, 1, 0.1, 0.3,
     "with a finer coarsest grid and more sweeps", false, false, false},
    {true, true, 1.6, 0.3, 0, 1, 0, 0.1, 0.3,
     "from a Newtonian film, with increasing shear thinning", false, false,
     false},
    {false, true, 1.25, 0.15, 0, 1, 0, 0.1, 0.3,
     "the load was raised in smaller steps on a finer level", false, false,
     false},
    {false, true, 1.25, 0.15, 2, 2, 1, 0.03, 0.1,
     "the load was raised in smaller steps on a finer level, with a finer "
     "coarsest grid, more sweeps and stronger damping",
     false, false, false},
    {false, true, 1.25, 0.15, 2, 2, 1, 0.03, 0.1,
     "the load was raised in smaller steps, with the mean between nodes of "
     "domain.faces = gap",
     false, true, false},
    [OVR_STRATEGY_IN_TIME] = {false, false, 1.6, 0.3, 0, 1, 0, 0.1, 0.3,
                              "implicit steps in time until the film was "
                              "steady",
                              true, false, false},
    [OVR_STRATEGY_GAP] = {.what = "with the mean between nodes of "
                                  "domain.faces = gap",
                          .gap = true,
                          .other = true}};
enum { STRATEGIES = sizeof strategies / sizeof *strategies };

const char *ovr_simulation_strategy(const ovr_simulation *sim)
{
    if (!sim)
        return NULL;
    return sim->start.strategy < STRATEGIES
               ? strategies[sim->start.strategy].what
               : "";
}

void ovr_steady_by_gap(ovr_simulation *sim)
{
    ovr_hierarchy_by_gap(&sim->grids);
    sim->target.fluid.logarithmic = sim->target.fluid.secants = false;
}

void ovr_steady_restored(ovr_simulation *sim)
{
    int k = sim->start.strategy;
    /* Steps in time follow the strategy with faces = gap. */
    if ((k == OVR_STRATEGY_IN_TIME && !sim->options.refine) ||
        (k >= 0 && k < STRATEGIES && strategies[k].gap))
        ovr_steady_by_gap(sim);
}

static bool thins(const ovr_simulation *sim)
{
    return sim->lubricant.rheology != OVR_NEWTONIAN;
}

static ovr_full full_of(ovr_simulation *sim, const strategy *how)
{
    const ovr_options *o = &sim->options;
    bool fixed = o->stop == OVR_STOP_FIXED;
    ovr_cycling c = ovr_simulation_cycling(sim, how->finer_bottom);
    c.smoothing.limit = how->limit;
    c.newton_limit = how->newton_limit;
    c.newton_steps = how->newton_steps;
    if (how->sweeps)
        c.sweeps_before = c.sweeps_after = how->sweeps;
    return (ovr_full){.cycling = c,
                      .load_factor = how->load_factor,
                      .mesh = how->mesh,
                      .fixed = fixed,
                      .thin_last = thins(sim) && how->thin_last,
                      .max_cycles = fixed ? o->cycles
                                          : ovr_steady_max_cycles(sim, 60),
                      .tolerance = ovr_steady_tolerance,
                      .watch = refinement_watch,
                      .data = sim,
                      .saved = sim->start.saved};
}

/* Solves for the surfaces at T = 0. */
static ovr_defect solve(ovr_simulation *sim, const ovr_full *how, int *cycles)
{
    OVR_LAST_PHYSICS(sim, p, in_solve, solve);
    sim->order = sim->scheme->order;
    if (p->is)
        return p->is->in_solve->solve(sim, p->own, how, cycles);
    ovr_simulation_gap(sim, 0);
    return ovr_steady_film(sim, how, cycles);
}

/* Sets the past of a run that was steady before T = 0. */
static void begin_history(ovr_simulation *sim)
{
    ovr_past *past = &sim->past;
    size_t bytes = sim->now.n * sizeof(double);
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        for (int ago = 0; ago < ovr_field_rows[k].past; ago++)
            memcpy(past->all[k][ago], sim->now.all[k], bytes);
    for (int ago = 0; ago < OVR_PAST; ago++) {
        past->H0[ago] = sim->grids.H0;
        past->T[ago] = 0;
    }
    past->dT = past->dT_next = past->change = 0;
    past->still = 0;
    past->steps = 0;
    for (int ago = 0; ago < 3; ago++)
        ovr_physics_keep_asperity_pressure(sim);
    OVR_EACH_PHYSICS(sim, p, in_solve, begin)
        p->is->in_solve->begin(sim, p->own);
}

void ovr_steady_conditions(ovr_simulation *sim)
{
    const double minimum = OVR_MIN_START;
    ovr_target *target = &sim->target;
    target->Cw = fmax(ovr_history_value(sim->histories.load, 0), minimum);
    target->Cu = fmax(fabs(ovr_history_value(sim->histories.speed, 0)),
                      minimum);
    target->c = 1 / ovr_history_value(sim->histories.radius, 0);
    target->force = OVR_NOMINAL_LOAD * target->Cw;
}

/* Sets the operating conditions of the start, if they are valid numbers. */
static ovr_status begin_load_and_speed(ovr_simulation *sim, ovr_error *err)
{
    double Cw = ovr_history_value(sim->histories.load, 0);
    double Cu = fabs(ovr_history_value(sim->histories.speed, 0));
    if (!(Cw >= 0) || !(Cu >= 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        Cw >= 0
                            ? "speed ratio %g at T = 0: must be a number"
                            : "load ratio %g at T = 0: must not be negative",
                        Cw >= 0 ? Cu : Cw);
    if (ovr_physics_check(sim, err))
        return OVR_BAD_INPUT;
    OVR_EACH_PHYSICS(sim, p, in_solve, before_start)
        p->is->in_solve->before_start(sim, p->own);
    ovr_target *target = &sim->target;
    ovr_steady_conditions(sim);
    ovr_slide(sim, 0);
    target->fluid.sliding = sim->grids.fluid.sliding;
    return OVR_OK;
}

/* Solves the present film alternately with the coupled physical models. */
static bool found_with_all(ovr_simulation *sim, const ovr_full *how,
                           ovr_outcome *outcome)
{
    ovr_simulation_read(sim);
    OVR_EACH_PHYSICS(sim, p, in_solve, couple)
        if (ovr_steady_found(sim, outcome))
            p->is->in_solve->couple(sim, p->own, how, outcome);
    return ovr_steady_found(sim, outcome);
}

/* Solves by one strategy from scratch: the film alone on the grids of the whole
 * domain; completion by other physical models; alternating solution with the
 * coupled models; then models for which this film is the initial guess. */
static void attempt(ovr_simulation *sim, const ovr_full *how,
                    ovr_outcome *outcome)
{
    OVR_EACH_PHYSICS(sim, p, in_solve, forget)
        p->is->in_solve->forget(sim, p->own);
    ovr_physics_clear_asperity_pressure(sim);
    outcome->defect = solve(sim, how, &outcome->cycles);
    OVR_EACH_PHYSICS(sim, p, in_solve, complete)
        outcome->defect = p->is->in_solve->complete(sim, p->own, how,
                                                    &outcome->cycles);
    if (!found_with_all(sim, how, outcome))
        return;
    OVR_EACH_PHYSICS(sim, p, in_solve, proceed)
        if (p->is->in_solve->proceed(sim, p->own, how, outcome) &&
            !found_with_all(sim, how, outcome))
            return;
    OVR_EACH_PHYSICS(sim, p, in_solve, finish)
        p->is->in_solve->finish(sim, p->own, how, outcome);
}

void ovr_simulation_stop(ovr_simulation *sim, bool (*stop)(void *data),
                         void *data)
{
    sim->start.stopping = (ovr_stopping){.asked = stop, .data = data};
}

/* True if the steady solution has surface features higher than a thousandth of
 * the film thickness. Moving features are not part of it. */
static bool has_features(ovr_simulation *sim)
{
    const double small = 1e-3 * ovr_target_film(&sim->target, 1);
    if (!ovr_has_heights(sim))
        return false;
    ovr_simulation_gap(sim, 0);
    for (size_t i = 0; i < sim->now.n; i++)
        if (fabs(sim->shapes.S[i]) > small)
            return true;
    return false;
}

/* 1e8 node cycles take 10 to 15 s, with temperatures up to three times as long.
 */
double ovr_minute_of_work(const ovr_simulation *sim)
{
    return sim->heated ? 1.3e8 : 4e8;
}

/*
 * Returns the work that a start may take, in node cycles: a minute of CPU or 20
 * times the time of other starts, the start of the program included.  Random
 * thermal contacts with slide-to-roll ratios of 2 to 6 take 300 cycles on
 * average. Stationary rough surfaces and grids that do not resolve the inlet
 * need up to 14000 (time predicted by `check`: 320 and 1000 steps of 3 cycles).
 * Supplies of more than 0.99 of the flooded flow rate need up to 13000.
 */
static double largest_work(const ovr_simulation *sim, bool rough)
{
    double film = ovr_target_film(&sim->target, 1);
    bool resolved = ovr_mesh(sim) <= ovr_resolving_mesh(sim->contact.M, film);
    double bottom = (double)sim->grids.level[sim->grids.coarsest].grid.n;
    double cycle = (double)sim->now.n + bottom * bottom * bottom / 5000;
    double start = 2e6, cycles = 1300;
    if (!resolved || rough)
        cycles = resolved ? 25000 : 65000;
    else if (ovr_conserves(sim))
        cycles = 25000;
    else if (sim->heated)
        cycles = 6000;
    return fmin(ovr_minute_of_work(sim), start + cycles * cycle);
}

/* Ends counting of work. If the limit was reached, recomputes the defect of the
 * film. */
static void end_work(ovr_simulation *sim, ovr_outcome *outcome)
{
    if (!ovr_hierarchy_spent(&sim->grids))
        return;
    ovr_level_refresh(&sim->grids, sim->finest);
    outcome->defect = ovr_cycle_defect(&sim->grids, sim->finest);
    outcome->spent = true;
    ovr_simulation_read(sim);
}

/* True if a strategy does not apply to this contact. */
static bool is_left_out(const ovr_simulation *sim, const strategy *s,
                        bool rough)
{
    bool marches = !rough && (sim->grids.touch.at || sim->options.max_cycles ||
                              sim->options.tolerance > 0);
    if (s->other)
        return true;
    if (s->gap)
        return !sim->grids.fluid.logarithmic || sim->options.refine;
    return (s->flow_law && !thins(sim)) ||
           (s->grown &&
            (rough != (s == &strategies[OVR_STRATEGY_GROWTH]) || marches));
}

/* Tries the strategies in order; returns the tolerance of the last one. */
static double search(ovr_simulation *sim, ovr_outcome *outcome)
{
    const bool rough = outcome->rough = has_features(sim);
    double tolerance = 0;
    sim->start.settling = 0;
    ovr_hierarchy_allow(&sim->grids, largest_work(sim, rough));
    for (int k = 0, tried = 0; k < STRATEGIES && !outcome->converged; k++) {
        if (ovr_hierarchy_stops(&sim->grids))
            break;
        if (is_left_out(sim, &strategies[k], rough))
            continue;
        if (strategies[k].gap)
            ovr_steady_by_gap(sim);
        outcome->retries = tried++;
        ovr_full how = full_of(sim, &strategies[k]);
        sim->start.strategy = k;
        sim->start.grown = strategies[k].grown;
        sim->start.refinements = 0;
        attempt(sim, &how, outcome);
        outcome->converged = ovr_steady_found(sim, outcome);
        tolerance = ovr_steady_tolerance(sim, sim->finest,
                                         outcome->defect.centre);
        if (sim->options.stop == OVR_STOP_FIXED || ovr_mesh_too_coarse(sim) ||
            ovr_below_rounding(sim, &outcome->defect))
            break;
    }
    end_work(sim, outcome);
    return tolerance;
}

/* Solves with the solver of the line contact; returns the tolerance. */
static double solve_line(ovr_simulation *sim, ovr_outcome *outcome)
{
    ovr_operator op = {.speed = sim->target.Cu};
    ovr_reynolds_wedge(&op, sim->scheme->order == 2, op.speed);
    OVR_EACH_PHYSICS(sim, p, in_step, operate)
        p->is->in_step->operate(sim, p->own, 0, &op);
    ovr_hierarchy_operator(&sim->grids, &op);
    return search(sim, outcome);
}

static ovr_status solve_steady(ovr_simulation *sim, ovr_error *err)
{
    const ovr_present *other = sim->physics.solver;
    ovr_outcome outcome = {.rough = sim->shapes.heights};
    sim->started = false;
    if (begin_load_and_speed(sim, err) || ovr_smooth_check(sim, 0, err))
        return OVR_BAD_INPUT;
    double tolerance = other ? other->is->in_solve->solver->steady(
                                   sim, other->own, &outcome)
                             : solve_line(sim, &outcome);
    if (!outcome.converged && sim->grids.stopping.now)
        return ovr_fail(err, OVR_STOPPED, "stopped in the steady start");
    sim->statistics = (ovr_statistics){.cycles = outcome.cycles};
    sim->state = (ovr_state){0};
    ovr_observe(sim, 0, &outcome);
    begin_history(sim);
    sim->started = outcome.converged;
    if (!outcome.converged)
        return ovr_failure_steady(sim, &outcome, tolerance, err);
    OVR_EACH_PHYSICS(sim, p, in_solve, refuse)
        if (p->is->in_solve->refuse(sim, p->own, err)) {
            sim->started = sim->observation.converged = false;
            return err->status;
        }
    return OVR_OK;
}

ovr_status ovr_simulation_steady(ovr_simulation *sim, ovr_error *err)
{
    if (!sim)
        return ovr_fail_null(err, __func__);
    if (ovr_simulation_begin(sim, __func__, err))
        return OVR_BAD_INPUT;
    sim->grids.stopping = sim->start.stopping;
    ovr_status status = solve_steady(sim, err);
    sim->grids.stopping = (ovr_stopping){0};
    ovr_simulation_end(sim);
    return status;
}
