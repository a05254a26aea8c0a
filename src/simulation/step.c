/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One implicit step:
 *   1. operator, history term, gap and force at T + dT;
 *   2. a guess by extrapolation in time (guess.c);
 *   3. cycles until residual and load are below tolerance (step_cycles.c);
 *   4. failing that, further attempts that are slower and steadier, the last
 *      by continuation (continuation.c);
 *   5. failing that, two half steps; at the smallest step a result that is
 *      merely poor is accepted and marked, anything else goes back to the
 *      last time reached and says so;
 *   6. the past moves on, and the step is observed.
 */
#include <math.h>
#include <string.h>

#include "base/given.h"
#include "contact/contact.h"
#include "multigrid/touching.h"
#include "simulation/conflicts.h"
#include "simulation/mirror.h"
#include "simulation/physics.h"
#include "simulation/step_cycles.h"

/* An attempt tries so hard. */
typedef struct attempt {
    bool extrapolate;
    int sweeps, newton_steps, finer_bottom, max_cycles;
    double limit, newton_limit, correction;
    bool continued; /* from the last solution, by continuation */
    bool newton;    /* by Newton's method on the finest grid */
} attempt;

static const attempt attempts[] = {
    {true, 0, 1, 0, 20, 0.2, 0.3, 1, false, false},
    {false, 0, 1, 0, 40, 0.2, 0.3, 1, false, false},
    {false, 2, 2, 1, 80, 0.05, 0.3, 1, false, false},
    /* half corrections into the finest level break a two-cycle at an isolated
     * dry node that coarse grids cannot see */
    {false, 0, 1, 0, 80, 0.2, 0.3, 0.5, false, false},
    {false, 2, 1, 0, 0, 0.2, 0.3, 1, true, false},
    {false, 0, 1, 0, 0, 0.2, 1, 1, false, true},
};
enum { ATTEMPTS = sizeof attempts / sizeof *attempts };

/* Where surfaces touch a cycle is a step of Newton's method with a lift of its
 * own, which Eyring's sinh may throw far out and which then comes back (of 100
 * pairs of ground surfaces 60 steps find all but a few films). */
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

static bool is_borne(double A)
{
    return A > OVR_TOUCH_MIN;
}

/* True if surfaces that may touch bore nothing in the step before. */
static bool were_apart(const ovr_simulation *sim)
{
    for (size_t i = 0; i < sim->now.n; i++)
        if (is_borne(sim->borne[i]))
            return false;
    return true;
}

/* True if their law, which falls with the film, bears nothing by the thinnest.
 */
static bool are_apart(const ovr_simulation *sim)
{
    const ovr_touch *touch = &sim->grids.touch;
    const double *H = sim->now.H;
    double A, slope;
    size_t low = sim->grids.kernels->extreme(sim->now.n, 1, H);
    touch->at(touch->law, H[low], &A, &slope);
    return !is_borne(A);
}

static bool try_with(ovr_simulation *sim, double dT, const attempt *how,
                     ovr_outcome *outcome)
{
    ovr_cycling c = cycling_of(sim, how);
    bool close = ovr_guess(sim, dT, how->extrapolate) &&
                 sim->options.smoother == OVR_LINE && c.sweeps_before > 0;
    OVR_EACH_PHYSICS(sim, p, attempt)
        p->is->attempt(sim, p->own, how == attempts);
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

/* Surfaces that are apart cost what those without a law do: cycles know nothing
 * of it, and the next attempt does if it bears something after all. */
static bool try_once(ovr_simulation *sim, double dT, const attempt *how,
                     ovr_outcome *outcome)
{
    ovr_touch *touch = &sim->grids.touch;
    const ovr_touch law = *touch;
    if (!law.at || how != attempts || !were_apart(sim))
        return try_with(sim, dT, how, outcome);
    memset(sim->borne, 0, sim->now.n * sizeof *sim->borne);
    touch->at = NULL;
    bool solved = try_with(sim, dT, how, outcome);
    touch->at = law.at;
    return solved && are_apart(sim);
}

static void begin_step(ovr_simulation *sim, double dT)
{
    double T = sim->past.T[0] + dT;
    OVR_EACH_PHYSICS(sim, p, before_step)
        p->is->before_step(sim, p->own, T);
    ovr_slide(sim, T);
    ovr_time_derivative(sim, dT);
    OVR_EACH_PHYSICS(sim, p, step)
        p->is->step(sim, p->own, dT);
    ovr_simulation_gap(sim, T);
    sim->finest->force = OVR_NOMINAL_LOAD * ovr_history_value(sim->load, T);
}

/* The oldest of `count` becomes the newest, with these values. */
static void keep(double *ages[], int count, const double *values, size_t n)
{
    double *oldest = ages[count - 1];
    memmove(ages + 1, ages, (size_t)(count - 1) * sizeof *ages);
    ages[0] = memcpy(oldest, values, n * sizeof *values);
}

/* The solution becomes the newest of the past. */
static void end_step(ovr_simulation *sim, double dT)
{
    ovr_past *past = &sim->past;
    ovr_guess_learn(sim, dT);
    ovr_physics_keep_borne(sim);
    OVR_EACH_PHYSICS(sim, p, taken)
        p->is->taken(sim, p->own, dT);
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
    double S = change(n, sim->S, sim->S_past);
    sim->past.change = sim->heights && S > P ? S : P;
}

/* A step, in halves if it must be. */
static bool advance(ovr_simulation *sim, double dT, int halvings,
                    ovr_outcome *outcome)
{
    begin_step(sim, dT);
    for (size_t k = 0; k < ATTEMPTS; k++) {
        if (k)
            outcome->retries++;
        if (try_once(sim, dT, &attempts[k], outcome)) {
            outcome->error = ovr_step_error(sim, dT);
            if (outcome->error > sim->largest_error)
                return false;
            end_step(sim, dT);
            return true;
        }
        /* a tolerance that rounding does not let R reach, which has come as
         * far as it goes */
        if (ovr_below_rounding(sim, &outcome->defect) &&
            ovr_surfaces_apart(sim)) {
            outcome->marked = true;
            end_step(sim, dT);
            return true;
        }
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
    sim->grids.H0 = sim->past.H0[0];
    sim->state.T = sim->past.T[0];
    OVR_EACH_PHYSICS(sim, p, before_back)
        p->is->before_back(sim, p->own);
    ovr_slide(sim, sim->state.T);
    ovr_nodes_write(sim, sim->finest, sim->past.P[0], sim->finest->f.P);
    ovr_simulation_gap(sim, sim->past.T[0]);
    ovr_physics_borne_back(sim);
    OVR_EACH_PHYSICS(sim, p, step_back)
        p->is->step_back(sim, p->own);
    ovr_level_refresh(&sim->grids, sim->finest);
    ovr_simulation_read(sim);
}

/* What a physics does not stand by is marked as a film that did not converge
 * is. */
static void mark(ovr_simulation *sim, ovr_outcome *outcome)
{
    OVR_EACH_PHYSICS(sim, p, marks)
        if (p->is->marks(sim, p->own)) {
            sim->observation.marked = outcome->marked = true;
            sim->observation.converged = outcome->converged = false;
        }
}

static void count(ovr_simulation *sim, const ovr_outcome *outcome)
{
    ovr_statistics *s = &sim->statistics;
    s->steps++;
    s->cycles += outcome->cycles;
    s->retries += outcome->retries;
    s->marked += outcome->marked;
}

/* Nodes, or ghosts before them, where the film was one and two steps ago. */
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
        return ovr_fail(
            err, OVR_BAD_INPUT,
            "a step needs a converged steady start: call that first");
    if (!(dT > 0) || !isfinite(dT))
        return ovr_fail(err, OVR_BAD_INPUT, "time step %g: must be positive",
                        dT);
    if (sim->scheme->characteristic && !departures_are_there(sim, dT))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "time step %g: the characteristic scheme takes at "
                        "most %d mesh sizes",
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
    *taken = advance(sim, dT, 0, &outcome);
    *error = outcome.error;
    if (!*taken && outcome.error > sim->largest_error) {
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
    sim->largest_error = INFINITY;
    ovr_status status = ovr_simulation_attempt(sim, sim->past.T[0] + dT, &taken,
                                               &error, err);
    ovr_simulation_end(sim);
    return status;
}
