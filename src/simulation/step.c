/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One implicit step:
 *   1. operator, history term, gap and force at T + dT;
 *   2. a guess by extrapolation in time (guess.c);
 *   3. cycles until residual and load error are below tolerance;
 *   4. if that fails, further attempts that are slower but more stable, the
 *      last by continuation (continuation.c). A step longer than the mesh size
 *      with fourth-order corrections is halved instead, and after repeated
 *      failures all steps are;
 *   5. if they fail, two half steps. At the smallest step a result above the
 *      tolerance is accepted and flagged if its residual is acceptable;
 *      otherwise the state returns to the last completed time with an error;
 *   6. the stored past is updated, and the step is observed.
 */
#include "simulation/step_cycles.h"

#include <math.h>
#include <string.h>

#include "base/given.h"
#include "contact/contact.h"
#include "multigrid/coarsest.h"
#include "multigrid/field.h"
#include "multigrid/film_end.h"
#include "multigrid/local_newton.h"
#include "multigrid/mixed_contact.h"
#include "simulation/conflicts.h"
#include "simulation/fourth.h"
#include "simulation/mirror.h"
#include "simulation/observe.h"
#include "simulation/physics.h"

/* ------------------------------------------------------------------- Cycles */

/*
 * 0.15 of the steady tolerance, because errors of many steps accumulate in a
 * film. Compared with 0.07, ground surfaces on level 6 take 12 % fewer cycles.
 * The total error of the central film thickness is 7 % larger there, and the
 * other errors change by 1 % or less.  Without relaxation after the last
 * correction the residual is oscillatory and has a smaller effect on the film,
 * so the tolerance is three times larger.
 */
static double tolerance_of(const ovr_simulation *sim, bool relaxed)
{
    double D = ovr_mesh(sim), H = sim->observation.H_cen;
    double share = relaxed ? 0.15 : 0.45;
    double tolerance = share * ovr_truncation_tolerance(sim, D, H);
    double minimum = ovr_negligible_tolerance(sim, D, H);
    if (sim->options.tolerance > 0)
        return sim->options.tolerance;
    return tolerance > minimum ? tolerance : minimum;
}

/* True if the load error is small enough: a fraction of the reference load or,
 * if larger, of the present load; half of the error permitted in a run
 * (overroll(1)). */
static bool carries(const ovr_simulation *sim, const ovr_defect *defect)
{
    const double maximum = 5e-5;
    double ratio = sim->finest->force / OVR_NOMINAL_LOAD;
    return defect->load * fmin(ratio, 1) <= maximum;
}

/*
 * Tolerance relative to the residual of the initial guess. If the guess is
 * poor, features move by a considerable part of their width per step, and the
 * time discretization error is equally large (Milne's device: both are the
 * next-order difference). R need not fall below 1e-4 of its value for the
 * guess, but must be below 300 times the tolerance for smooth features. On
 * rough surfaces at level 9 this changes the film thickness by 7e-6, compared
 * with 5e-4 from mesh and step.
 */
static double tolerance_by_guess(const ovr_simulation *sim, double guess)
{
    const double share = 1e-4, maximum = 300, on_any_mesh = 1e-3;
    if (sim->options.tolerance > 0)
        return 0;
    return fmin(fmin(share * guess, on_any_mesh),
                maximum * tolerance_of(sim, true));
}

/* Solves local windows if the guess is poor, or if it is still poor after the
 * first cycle. */
static void solve_windows(const ovr_hierarchy *grids, ovr_level *finest,
                          int times)
{
    while (!grids->touch.at && times-- > 0 && ovr_local_newton(grids, finest))
        continue;
}

static void settle_ends(const ovr_hierarchy *grids, ovr_level *finest)
{
    if (!grids->conserving && !grids->touch.at)
        ovr_move_cavitation_boundary(grids, finest);
}

/*
 * Detects films for which sweeps after the coarse-grid correction are harmful.
 * In thick films (H of 4 and more, inlet about 30 b long, M below 1) a sweep
 * amplifies long smooth pressure changes, because the neglected derivatives, d
 * eps/dH and the outermost column of the wedge, are not small. Cycles with a
 * sweep after the correction then reduce R by 0.96 or increase it; without it R
 * falls by 0.12. In other films R falls to a hundredth per cycle. If R is above
 * 10, spikes converge slowly without these sweeps.
 */
typedef struct slowness {
    double last;
    int cycles; /* number of consecutive slow cycles */
} slowness;

static bool is_spoilt(slowness *s, double R)
{
    const double spiky = 10, slow = 0.7;
    bool was = R < spiky && R > slow * s->last;
    s->cycles = was ? s->cycles + 1 : 0;
    s->last = R;
    return s->cycles >= 2;
}

/* At least one cycle is performed: the extrapolated guess may satisfy the
 * tolerance, and during a load ramp errors would accumulate. */
bool ovr_step_cycles(ovr_simulation *sim, ovr_step_cycling how,
                     ovr_outcome *outcome)
{
    enum { SHORT_CYCLES = 3 };
    ovr_hierarchy *grids = &sim->grids;
    ovr_cycling c = how.cycle;
    bool solved;
    double loose = 0;
    slowness slow = {.last = INFINITY};
    ovr_level_refresh(grids, sim->finest);
    solve_windows(grids, sim->finest, 2);
    settle_ends(grids, sim->finest);
    for (int cycle = 0, after = c.sweeps_after;; cycle++) {
        double target = tolerance_of(sim, c.sweeps_after > 0);
        outcome->defect = ovr_cycle_defect(grids, sim->finest);
        if (!cycle)
            loose = tolerance_by_guess(sim, outcome->defect.imbalance);
        target = fmax(target, loose);
        solved = cycle && carries(sim, &outcome->defect) &&
                 ovr_below(outcome->defect,
                           target > how.tolerance ? target : how.tolerance);
        if (solved || cycle == how.maximum ||
            !(outcome->defect.imbalance < how.hopeless) ||
            ovr_hierarchy_stops(grids))
            break;
        if (is_spoilt(&slow, outcome->defect.imbalance))
            after = 0;
        c.sweeps_after = how.close && cycle < SHORT_CYCLES ? 0 : after;
        ovr_cycle(grids, sim->finest, c);
        if (!cycle)
            solve_windows(grids, sim->finest, 1);
        settle_ends(grids, sim->finest);
        OVR_EACH_PHYSICS(sim, p, in_step, update)
            p->is->in_step->update(sim, p->own);
        outcome->cycles++;
    }
    ovr_simulation_read(sim);
    return solved && ovr_surfaces_apart(sim);
}

/* ------------------------------------------------------------------- Newton */

/*
 * Last attempt of a step: Newton's method on the finest grid with film
 * thicknesses as additional unknowns that remain positive
 * (multigrid/mixed_contact.h), without asperity pressure, A = 0. It solves
 * rough films below lambda = 1 with a rheological model, for which cycles fail.
 *
 * Its memory is allocated when a step needs it for the first time and is
 * detached from the finest level afterwards, so that other steps are not
 * affected.
 */

static void bears_nothing(const void *law, double H, double *A, double *slope)
{
    (void)law, (void)H;
    *A = *slope = 0;
}

/* True for Reynolds cavitation on one grid, if the memory is available. */
static bool has_newton(ovr_simulation *sim)
{
    ovr_hierarchy *grids = &sim->grids;
    return sim->options.smoother == OVR_LINE && !grids->touch.at &&
           !grids->conserving && !sim->finest->asperity_P &&
           !sim->options.paper_balance;
}

/* Attaches the arrays for Newton's method to the finest level, or detaches
 * them. */
static void exchange(ovr_simulation *sim)
{
    ovr_last_newton *own = &sim->last_newton;
    ovr_level *level = sim->finest;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (own->mine[k])
            ovr_swap(&level->f.all[k], &own->field[k]);
    ovr_swap(&level->asperity_P, &own->asperity_P);
    ovr_swap(&level->pressed, &own->pressed);
}

/* Stores the result in the level. */
static bool allocate_newton(ovr_simulation *sim)
{
    ovr_last_newton *own = &sim->last_newton;
    ovr_error err = {0};
    double *before[OVR_FIELD_COUNT];
    if (own->taken) {
        exchange(sim);
        return true;
    }
    memcpy(before, sim->finest->f.all, sizeof before);
    if (ovr_hierarchy_take_asperities(&sim->grids, &sim->arena, &err))
        return false;
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        own->mine[k] = sim->finest->f.all[k] != before[k];
    return own->taken = true;
}

bool ovr_step_newton(ovr_simulation *sim, const ovr_cycling *how,
                     ovr_outcome *outcome)
{
    enum { STEPS = 60 };
    const double far = 1e15;
    ovr_asperity *touch = &sim->grids.touch;
    ovr_level *level = sim->finest;
    if (!has_newton(sim) || !allocate_newton(sim))
        return false;
    touch->at = bears_nothing;
    touch->share = 1;
    ovr_level_clear(level, level->asperity_P);
    ovr_asperity_settle(&sim->grids);
    bool solved = ovr_step_cycles(
        sim, (ovr_step_cycling){*how, false, STEPS, far, 0}, outcome);
    touch->at = NULL;
    exchange(sim);
    ovr_level_refresh(&sim->grids, level);
    ovr_simulation_read(sim);
    return solved && ovr_surfaces_apart(sim);
}

/* --------------------------------------------------------------------- Step */

/* Parameters of an attempt. */
typedef struct attempt {
    bool extrapolate;
    int sweeps, newton_steps, finer_bottom, max_cycles;
    double limit, newton_limit, correction;
    bool continued; /* uses continuation from the last solution */
    bool newton;    /* uses Newton's method on the finest grid */
    bool corrected; /* uses fourth-order corrections */
} attempt;

static const attempt attempts[] = {
    {true, 0, 1, 0, 20, 0.2, 0.3, 1, false, false, true},
    {false, 0, 1, 0, 20, 0.2, 0.3, 1, false, false, true},
    {false, 0, 1, 0, 40, 0.2, 0.3, 1, false, false, false},
    {false, 2, 2, 1, 80, 0.05, 0.3, 1, false, false, false},
    /* halved corrections of the finest level prevent an oscillation between two
     * states at an isolated cavitated node that coarse grids do not resolve */
    {false, 0, 1, 0, 80, 0.2, 0.3, 0.5, false, false, false},
    {false, 2, 1, 0, 0, 0.2, 0.3, 1, true, false, false},
    {false, 0, 1, 0, 0, 0.2, 1, 1, false, true, false},
};
enum { ATTEMPTS = sizeof attempts / sizeof *attempts };

/* With asperity contact a cycle is a Newton step, which can diverge temporarily
 * with Eyring's sinh. With 60 steps, all but a few films of 100 pairs of ground
 * surfaces converge. */
static const struct {
    int max_cycles;
    double newton_limit, hopeless;
} touching = {60, 1, 1e15};

static ovr_cycling cycling_of(const ovr_simulation *sim, const attempt *how)
{
    ovr_cycling c = ovr_simulation_cycling(sim, how->finer_bottom);
    c.smoothing.limit = how->limit;
    c.newton_limit = how->newton_limit;
    if (sim->grids.touch.at)
        c.newton_limit = touching.newton_limit;
    c.newton_steps = how->newton_steps;
    c.correction = how->correction;
    if (how->sweeps)
        c.sweeps_before = c.sweeps_after = how->sweeps;
    return c;
}

static bool is_asperity_pressure(double A)
{
    return A > OVR_TOUCH_MIN;
}

/* True if there was no asperity load in the last step, in a case with an
 * asperity contact model. */
static bool had_no_asperity_contact(const ovr_simulation *sim)
{
    for (size_t i = 0; i < sim->now.n; i++)
        if (is_asperity_pressure(sim->asperity_P[i]))
            return false;
    return true;
}

/* True if the asperity pressure, which decreases with the film thickness, is
 * zero at the minimum film thickness. */
static bool are_apart(const ovr_simulation *sim)
{
    const ovr_asperity *touch = &sim->grids.touch;
    const double *H = sim->now.H;
    double A, slope;
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, H);
    touch->at(touch->law, H[low], &A, &slope);
    return !is_asperity_pressure(A);
}

static bool try_with(ovr_simulation *sim, double dT, const attempt *how,
                     ovr_outcome *outcome)
{
    ovr_cycling c = cycling_of(sim, how);
    bool close = ovr_guess(sim, dT, how->extrapolate) &&
                 sim->options.smoother == OVR_LINE && c.sweeps_before > 0;
    OVR_EACH_PHYSICS(sim, p, in_step, attempt)
        p->is->in_step->attempt(sim, p->own, how->corrected);
    if (how->continued)
        return ovr_step_continued(sim, &c, outcome);
    if (how->newton)
        return ovr_step_newton(sim, &c, outcome);
    ovr_step_cycling cycling = {c, close, how->max_cycles, 1e6, 0};
    if (sim->grids.touch.at) {
        cycling.maximum = touching.max_cycles;
        cycling.hopeless = touching.hopeless;
    }
    return ovr_step_cycles(sim, cycling, outcome);
}

/* First attempt without asperity contact, if no asperities were in contact
 * before: cycles then cost the same as without [boundary]. If asperities come
 * into contact, the next attempt includes them. */
static bool try_once(ovr_simulation *sim, double dT, const attempt *how,
                     ovr_outcome *outcome)
{
    ovr_asperity *touch = &sim->grids.touch;
    const ovr_asperity law = *touch;
    if (!law.at || how != attempts || !had_no_asperity_contact(sim))
        return try_with(sim, dT, how, outcome);
    memset(sim->asperity_P, 0, sim->now.n * sizeof *sim->asperity_P);
    touch->at = NULL;
    bool solved = try_with(sim, dT, how, outcome);
    touch->at = law.at;
    if (are_apart(sim))
        return solved;
    outcome->defect.imbalance = INFINITY; /* of a film that asperities lift */
    return false;
}

static void begin_step(ovr_simulation *sim, double dT)
{
    double T = sim->past.T[0] + dT;
    OVR_EACH_PHYSICS(sim, p, in_step, before_step)
        p->is->in_step->before_step(sim, p->own, T);
    ovr_slide(sim, T);
    ovr_time_derivative(sim, dT);
    OVR_EACH_PHYSICS(sim, p, in_step, step)
        p->is->in_step->step(sim, p->own, dT);
    ovr_simulation_gap(sim, T);
    sim->finest->force = OVR_NOMINAL_LOAD *
                         ovr_history_value(sim->histories.load, T);
    /* Not part of checkpoints: a resumed run has none from the last cycle. */
    sim->grids.fluid.secants = false;
}

/* Rotates `count` stored arrays: the oldest becomes the newest, with these
 * values. */
static void keep(double *ages[], int count, const double *values, size_t n)
{
    double *oldest = ages[count - 1];
    memmove(ages + 1, ages, (size_t)(count - 1) * sizeof *ages);
    ages[0] = memcpy(oldest, values, n * sizeof *values);
}

/* Stores the solution as the newest past. */
static void end_step(ovr_simulation *sim, double dT)
{
    ovr_past *past = &sim->past;
    ovr_guess_update(sim, dT);
    ovr_physics_keep_asperity_pressure(sim);
    OVR_EACH_PHYSICS(sim, p, in_step, accepted)
        p->is->in_step->accepted(sim, p->own, dT);
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++)
        if (ovr_field_rows[k].past)
            keep(past->all[k], ovr_field_rows[k].past, sim->now.all[k],
                 sim->now.n);
    for (int k = OVR_PAST - 1; k > 0; k--) {
        past->H0[k] = past->H0[k - 1];
        past->T[k] = past->T[k - 1];
    }
    past->H0[0] = sim->grids.H0;
    past->T[0] += dT;
    past->dT = dT;
    past->steps += past->steps < 3;
}

static void note_change(ovr_simulation *sim)
{
    size_t n = sim->now.n;
    double (*change)(size_t, const double *,
                     const double *) = sim->grids.kernels->difference;
    double P = change(n, sim->past.P[0], sim->past.P[1]);
    double S = change(n, sim->shapes.S, sim->shapes.S_past);
    sim->past.change = sim->shapes.heights && S > P ? S : P;
}

/* Ends a step that reached its work limit, with the defect of its film. */
static void give_up(ovr_simulation *sim, ovr_outcome *outcome)
{
    ovr_hierarchy_spent(&sim->grids);
    ovr_level_refresh(&sim->grids, sim->finest);
    outcome->defect = ovr_cycle_defect(&sim->grids, sim->finest);
    outcome->marked = outcome->spent = true;
    ovr_simulation_read(sim);
}

/* Makes the attempts of a step; true if it is over, with *taken or in vain. */
static bool try_all(ovr_simulation *sim, double dT, bool halve,
                    ovr_outcome *outcome, bool *taken)
{
    bool follows = ovr_fourth_follows(sim);
    for (size_t k = 0; k < ATTEMPTS; k++) {
        if (k == 1 && !follows)
            continue; /* the same as the next one */
        if (k)
            outcome->retries++;
        *taken = try_once(sim, dT, &attempts[k], outcome);
        if (*taken) {
            outcome->error = ovr_step_error(sim, dT);
            *taken = outcome->error <= sim->limits.largest_error;
        } else if (ovr_below_rounding(sim, &outcome->defect) &&
                   ovr_surfaces_apart(sim)) {
            /* rounding does not permit the tolerance, and R has reached its
             * minimum */
            *taken = outcome->marked = true;
        } else if (ovr_hierarchy_stops(&sim->grids)) {
            give_up(sim, outcome);
        } else if (halve) {
            return false;
        } else {
            continue;
        }
        outcome->uncorrected |= *taken && follows && !attempts[k].corrected;
        if (*taken)
            end_step(sim, dT);
        return true;
    }
    return false;
}

/*
 * Steps longer than the mesh size D, with fourth-order corrections, are halved
 * if their first attempt fails. Without corrections their errors would be ten
 * times larger than with steps of D.  Contacts with a pressure spike two mesh
 * sizes wide fail often. After FAILURES all further steps are halved.
 */
enum { FAILURE = 16, FAILURES = 4 * FAILURE };

static bool is_long(const ovr_simulation *sim, double dT)
{
    return ovr_fourth_follows(sim) && dT > 1.5 * ovr_mesh(sim) &&
           isinf(sim->limits.largest_error);
}

/* Makes a step, if necessary in two halves. */
static bool advance(ovr_simulation *sim, double dT, int halvings,
                    ovr_outcome *outcome)
{
    double *failures = &sim->past.failures;
    bool halve = !halvings && is_long(sim, dT), taken;
    if (!halve || *failures < FAILURES) {
        begin_step(sim, dT);
        if (try_all(sim, dT, halve, outcome, &taken)) {
            if (halve)
                *failures = fmax(*failures - 1, 0);
            return taken;
        }
        if (halve)
            *failures += FAILURE;
    }
    if (halvings < OVR_HALVINGS) {
        sim->statistics.substeps++;
        if (!advance(sim, dT / 2, halvings + 1, outcome))
            return false;
        return advance(sim, dT / 2, halvings + 1, outcome);
    }
    outcome->marked = true;
    if (!ovr_below(outcome->defect, OVR_ACCEPTABLE) || !ovr_surfaces_apart(sim))
        return false;
    end_step(sim, dT);
    return true;
}

void ovr_simulation_step_back(ovr_simulation *sim)
{
    if (sim->physics.solver) {
        sim->state.T = sim->past.T[0];
        sim->physics.solver->is->in_solve->solver->step_back(
            sim, sim->physics.solver->own);
        return;
    }
    sim->grids.H0 = sim->past.H0[0];
    sim->state.T = sim->past.T[0];
    OVR_EACH_PHYSICS(sim, p, in_step, before_back)
        p->is->in_step->before_back(sim, p->own);
    ovr_slide(sim, sim->state.T);
    ovr_nodes_write(sim, sim->finest, sim->past.P[0], sim->finest->f.P);
    ovr_simulation_gap(sim, sim->past.T[0]);
    ovr_physics_restore_asperity_pressure(sim);
    OVR_EACH_PHYSICS(sim, p, in_step, step_back)
        p->is->in_step->step_back(sim, p->own);
    ovr_level_refresh(&sim->grids, sim->finest);
    ovr_simulation_read(sim);
}

/* Flags results that a physical model rejects, like films that did not
 * converge. */
static void mark(ovr_simulation *sim, ovr_outcome *outcome)
{
    OVR_EACH_PHYSICS(sim, p, in_output, marks)
        if (p->is->in_output->marks(sim, p->own)) {
            sim->observation.marked = outcome->marked = true;
            sim->observation.converged = outcome->converged = false;
            ovr_statistics_flag(&sim->statistics, &sim->observation);
        }
}

static void count(ovr_simulation *sim, const ovr_outcome *outcome)
{
    ovr_statistics *s = &sim->statistics;
    s->steps++;
    s->cycles += outcome->cycles;
    s->retries += outcome->retries;
    s->marked += outcome->marked;
    s->uncorrected += outcome->uncorrected;
}

/* True if the departure points of the film one and two steps ago are on the
 * grid or ghost nodes. */
static bool departures_are_there(const ovr_simulation *sim, double dT)
{
    double T = sim->past.T[0] + dT;
    return ovr_inflow_reaches(sim, 2 * dT) &&
           ovr_inflow_reaches(sim, ovr_travel_since(sim, 0, T)) &&
           ovr_inflow_reaches(sim, ovr_travel_since(sim, 1, T));
}

static ovr_status check(const ovr_simulation *sim, double dT, ovr_error *err)
{
    if (ovr_conflict_check(ovr_model_features_of(&sim->options) |
                               ovr_model_feature_bit(OVR_MODEL_TIME, true),
                           err))
        return OVR_BAD_INPUT;
    if (!sim->started)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a step needs a converged steady start; call "
                        "ovr_simulation_steady first");
    if (!(dT > 0) || !isfinite(dT))
        return ovr_fail(err, OVR_BAD_INPUT, "time step %g: must be positive",
                        dT);
    if (sim->scheme->characteristic && !departures_are_there(sim, dT))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "time step %g: must be at most %d mesh sizes with "
                        "the characteristic scheme",
                        dT, OVR_GHOSTS / 2 - 4);
    if (ovr_physics_check(sim, err))
        return OVR_BAD_INPUT;
    return ovr_smooth_check(sim, sim->past.T[0] + dT, err);
}

ovr_status ovr_simulation_attempt(ovr_simulation *sim, double next, bool *taken,
                                  double *error, ovr_error *err)
{
    ovr_outcome outcome = {0};
    double dT = next - sim->past.T[0];
    ovr_status status = check(sim, dT, err);
    if (status)
        return status;
    const ovr_present *other = sim->physics.solver;
    ovr_hierarchy_allow(&sim->grids, sim->limits.step_work > 0
                                         ? sim->limits.step_work
                                         : ovr_minute_of_work(sim));
    *taken = other ? other->is->in_solve->solver->attempt(sim, other->own, next,
                                                          &outcome)
                   : advance(sim, dT, 0, &outcome);
    sim->limits.work_done += sim->grids.stopping.work;
    ovr_hierarchy_allow(&sim->grids, 0);
    *error = outcome.error;
    if (!*taken && outcome.error > sim->limits.largest_error) {
        ovr_simulation_step_back(sim);
        sim->statistics.retries++;
        sim->statistics.cycles += outcome.cycles;
        return OVR_OK;
    }
    if (!*taken) {
        status = ovr_failure_step(sim, &outcome, next, err);
        ovr_simulation_step_back(sim);
        return status;
    }
    outcome.converged = !outcome.marked;
    if (!other)
        note_change(sim);
    sim->state.step++;
    sim->state.T = sim->past.T[0] = next;
    ovr_observe(sim, dT, &outcome);
    mark(sim, &outcome);
    count(sim, &outcome);
    return OVR_OK;
}

ovr_status ovr_simulation_step(ovr_simulation *sim, double dT, ovr_error *err)
{
    if (!sim)
        return ovr_fail_null(err, __func__);
    if (ovr_simulation_begin(sim, __func__, err))
        return OVR_BAD_INPUT;
    bool taken;
    double error;
    sim->limits.largest_error = INFINITY;
    ovr_status status = ovr_simulation_attempt(sim, sim->past.T[0] + dT, &taken,
                                               &error, err);
    ovr_simulation_end(sim);
    return status;
}
