/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solves a prepared run or one of its passes to the end. */
#include <math.h>
#include <string.h>
#include <time.h>

#include "base/error.h"
#include "case/resolve.h"
#include "contact/contact.h"
#include "physics/plastic/plastic.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/pass_series.h"
#include "run/review.h"
#include "run/run.h"
#include "simulation/internal.h"

/* ------------------------------------------------------------------- Set up */

void ovr_run_surface(const ovr_run *run, ovr_simulation *sim)
{
    if (!run->how.heights)
        return;
    ovr_simulation_surface(sim, run->how.heights, run->how.data);
    ovr_simulation_moving(sim, NAN);
    ovr_simulation_sides(sim, NULL, NULL);
}

/* Replaces the domain of the case by that of the checkpoint: a resumed run
 * keeps its grid even if a changed key would choose another.  Without a state
 * in the checkpoint the case chooses the domain again. */
static void set_recorded_domain(ovr_setup *setup, const ovr_restart_info *of)
{
    ovr_options *o = setup->options;
    if (!of->has_state || of->level <= 0)
        return;
    setup->resolved->recorded = true;
    o->inlet = of->inlet;
    o->outlet = of->outlet;
    o->level = of->level;
}

ovr_status ovr_run_set_up(ovr_run *run, ovr_error *err)
{
    const ovr_allocator *allocator = &run->arena.allocator;
    if (!run->setup)
        run->setup = ovr_case_resolve(run->c, allocator, err);
    if (!run->setup)
        return OVR_BAD_INPUT;
    if (run->restart)
        set_recorded_domain(run->setup, ovr_restart_get_info(run->restart));
    if (run->resumed && !run->passes && run->setup->passes->number > 1)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is the result of one of several passes; use "
                        "'overroll resume' with the file of all passes",
                        run->info.output);
    if (run->passes && ovr_passes_feed(run, err))
        return OVR_BAD_INPUT;
    run->sim = ovr_setup_simulation(run->setup, allocator, err);
    if (!run->sim)
        return OVR_BAD_INPUT;
    ovr_run_surface(run, run->sim);
    run->info.transient = run->setup->transient && !run->how.steady;
    run->info.setup = run->setup;
    run->info.lambda_ratio = run->info.life_together = NAN;
    run->info.elastic_length = run->info.elastic_ratio = NAN;
    run->info.shear_over_pressure = run->info.unbearable_share = NAN;
    run->info.sim = run->sim;
    if (ovr_setup_rough_film(run->setup, allocator, &run->predicted, err))
        return OVR_NO_MEMORY;
    return run->how.steady ? OVR_OK : ovr_companions_make(run, err);
}

/* -------------------------------------------------------------------- Solve */

double ovr_run_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Reports the progress and ends the run on request. It is the last observer. */
static ovr_status report_progress(void *data, const ovr_simulation *sim,
                                  ovr_error *err)
{
    ovr_run *run = data;
    const ovr_run_options *how = &run->how;
    double T = ovr_simulation_state(sim)->T;
    run->info.fraction = run->info.transient
                             ? fmin(T / run->setup->march->end, 1)
                             : 1;
    if (run->passes)
        run->info.fraction = (run->passes->now - 1 + run->info.fraction) /
                             run->passes->rows;
    if (how->progress && run->info.transient)
        how->progress(how->data, run, run->info.fraction);
    if (how->stop && how->stop(how->data))
        return ovr_fail(err, OVR_STOPPED, "stopped at T = %g", T);
    return OVR_OK;
}

/* True if discretization errors are estimated. For complete files they are not
 * estimated again. */
static bool estimates(const ovr_run *run)
{
    bool complete = run->resumed && !run->writer;
    return run->how.estimate_error || (run->setup->confirm && !complete);
}

/* True for resumed passes: the preceding passes on coarser levels are not
 * stored in any file. */
static bool passes_are_lost(const ovr_run *run)
{
    return run->resumed && run->passes;
}

static ovr_status solve(ovr_run *run, ovr_error *err)
{
    ovr_march how;
    ovr_observer observer[5];
    ovr_status status = OVR_OK;
    ovr_simulation_stop(run->sim, run->how.interrupt, run->how.data);
    if (!run->restored)
        status = ovr_simulation_steady(run->sim, err);
    if (!status && run->info.output && !run->writer &&
        ovr_setup_makes_nodes(run->setup))
        status = ovr_output_open(run, err);
    ovr_setup_step_reached(run->setup, ovr_simulation_order(run->sim));
    how = *run->setup->march;
    how.count = 0;
    how.observers = observer;
    if (run->company[0].is)
        observer[how.count++] = (ovr_observer){ovr_companions_observe, NULL,
                                               run};
    if (run->writer)
        observer[how.count++] = ovr_writer_observer(run->writer);
    if (run->passes && estimates(run) && !passes_are_lost(run)) {
        ovr_pass_level *own = &run->passes->level[0];
        ovr_pass_level_begin(own, &run->arena.allocator);
        observer[how.count++] = ovr_pass_history_observer(&own->seen);
    }
    if (run->how.observe)
        observer[how.count++] = (ovr_observer){run->how.observe, NULL,
                                               run->how.data};
    observer[how.count++] = (ovr_observer){report_progress, NULL, run};
    if (!status && run->info.transient)
        return ovr_simulation_march(run->sim, &how, err);
    for (size_t k = 0; !status && k < how.count; k++)
        status = observer[k].observe(observer[k].data, run->sim, err);
    return status;
}

/* True if the run has a state to report; a run stopped in its steady start has
 * none. */
static bool has_state(const ovr_run *run, ovr_status status)
{
    return !status || (status == OVR_STOPPED && run->sim->started) ||
           status == OVR_NOT_CONVERGED || status == OVR_IMPOSSIBLE;
}

/* Calls the companions at the end of a run, also of a stopped one. */
static ovr_status finish(ovr_run *run, ovr_status status, ovr_error *err)
{
    ovr_error late = {0};
    ovr_status finished;
    if ((status && status != OVR_STOPPED) || !has_state(run, status))
        return status;
    finished = ovr_companions_finish(run, &late);
    if (!finished || status)
        return status;
    *err = late;
    return finished;
}

static ovr_run_status ending(ovr_status status)
{
    if (status == OVR_OK)
        return OVR_RUN_COMPLETE;
    return status == OVR_STOPPED ? OVR_RUN_STOPPED : OVR_RUN_FAILED;
}

/* Returns all warnings, one per line; NULL if memory is insufficient. */
static const char *warnings_text(ovr_run *run)
{
    const ovr_run_info *info = &run->info;
    size_t capacity = 1, used = 0;
    char *text;
    for (int k = 0; k < info->warnings; k++)
        capacity += strlen(info->warning[k]) + 1;
    text = ovr_arena_take(&run->arena, capacity, 1, NULL);
    for (int k = 0; text && k < info->warnings; k++)
        used += (size_t)snprintf(text + used, capacity - used, "%s%s",
                                 k ? "\n" : "", info->warning[k]);
    return text;
}

/* Closes the file also after an error. Returns the first error. */
static ovr_status close_file(ovr_run *run, ovr_status status, ovr_error *err)
{
    ovr_error late = {0};
    ovr_status closed;
    size_t snapshots = 0;
    if (!run->writer)
        return status;
    ovr_writer_warnings(run->writer, warnings_text(run));
    if (ending(status) == OVR_RUN_FAILED)
        ovr_writer_reason(run->writer, err->message);
    closed = ovr_writer_close(run->writer, ending(status), &snapshots, &late);
    run->writer = NULL;
    run->info.snapshots = snapshots;
    if (status || !closed)
        return status;
    *err = late;
    return closed;
}

/* Estimates errors of one of several passes. If the estimate fails, the passes
 * continue without it. */
static ovr_status estimate_pass(ovr_run *run, ovr_error *err)
{
    ovr_error why = {0};
    if (run->passes->level[1].lost || !ovr_run_estimate(run, &why))
        return OVR_OK;
    if (why.status == OVR_STOPPED)
        return ovr_fail(err, OVR_STOPPED, "%s", why.message);
    run->passes->level[1].lost = true;
    ovr_run_warn(run, "errors cannot be estimated from here on: %.900s",
                 why.message);
    return OVR_OK;
}

/* True if the body begins with plastic strains. They are stored at the points
 * of this level only, so coarser levels would begin without them. */
static bool strains_are_lost(const ovr_run *run)
{
    const ovr_plastic_setup *plastic = ovr_setup_plastic(run->setup);
    return plastic && plastic->initial;
}

static void warn_of_lost_strains(ovr_run *run)
{
    if (run->passes && run->passes->level[1].lost)
        return;
    if (run->passes)
        run->passes->level[1].lost = true;
    ovr_run_message(run, OVR_MESSAGE_WARNING,
                    "no error estimates from this pass on, because the bodies "
                    "start with plastic strains, which are unknown on "
                    "coarser levels; run the first pass alone on another "
                    "level");
}

/* Estimates discretization errors if requested, before the file is closed, so
 * that they are stored in it. */
static ovr_status estimate(ovr_run *run, ovr_error *err)
{
    run->error = (ovr_run_errors){0}; /* clears those of the preceding pass */
    if (!estimates(run))
        return OVR_OK;
    if (passes_are_lost(run)) {
        ovr_run_message(run, OVR_MESSAGE_WARNING,
                        "errors cannot be estimated from here on: the coarser "
                        "passes before the run was stopped are not kept");
        return OVR_OK;
    }
    if (strains_are_lost(run)) {
        warn_of_lost_strains(run);
        return OVR_OK;
    }
    if (run->setup->confirm)
        return ovr_run_confirm(run, err);
    if (run->passes)
        return estimate_pass(run, err);
    return ovr_run_estimate(run, err);
}

/* True if the force balance is satisfied well enough to call the solution
 * converged; a user's tolerance may not ensure that. A start without load has
 * the load OVR_MIN_START. */
static bool carries_load(ovr_run *run)
{
    const double maximum = 1e-4;
    double error = ovr_simulation_statistics(run->sim)->extreme.load_error;
    double ratio = ovr_simulation_observation(run->sim)->load_ratio;
    bool unloaded = ovr_history_value(run->setup->load, 0) < OVR_MIN_START;
    double given = unloaded ? OVR_MIN_START : 0;
    if (!(fabs(error) > given + maximum * fmax(1, ratio)))
        return true;
    ovr_warn(ovr_run_message, run,
             "not converged: the load error is %.2g of the reference load; "
             "reduce solver.tolerance",
             fabs(error));
    return false;
}

/* Runs to the end or until stopped. */
ovr_status ovr_run_once(ovr_run *run, ovr_error *err)
{
    double begun = ovr_run_clock();
    bool first = !run->passes || run->passes->now == 1;
    ovr_error own = {0};
    ovr_status status, late;
    long marked;
    if (first)
        ovr_run_review_before(run);
    status = finish(run, solve(run, err), err);
    if (has_state(run, status))
        ovr_run_review_after(run);
    marked = ovr_simulation_statistics(run->sim)->marked;
    run->info.marked += marked;
    run->info.seconds = ovr_run_clock() - begun;
    run->info.converged = !status && !marked &&
                          ovr_simulation_observation(run->sim)->converged &&
                          carries_load(run);
    if (status)
        return close_file(run, status, err);
    late = estimate(run, err);
    if (late == OVR_STOPPED) { /* the solution so far stays and can be
                                * resumed */
        run->info.converged = false;
        return close_file(run, late, err);
    }
    if (run->writer)
        ovr_run_keep_summary(run, &own);
    if (run->writer && run->info.transient)
        ovr_run_keep_element(run, &own);
    status = close_file(run, OVR_OK, late ? &own : err);
    run->info.converged = run->info.converged && !status;
    return late ? late : status;
}
