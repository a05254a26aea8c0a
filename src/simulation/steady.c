/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The steady solution by full multigrid: Newton on the coarsest grid from the
 * Hertzian pressure, then on each finer grid cubic interpolation and cycles.
 */
#include <math.h>
#include <string.h>

#include "multigrid/coarsest.h"
#include "multigrid/fas.h"
#include "simulation/internal.h"

/* Full weighting of the gap; the weights' own effect on X^2/2, D^2/4 with the
 * fine D, is taken out again. */
static void coarsen_gap(const ovr_level *fine, double *g)
{
    size_t last = (fine->n - 1) / 2;
    double shift = 0.25 * fine->D * fine->D;
    for (size_t I = 1; I < last; I++)
        g[I] = 0.25 * (g[2 * I - 1] + 2 * g[2 * I] + g[2 * I + 1]) - shift;
    g[last] = g[2 * last];
}

/* gap, F and force of every level as if it were the finest; roughness comes
 * down by full weighting, in place, so that no level aliases it. */
static void prepare_levels(ovr_simulation *sim, double force)
{
    ovr_hierarchy *grids = &sim->grids;
    for (int l = grids->finest; l >= grids->coarsest; l--) {
        ovr_level *level = &grids->level[l];
        ovr_level_clear(level, level->f.F);
        level->force = force;
        if (l < grids->finest) {
            coarsen_gap(level + 1, sim->work);
            ovr_level_write(grids, level, sim->work, level->gap);
        }
    }
}

/*
 * The film formula at a fraction of the load: with Cw of the nominal load and
 * Cu of the nominal speed M goes with Cw/sqrt(Cu), L with Cu^(1/4), and the
 * unit of film b^2/R with Cw.
 */
double ovr_film_expected(const ovr_simulation *sim, double fraction)
{
    double Cw = sim->start_load, Cu = sim->start_speed;
    double M = fraction * sim->contact.M * Cw / sqrt(Cu);
    return Cw * ovr_film_central_moes(M, sim->contact.L * pow(Cu, 0.25));
}

/*
 * Hertz's semi-ellipse, but no narrower than the film's own width sqrt(H)
 * where the film outgrows the deformation; H0 from the film formula above the
 * rigid approach of the dry contact, Cw (-0.5966 + ln(a)/2) at half-width a.
 */
static void hertzian_start(ovr_simulation *sim, ovr_level *level,
                           double fraction)
{
    double Cw = sim->start_load, H = ovr_film_expected(sim, fraction);
    double a = sqrt(H > Cw ? H : Cw);
    for (size_t i = 0; i < level->n; i++) {
        double x = (sim->grids.X_a + (double)i * level->D) / a;
        sim->work[i] = x * x < 1 ? Cw / a * sqrt(1 - x * x) : 0;
    }
    sim->work[0] = sim->work[level->n - 1] = 0;
    ovr_level_write(&sim->grids, level, sim->work, level->f.P);
    sim->grids.H0 = H + Cw * (-0.5966 + 0.5 * log(a));
}

/* With a negative film the flow runs uphill, and the residual adds up to
 * anything, less than nothing included. */
bool ovr_below(ovr_defect d, double tolerance)
{
    return d.imbalance >= 0 && d.imbalance <= tolerance &&
           d.load <= 10 * tolerance && d.centre > 0;
}

/*
 * Of a level with film H at X = 0 so far.  On the way up a level need not be
 * better solved than its mesh is fine: fifty times the tolerance is most often
 * one cycle, and leaves less than the discretization error there.  The finest
 * level ends in the same place (algebraic over discretization error at M = 20,
 * L = 10, levels 8, 10 and 12: 0.020, 0.022, 0.006 after two cycles on it,
 * 0.015, 0.017, 0.000 when all levels had two), a fifth sooner.
 */
static double tolerance_at(const ovr_simulation *sim, const ovr_level *level,
                           double H)
{
    const double on_the_way = 50;
    const ovr_options *o = &sim->options;
    double truncation = ovr_truncation_tolerance(sim, level->D, H);
    if (level != sim->finest)
        return on_the_way * truncation;
    if (o->tolerance > 0)
        return o->tolerance;
    return o->stop == OVR_STOP_TRUNCATION
               ? truncation
               : ovr_negligible_tolerance(sim, level->D, H);
}

/* Where there is no finer grid, to what that is to reach. */
static double newton_tolerance(const ovr_simulation *sim,
                               const ovr_level *level, double H)
{
    const double enough = 1e-8;
    return level == sim->finest ? fmin(enough, tolerance_at(sim, level, H))
                                : enough;
}

static ovr_defect solve_coarsest(ovr_simulation *sim, ovr_level *level)
{
    enum { STEPS = 100 };
    ovr_hierarchy *grids = &sim->grids;
    ovr_defect d = {INFINITY, INFINITY, 0};
    for (int step = 0; step < STEPS; step++) {
        ovr_level_refresh(grids, level);
        d = ovr_cycle_defect(grids, level);
        if ((step && ovr_below(d, newton_tolerance(sim, level, d.centre))) ||
            !ovr_newton_step(grids, level, grids->newton_limit))
            break;
    }
    return d;
}

static int most_cycles(const ovr_options *o, int level)
{
    enum { ON_THE_WAY = 20 };
    if (o->stop == OVR_STOP_FIXED)
        return o->cycles;
    return level == o->level ? o->max_cycles : ON_THE_WAY;
}

/* Cycles on a level until below its tolerance; `factor` is the last one's on
 * the residual. */
static ovr_defect cycle_until(ovr_simulation *sim, ovr_level *level,
                              int *cycles, double *factor)
{
    ovr_hierarchy *grids = &sim->grids;
    int most = most_cycles(&sim->options, level->number);
    bool fixed = sim->options.stop == OVR_STOP_FIXED;
    ovr_defect d = ovr_cycle_defect(grids, level);
    for (int c = 0; c < most && d.imbalance < 1e6; c++) {
        if (!fixed && ovr_below(d, tolerance_at(sim, level, d.centre)))
            break;
        double before = d.imbalance;
        ovr_refinement_cycle(sim, level);
        ovr_cycle(grids, level);
        d = ovr_cycle_defect(grids, level);
        *factor = d.imbalance / before;
        ++*cycles;
    }
    return d;
}

/* From a solved level to the given one. */
static ovr_defect climb(ovr_simulation *sim, ovr_level *level, int top,
                        int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_defect d = ovr_cycle_defect(grids, level);
    while (level->number < top && d.imbalance < 1e6) {
        int before = *cycles;
        double factor = 0;
        ovr_refinement_coarse(sim, level);
        ovr_fas_refine(grids, level, level + 1);
        level++;
        ovr_level_refresh(grids, level);
        d = cycle_until(sim, level, cycles, &factor);
        ovr_refinement_note(sim, level, *cycles - before, factor, &d);
    }
    return d;
}

/* The fluid as a contact of a fraction of the nominal M sees it: ph goes with
 * the root of the load. */
static ovr_fluid fluid_at(const ovr_simulation *sim, double fraction)
{
    double ratio = 1 / fraction, root = sqrt(ratio);
    ovr_fluid fluid = {sim->lubricant, sim->contact.lambda * ratio * ratio};
    fluid.lubricant.alphabar /= root;
    fluid.lubricant.P0 *= root;
    fluid.lubricant.A *= root;
    return fluid;
}

/* The ladder a solve climbs when it fails: smaller steps in load on a finer
 * level, then a finer coarsest grid, more sweeps and stronger damping. */
typedef struct rung {
    double load_factor; /* largest step of the continuation in load */
    double mesh;        /* its D over H^(2/3), the length of the inlet's rise */
    int sweeps, newton_steps, finer_bottom;
    double limit, newton_limit; /* of changes in P */
    const char *what;
} rung;

static const rung ladder[] = {
    {1.6, 0.3, 0, 1, 0, 0.1, 0.3, ""},
    {1.25, 0.15, 0, 1, 0, 0.1, 0.3,
     "the load was raised in smaller steps on a finer level"},
    {1.25, 0.15, 2, 2, 1, 0.03, 0.1,
     "the load was raised in smaller steps on a finer level, with a finer "
     "coarsest grid, more sweeps and stronger damping"}};
enum { RUNGS = sizeof ladder / sizeof *ladder };

/*
 * Continuation in load on one level, from a solution at the fraction `from` to
 * the whole.  The pressure hardly changes, being nearly Hertzian; the
 * film gets thinner as a whole, so H0 follows the film formula.
 */
static ovr_defect raise_load(ovr_simulation *sim, ovr_level *level, double from,
                             double factor, int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    double *saved = sim->past.P[0], ratio;
    ovr_defect d = ovr_cycle_defect(grids, level);
    while (from < 1 && factor > 1.01) {
        double to = fmin(from * factor, 1), H0 = grids->H0;
        ovr_level_read(grids, level, level->f.P, saved);
        grids->fluid = fluid_at(sim, to);
        grids->H0 += ovr_film_expected(sim, to) - ovr_film_expected(sim, from);
        ovr_level_refresh(grids, level);
        d = cycle_until(sim, level, cycles, &ratio);
        if (ovr_below(d, 1e-2) && d.load < 1e-2) {
            from = to;
            continue;
        }
        factor = sqrt(factor);
        ovr_level_write(grids, level, saved, level->f.P);
        grids->H0 = H0;
    }
    return d;
}

/* Solves the coarsest grid at the largest fraction of the load that it can:
 * its film must be thicker than D^1.5 or so (measured), and Newton converge. */
static double solve_easy_load(ovr_simulation *sim, ovr_level *level)
{
    const double least = 1e-3;
    double fraction = 1;
    while (fraction > least &&
           ovr_film_expected(sim, fraction) < pow(level->D, 1.5))
        fraction *= 0.9;
    for (;; fraction *= 0.7) {
        sim->grids.fluid = fluid_at(sim, fraction);
        hertzian_start(sim, level, fraction);
        ovr_defect d = solve_coarsest(sim, level);
        if (ovr_below(d, 1e-4) || fraction < least)
            return fraction;
    }
}

/* The level on which the load is raised. */
static int load_level(const ovr_simulation *sim, double mesh)
{
    const ovr_hierarchy *grids = &sim->grids;
    double H = ovr_film_expected(sim, 1);
    int level = grids->coarsest;
    while (level < grids->finest &&
           grids->level[level].D > mesh * pow(H, 2. / 3))
        level++;
    return level;
}

const char *ovr_simulation_way(const ovr_simulation *sim)
{
    return sim->way < RUNGS ? ladder[sim->way].what : "";
}

static void set_rung(ovr_simulation *sim, const rung *how)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_simulation_defaults(sim);
    grids->limit = how->limit;
    grids->newton_limit = how->newton_limit;
    grids->newton_steps = how->newton_steps;
    if (grids->coarsest + how->finer_bottom < grids->finest)
        grids->bottom = grids->coarsest + how->finer_bottom;
    if (how->sweeps)
        grids->sweeps_before = grids->sweeps_after = how->sweeps;
}

static ovr_defect full_multigrid(ovr_simulation *sim, const rung *how,
                                 int *cycles)
{
    ovr_hierarchy *grids = &sim->grids;
    ovr_level *level = &grids->level[grids->bottom];
    double fraction = solve_easy_load(sim, level);
    sim->refinements = 0;
    ovr_defect d = ovr_cycle_defect(grids, level);
    if (fraction < 1) {
        int top = load_level(sim, how->mesh);
        if (top > level->number) {
            climb(sim, level, top, cycles);
            level = &grids->level[top];
        }
        d = raise_load(sim, level, fraction, how->load_factor, cycles);
        grids->fluid = fluid_at(sim, 1);
        sim->refinements = 0; /* those were of a lower load */
    }
    return level->number < grids->finest
               ? climb(sim, level, grids->finest, cycles)
               : d;
}

/* The past of a run that was steady before T = 0. */
static void begin_history(ovr_simulation *sim)
{
    ovr_past *past = &sim->past;
    size_t bytes = sim->finest->n * sizeof(double);
    for (int k = 0; k < 3; k++)
        memcpy(past->q[k], sim->q, bytes);
    for (int k = 0; k < 4; k++) {
        memcpy(past->P[k], sim->P, bytes);
        past->H0[k] = sim->grids.H0;
        past->T[k] = 0;
    }
    past->dT = past->dT_next = past->change = 0;
    past->still = 0;
    past->steps = 0;
}

/* Load and speed of the start, at least the least share of each. */
static ovr_status begin_load_and_speed(ovr_simulation *sim, ovr_error *err)
{
    const double least = OVR_LEAST_START;
    double Cw = ovr_history_value(sim->load, 0);
    double Cu = ovr_history_value(sim->speed, 0);
    if (!(Cw >= 0) || !(Cu >= 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s ratio %g at T = 0: must not be negative",
                        Cw >= 0 ? "speed" : "load", Cw >= 0 ? Cu : Cw);
    sim->start_load = Cw > least ? Cw : least;
    sim->start_speed = Cu > least ? Cu : least;
    return OVR_OK;
}

/* A fixed number of cycles has to reach the discretization error. */
static bool finished(const ovr_simulation *sim, const ovr_outcome *outcome,
                     double tolerance)
{
    int done = sim->refinements;
    if (!ovr_surfaces_apart(sim))
        return false;
    if (sim->options.stop == OVR_STOP_FIXED && done)
        return sim->refinement[done - 1].algebraic <=
               sim->refinement[done - 1].difference;
    return ovr_below(outcome->defect, tolerance);
}

ovr_status ovr_simulation_steady(ovr_simulation *sim, ovr_error *err)
{
    double tolerance = 0;
    ovr_outcome outcome = {0};
    sim->started = false;
    if (begin_load_and_speed(sim, err))
        return OVR_BAD_INPUT;
    ovr_operator op = {.speed = sim->start_speed};
    ovr_reynolds_wedge(&op, sim->options.scheme != OVR_UPSTREAM1, op.speed);
    ovr_hierarchy_operator(&sim->grids, &op);
    for (int k = 0; k < RUNGS && !outcome.converged; k++) {
        set_rung(sim, &ladder[k]);
        ovr_simulation_gap(sim, 0); /* in sim->work too */
        prepare_levels(sim, OVR_NOMINAL_LOAD * sim->start_load);
        outcome.retries = sim->way = k;
        outcome.defect = full_multigrid(sim, &ladder[k], &outcome.cycles);
        ovr_simulation_read(sim);
        tolerance = tolerance_at(sim, sim->finest, outcome.defect.centre);
        outcome.converged = finished(sim, &outcome, tolerance);
        if (sim->options.stop == OVR_STOP_FIXED || ovr_hopeless(sim))
            break;
    }
    sim->statistics = (ovr_statistics){.cycles = outcome.cycles};
    sim->state = (ovr_state){0};
    ovr_observe(sim, 0, &outcome);
    begin_history(sim);
    sim->started = outcome.converged;
    return outcome.converged
               ? OVR_OK
               : ovr_complain_steady(sim, &outcome, tolerance, err);
}
