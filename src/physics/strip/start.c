/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steady films of strips.
 *
 * Nested iteration (strip/full.c) finds most of them.  If it fails, the film of
 * smooth surfaces is solved, and the features grow from that in steps.  Each
 * film is the first guess of the next.  A step that fails is halved.  Films on
 * the way are solved to R = 1e-4.
 *
 * Where steps of a sixteenth fail, the features grow in time.  Time steps
 * continue until the film is steady.  R of the steady equations falls by a
 * factor of e per b/u_m.  Steps are solved to R = 1e-2, later to a tenth of the
 * steady R.  A step begins with the settings that solved the last one.  A
 * groove of five film thicknesses (M = 20, L = 10) needs 1100 cycles, and 8000
 * with R = 1e-4 and all attempts of a step.
 *
 * If all that fails, it is repeated with faces = gap.  Spikes narrower than a
 * mesh size need it (M = 20, L = 33, level 6: 96 cycles in all).  Films of
 * smooth surfaces that fail then, too, are found by steps in time (M = 4,
 * L = 45, level 6: 655 cycles).
 */
#include <math.h>
#include <string.h>

#include "contact/curvature.h"
#include "contact/film_formula.h"
#include "physics/strip/strip.h"
#include "simulation/solver.h"
#include "simulation/steady.h"

/* Most cycles of a start on the finest grid: a minute of CPU, or this. */
enum { MOST_CYCLES = 8000 };

static const double ON_THE_WAY = 1e-4;

/* Largest R of a step in time. */
static const double LOOSE = 1e-2;

static ovr_strip_full full_of(ovr_simulation *sim, ovr_strip_solver *s)
{
    enum { CYCLES = 3, MOST = 60 };
    const ovr_target *t = &sim->target;
    const ovr_instant at = ovr_instant_of(&sim->contact, t->Cw, t->Cu, t->c);
    const double film = ovr_film_central_moes(at.M, at.L) * t->Cw;
    return (ovr_strip_full){
        .gap = ovr_strip_gap_of,
        .data = sim,
        .force = t->force,
        .speed = t->Cu,
        .half_width = at.s * sqrt(fmax(1, film / t->Cw)), /* thick films */
        .film = film,
        .cycling = ovr_strip_steady(&s->strip.fluid),
        .cycles = CYCLES,
        .max_cycles = ovr_steady_max_cycles(sim, MOST),
        .tolerance = ovr_steady_tolerance(sim, sim->finest, film)};
}

static bool is_solved(ovr_strip_solver *s, ovr_strip_defect d, double tolerance)
{
    return ovr_strip_below(d, tolerance) && ovr_strip_smallest_film(s) > 0;
}

static void set_outcome(ovr_outcome *outcome, ovr_strip_solver *s,
                        ovr_strip_defect d, double tolerance)
{
    outcome->defect = (ovr_defect){
        .imbalance = d.imbalance, .load = d.load, .centre = d.centre};
    outcome->converged = is_solved(s, d, tolerance);
}

/* The film of a height that was reached. */
typedef struct reached {
    double grown, H0;
    double *P;
} reached;

static void keep(const ovr_strip_solver *s, reached *r)
{
    const ovr_strip_level *finest = ovr_strip_finest(s);
    r->grown = s->grown;
    r->H0 = s->strip.H0;
    memcpy(r->P, finest->f.P, ovr_strip_size(&finest->grid) * sizeof *r->P);
}

static void restore(ovr_strip_solver *s, const reached *r)
{
    const ovr_strip_level *finest = ovr_strip_finest(s);
    s->grown = r->grown;
    s->strip.H0 = r->H0;
    memcpy(finest->f.P, r->P, ovr_strip_size(&finest->grid) * sizeof *r->P);
}

static bool is_stopped(ovr_simulation *sim, const ovr_strip_solver *s,
                       const ovr_outcome *outcome)
{
    const double minute = ovr_minute_of_work(sim) / OVR_SOLVER_WORK;
    double most = fmin(MOST_CYCLES, minute / (double)(s->n * s->lines));
    return outcome->cycles >= most || ovr_hierarchy_stops(&sim->grids);
}

/* True if another attempt may find a film. */
static bool goes_on(ovr_simulation *sim, const ovr_strip_solver *s,
                    const ovr_outcome *outcome)
{
    return !outcome->converged && !is_stopped(sim, s, outcome) &&
           !ovr_mesh_too_coarse(sim) &&
           !ovr_below_rounding(sim, &outcome->defect);
}

/* Grows the features from a film without them; returns the last defect.  The
 * march has no past before the start, its first array is free. */
static ovr_strip_defect grow(ovr_simulation *sim, ovr_strip_solver *s,
                             ovr_strip_full *how, ovr_outcome *outcome)
{
    enum { FEW = 35 }; /* cycles on the way */
    const double first = 0.25, least = 1. / 16, faster = 1.5;
    const double last = how->tolerance;
    const int most = how->max_cycles;
    reached r = {.P = s->march.P[0]};
    ovr_strip_defect d = {INFINITY, INFINITY, 0};
    double step = first;
    keep(s, &r);
    while (r.grown < 1 && step >= least && !is_stopped(sim, s, outcome)) {
        int cycles = 0;
        s->grown = fmin(1, r.grown + step);
        how->tolerance = s->grown < 1 ? fmax(last, ON_THE_WAY) : last;
        how->max_cycles = s->grown < 1 && most > FEW ? FEW : most;
        d = ovr_strip_continue(&s->strip, how, &cycles);
        outcome->cycles += cycles;
        if (is_solved(s, d, how->tolerance)) {
            keep(s, &r);
            step *= faster;
        } else {
            restore(s, &r);
            step /= 2;
        }
    }
    how->max_cycles = most;
    s->reached = r.grown;
    s->grown = r.grown;
    return d;
}

/* ------------------------------------------------------------ steps in time */

/* Time in which features grow, and that of the last attempt, b/u_m. */
static const double GROWTH_TIME = 2, LAST_TIME = 30;

/* An ovr_strip_gap of features at rest that grow from T = 0 on. */
static void growing_gap(void *data, double T, const ovr_strip_grid *g,
                        ptrdiff_t from, size_t n, double *gap)
{
    ovr_strip_solver *s = ovr_strip_of(data);
    double t = fmin(1, fmax(0, T / GROWTH_TIME));
    double share = t * t * t * (10 + t * (6 * t - 15));
    s->grown = s->reached + (1 - s->reached) * share;
    ovr_strip_gap_of(data, 0, g, from, n, gap);
}

/* A step to the time next; false if it was not solved. */
static bool step_to(ovr_strip_solver *s, double next, ovr_outcome *outcome)
{
    ovr_strip_step step = ovr_strip_march_attempt(&s->march, next);
    outcome->cycles += step.cycles;
    if (!step.solved || !(ovr_strip_smallest_film(s) > 0)) {
        ovr_strip_march_back(&s->march);
        s->march.first = 0;
        return false;
    }
    ovr_strip_march_accept(&s->march);
    s->march.first = step.last;
    return true;
}

/* Measures R of the steady equations at the film of the march.  Near the
 * solution, steady cycles are tried.  If they fail, the film is restored. */
static ovr_strip_defect settle(ovr_strip_solver *s, const ovr_strip_full *how,
                               ovr_outcome *outcome)
{
    enum { MOST = 10 };
    int cycles = 0;
    ovr_strip_full few = *how;
    few.max_cycles = 0;
    ovr_strip_wedge(&s->strip, how->speed, 0);
    ovr_strip_defect d = ovr_strip_continue(&s->strip, &few, &cycles);
    if (is_solved(s, d, how->tolerance) || !(d.imbalance < ON_THE_WAY))
        return d;
    few.max_cycles = MOST;
    ovr_strip_defect solved = ovr_strip_continue(&s->strip, &few, &cycles);
    outcome->cycles += cycles;
    if (is_solved(s, solved, how->tolerance))
        return solved;
    ovr_strip_march_back(&s->march);
    return d;
}

/* March of surfaces at rest: upstream2 with growing features.  It begins
 * with the film of the pressure that was restored. */
static void begin_march(ovr_strip_solver *s, const ovr_strip_full *how)
{
    ovr_strip_march *m = &s->march;
    ovr_strip_level *level = &s->strip.level[s->strip.finest];
    m->gap = growing_gap;
    m->characteristic = false;
    m->speed = how->speed;
    m->force = how->force;
    m->carried = m->travel[0] = m->travel[1] = NAN;
    m->share = 0;
    m->tolerance = m->loosest = m->load = LOOSE;
    growing_gap(how->data, 0, &level->grid, 0, level->grid.n, level->f.gap);
    ovr_strip_refresh(&s->strip, level);
    ovr_strip_march_begin(m, 0);
}

/* Grows the features by time steps from the part that was reached, until the
 * film is steady.  The past decays within a few b/u_m.  Steps are solved to a
 * tenth of R of the steady equations. */
static ovr_strip_defect march(ovr_simulation *sim, ovr_strip_solver *s,
                              const ovr_strip_full *how, ovr_outcome *outcome)
{
    const double first = 0.05, least = 1e-3, faster = 1.2, share = 0.1;
    const double most[2] = {0.1, 0.5}; /* while features grow, and later */
    const ovr_strip_march kept = s->march;
    ovr_strip_march *m = &s->march;
    ovr_strip_defect d = {INFINITY, INFINITY, 0};
    double T = 0, step = first, settled = GROWTH_TIME;
    begin_march(s, how);
    while (T < LAST_TIME && step >= least && !is_stopped(sim, s, outcome)) {
        if (!step_to(s, T + step, outcome)) {
            step /= 2;
            continue;
        }
        T += step;
        step = fmin(most[T > GROWTH_TIME], step * faster);
        if (T < settled)
            continue;
        d = settle(s, how, outcome);
        if (is_solved(s, d, how->tolerance))
            break;
        m->tolerance = fmax(share * how->tolerance,
                            fmin(share * d.imbalance, LOOSE));
        settled = T + 0.5;
    }
    m->first = 0;
    m->gap = kept.gap;
    m->characteristic = kept.characteristic;
    s->reached = s->grown;
    return d;
}

/* Solves without features, then with them; returns the tolerance. */
static double solve_grown(ovr_simulation *sim, ovr_strip_solver *s,
                          ovr_outcome *outcome)
{
    int cycles = 0;
    if (sim->start.strategy != OVR_STRATEGY_GAP)
        sim->start.strategy = OVR_STRATEGY_GROWTH;
    sim->start.grown = true;
    outcome->retries++;
    ovr_strip_set_fluid(sim, s, 0);
    ovr_strip_full how = full_of(sim, s);
    const double tolerance = how.tolerance;
    s->grown = 0;
    s->reached = NAN;
    how.tolerance = fmax(tolerance, ON_THE_WAY);
    ovr_strip_defect d = ovr_strip_solve(&s->strip, &how, &cycles);
    outcome->cycles += cycles;
    how.tolerance = tolerance;
    if (is_solved(s, d, fmax(tolerance, ON_THE_WAY)))
        d = grow(sim, s, &how, outcome);
    if (s->reached < 1) {
        how.tolerance = tolerance;
        d = march(sim, s, &how, outcome);
    }
    s->grown = 1;
    set_outcome(outcome, s, d, tolerance);
    return tolerance;
}

/* Nested iteration, then growing features; returns the tolerance. */
static double solve(ovr_simulation *sim, ovr_strip_solver *s,
                    ovr_outcome *outcome)
{
    int cycles = 0;
    ovr_strip_set_fluid(sim, s, 0);
    const ovr_strip_full how = full_of(sim, s);
    ovr_strip_defect d = ovr_strip_solve(&s->strip, &how, &cycles);
    outcome->cycles += cycles;
    set_outcome(outcome, s, d, how.tolerance);
    if (goes_on(sim, s, outcome) && ovr_has_heights(sim))
        return solve_grown(sim, s, outcome);
    return how.tolerance;
}

/* Smooth surfaces: steps in time from the film of a few cycles. */
static double solve_in_time(ovr_simulation *sim, ovr_strip_solver *s,
                            ovr_outcome *outcome)
{
    enum { FEW = 3 };
    int cycles = 0;
    ovr_strip_full how = full_of(sim, s);
    const int most = how.max_cycles;
    how.max_cycles = FEW;
    ovr_strip_solve(&s->strip, &how, &cycles);
    how.max_cycles = most;
    outcome->cycles += cycles;
    s->reached = s->grown = 1;
    ovr_strip_defect d = march(sim, s, &how, outcome);
    s->reached = NAN;
    set_outcome(outcome, s, d, how.tolerance);
    return how.tolerance;
}

/* Like the line contact, with faces = gap if the logarithmic mean fails. */
double ovr_strip_steady_film(ovr_simulation *sim, void *own,
                             ovr_outcome *outcome)
{
    const ovr_options *o = &sim->options;
    ovr_strip_solver *s = own;
    sim->grids.fluid = sim->target.fluid;
    sim->order = sim->scheme->order;
    sim->start.strategy = 0;
    sim->start.grown = false;
    s->reached = NAN;
    double tolerance = solve(sim, s, outcome);
    if (goes_on(sim, s, outcome) && s->strip.logarithmic) {
        ovr_steady_by_gap(sim);
        sim->start.strategy = OVR_STRATEGY_GAP;
        outcome->retries++;
        tolerance = solve(sim, s, outcome);
    }
    if (goes_on(sim, s, outcome) && !ovr_has_heights(sim) && !o->max_cycles &&
        !(o->tolerance > 0)) {
        sim->start.strategy = OVR_STRATEGY_IN_TIME;
        outcome->retries++;
        tolerance = solve_in_time(sim, s, outcome);
    }
    ovr_strip_keep_heights(sim, s, 0);
    ovr_strip_show(sim, s, s->shown);
    return tolerance;
}

ovr_status ovr_strip_explain(const ovr_simulation *sim, const void *own,
                             const ovr_outcome *outcome, ovr_error *err)
{
    const ovr_strip_solver *s = own;
    if (!(s->reached >= 0))
        return OVR_OK;
    if (s->reached >= 1)
        return ovr_fail(err, OVR_NOT_CONVERGED,
                        "the steady solution of the strip did not converge: "
                        "from smooth surfaces the features grew to their "
                        "height, but the film did not become steady in %d "
                        "cycles%s; lower features or a finer domain.level are "
                        "easier to solve",
                        outcome->cycles,
                        ovr_failure_reached(sim, outcome).text);
    return ovr_fail(
        err, OVR_NOT_CONVERGED,
        "the steady solution of the strip did not converge: from smooth "
        "surfaces the features grew to %.0f %% of their height in %d cycles"
        "%s; features that start upstream of the inlet, grow in time (grow) or "
        "are lower, and a finer domain.level, are easier to solve",
        100 * s->reached, outcome->cycles,
        ovr_failure_reached(sim, outcome).text);
}
