/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The time loop: performs steps and calls observers; it does not access files.
 *
 * Fixed steps end at exactly k dT, without accumulated rounding errors. A step
 * is divided to reach the times requested by observers. Adaptive steps follow
 * the error e ~ dT^p that they add to the film on its way through the contact
 * (time_derivative.c), p the order.  They are D times a power of 2 and are
 * constant for a while, so that extrapolation remains valid: shorter if e
 * exceeds the target error, twice as long if e would remain below 0.7 of it. A
 * step with more than three times the target error is repeated.
 */
#include <float.h>
#include <math.h>

#include "base/given.h"
#include "simulation/physics.h"
#include "simulation/solver.h"

/* The state is considered constant if neither P nor S changes by more than this
 * times dT in STILL consecutive steps. Disturbances leave the contact within a
 * few b/um, so P is then close to its final value. */
static const double still_rate = 1e-8;
enum { STILL = 20 };

/* Minimum adaptive step in mesh sizes; with shorter steps spatial errors
 * dominate. */
static const double min_step = 1. / 8;

/*
 * Longer steps gain little and may miss features that enter.  With steps of 32
 * mesh sizes the film thickness error at the start of motion is 15 % larger,
 * with 64 it is doubled. Temperatures are not part of the error estimate.  In a
 * load ramp (level 7) their error is 7e-4 with 8 mesh sizes and 7e-3 with 16.
 */
double ovr_longest_step(const ovr_simulation *sim)
{
    return sim->heated ? 8 : 16;
}

static ovr_status observe(const ovr_simulation *sim, const ovr_march *march,
                          ovr_error *err)
{
    ovr_status status = OVR_OK;
    for (size_t k = 0; !status && k < march->count; k++)
        status = march->observers[k].observe(march->observers[k].data, sim,
                                             err);
    return status;
}

/* Returns the next time of the fixed grid or adaptive step, or a requested time
 * if that is earlier. */
static double next_time(const ovr_simulation *sim, const ovr_march *march,
                        double dT)
{
    double T = sim->state.T, minimum = 1e-6 * dT, next = T + dT;
    if (!march->adaptive)
        next = (floor(T / dT + 1e-6) + 1) * dT;
    else if (next > march->end - minimum)
        next = march->end;
    for (size_t k = 0; k < march->count; k++) {
        const ovr_observer *o = &march->observers[k];
        double asked = o->next_time ? o->next_time(o->data, T + minimum) : next;
        if (asked > T + minimum && asked < next - minimum)
            next = asked;
    }
    return next;
}

static double target_error(const ovr_march *march)
{
    return march->error > 0 ? march->error : 1e-3;
}

static double regulated(const ovr_simulation *sim, const ovr_march *march,
                        double dT, double error)
{
    double D = ovr_mesh(sim), order = sim->scheme->order;
    double ratio = error / target_error(march);
    double power = floor(log2(dT / D) + 1e-9);
    if (ratio > 1)
        power -= fmax(1, ceil(log2(ratio) / order - 0.3));
    else if (ratio < 0.7 * exp2(-order))
        power++;
    return fmin(ovr_longest_step(sim) * D, fmax(min_step * D, exp2(power) * D));
}

/* Repeats a step with shorter lengths until it is accepted; at the minimum
 * length any error is accepted. */
static ovr_status adaptive_step(ovr_simulation *sim, const ovr_march *march,
                                ovr_error *err)
{
    double target = target_error(march), error;
    double dT = sim->past.dT_next > 0 ? sim->past.dT_next : ovr_mesh(sim);
    for (bool taken = false; !taken;) {
        double next = next_time(sim, march, dT), step = next - sim->state.T;
        bool shortest = step <= 1.01 * min_step * ovr_mesh(sim);
        sim->limits.largest_error = shortest ? DBL_MAX : 3 * target;
        ovr_status status = ovr_simulation_attempt(sim, next, &taken, &error,
                                                   err);
        if (status)
            return status;
        /* a step that was shortened to reach a requested time is no reason to
         * change dT */
        if (!taken || step > 0.99 * dT || error > target)
            dT = regulated(sim, march, step, error);
        sim->past.dT_next = dT;
    }
    return OVR_OK;
}

static bool has_settled(const ovr_simulation *sim, const ovr_march *march)
{
    OVR_EACH_PHYSICS(sim, p, in_step, over)
        if (p->is->in_step->over(sim, p->own))
            return true;
    return march->until_steady && sim->past.still >= STILL &&
           sim->state.T >= march->steady_from;
}

static double step_of(const ovr_simulation *sim, const ovr_march *march)
{
    return march->dT > 0 ? march->dT : ovr_mesh(sim);
}

static bool has_ended(const ovr_simulation *sim, const ovr_march *march)
{
    return sim->statistics.settled ||
           !(sim->state.T < march->end - 1e-6 * step_of(sim, march));
}

/* Nodes that take as much work as those of the solver. */
static double nodes_of(const ovr_simulation *sim)
{
    const ovr_present *other = sim->physics.solver;
    size_t lines = 1, shown;
    if (!other)
        return (double)sim->now.n;
    other->is->in_solve->solver->lines(other->own, &lines, &shown);
    return (double)(OVR_SOLVER_WORK * lines * sim->now.n);
}

/*
 * Returns 20 times the work that `check` predicts for a run, in node cycles,
 * the program's start included.  A step takes 3.2 cycles, of a shear-thinning
 * film half as many again, and temperatures four times as long.
 */
static double predicted(const ovr_simulation *sim, const ovr_march *march)
{
    const double start = 2e6, cycles = 64, adaptive = 0.07, least = 30;
    double steps = march->end / step_of(sim, march);
    double factor = sim->heated ? 4 : 1;
    if (sim->lubricant.rheology != OVR_NEWTONIAN)
        factor *= 1.6;
    steps = fmax(least, (march->adaptive ? adaptive : 1) * steps);
    return start + factor * cycles * steps * nodes_of(sim);
}

/* Stops a run that has used a minute of CPU time and 20 times the predicted
 * work, if most of its steps needed further attempts. */
static ovr_status check_work(ovr_simulation *sim, const ovr_march *march,
                             ovr_error *err)
{
    const ovr_statistics *s = &sim->statistics;
    double minute = ovr_minute_of_work(sim), limit = predicted(sim, march);
    if (!(sim->limits.work_done > fmax(minute, limit)) || s->retries < s->steps)
        return OVR_OK;
    return ovr_fail(err, OVR_NOT_CONVERGED,
                    "stopped at T = %g after %ld steps with %ld further "
                    "attempts and 20 times the predicted work: the grid or the "
                    "time step does not resolve this run; use a higher level, "
                    "or resume the file",
                    sim->state.T, s->steps, s->retries);
}

static ovr_status advance(ovr_simulation *sim, const ovr_march *march,
                          bool *more, ovr_error *err)
{
    double rate = march->steady_rate > 0 ? march->steady_rate : still_rate;
    ovr_past *past = &sim->past;
    ovr_status status;
    sim->limits.step_work = fmin(ovr_minute_of_work(sim),
                                 predicted(sim, march));
    if (march->adaptive) {
        status = adaptive_step(sim, march, err);
    } else {
        double next = next_time(sim, march, step_of(sim, march)), error;
        bool taken;
        sim->limits.largest_error = INFINITY;
        status = ovr_simulation_attempt(sim, next, &taken, &error, err);
    }
    if (!status && (status = check_work(sim, march, err)) == OVR_OK) {
        past->still = past->change <= rate * past->dT ? past->still + 1 : 0;
        sim->statistics.settled = has_settled(sim, march);
        status = observe(sim, march, err);
    }
    *more = !status && !has_ended(sim, march);
    return status;
}

/* Checks whether a restored run was already constant, if it was stopped at its
 * last step. */
static void check_start(ovr_simulation *sim, const ovr_march *march)
{
    sim->statistics.settled = sim->restored && has_settled(sim, march);
    sim->restored = false;
}

static ovr_status follow(ovr_simulation *sim, const ovr_march *march,
                         ovr_error *err)
{
    ovr_status status = OVR_OK;
    bool more;
    check_start(sim, march);
    more = !has_ended(sim, march);
    if (sim->state.step == 0)
        status = observe(sim, march, err);
    while (!status && more)
        status = advance(sim, march, &more, err);
    return status;
}

static ovr_status copy_options(ovr_march *how, const ovr_march *given,
                               ovr_error *err)
{
    if (OVR_TAKE(ovr_march, how, given, err))
        return OVR_BAD_INPUT;
    if (isnan(how->end) || isnan(how->dT) || isnan(how->error))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "end, dT and error of a march must be numbers");
    if (how->count && !how->observers)
        return ovr_fail_null(err, __func__);
    return OVR_OK;
}

ovr_status ovr_simulation_march(ovr_simulation *sim, const ovr_march *march,
                                ovr_error *err)
{
    if (!sim)
        return ovr_fail_null(err, __func__);
    ovr_march how;
    if (copy_options(&how, march, err) ||
        ovr_simulation_begin(sim, __func__, err))
        return OVR_BAD_INPUT;
    ovr_status status = follow(sim, &how, err);
    ovr_simulation_end(sim);
    return status;
}

ovr_status ovr_simulation_advance(ovr_simulation *sim, const ovr_march *march,
                                  bool *more, ovr_error *err)
{
    if (!sim || !more)
        return ovr_fail_null(err, __func__);
    ovr_march how;
    ovr_status status = OVR_OK;
    *more = false;
    if (copy_options(&how, march, err) ||
        ovr_simulation_begin(sim, __func__, err))
        return OVR_BAD_INPUT;
    check_start(sim, &how);
    if (!has_ended(sim, &how))
        status = advance(sim, &how, more, err);
    ovr_simulation_end(sim);
    return status;
}
