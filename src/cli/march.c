/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/march.h"

#include <math.h>

#include "cli/progress.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/store.h"

/* What the observer of the march needs. */
typedef struct running {
    ovr_writer *writer; /* NULL: nothing is stored */
    cli_progress progress;
    double end;
    volatile double *done; /* told the fraction done, or NULL */
} running;

static void show(running *r, const ovr_simulation *sim)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    const ovr_state *state = ovr_simulation_state(sim);
    char what[120];
    if (r->done)
        *r->done = state->T / r->end;
    snprintf(what, sizeof what, "T = %.3f of %g  step %ld  residual %.1e",
             state->T, r->end, state->step, o->residual);
    cli_progress_show(&r->progress, state->T / r->end, what);
}

static ovr_status observe(void *data, const ovr_simulation *sim, ovr_error *err)
{
    running *r = data;
    ovr_status status = r->writer ? ovr_writer_observe(r->writer, sim, err)
                                  : OVR_OK;
    if (status)
        return status;
    show(r, sim);
    if (cli_signal())
        return ovr_fail(err, OVR_STOPPED, "stopped by signal %d at T = %g",
                        cli_signal(), ovr_simulation_state(sim)->T);
    return OVR_OK;
}

static double next_time(void *data, double T)
{
    running *r = data;
    return r->writer ? ovr_writer_next_time(r->writer, T) : INFINITY;
}

static ovr_status march(const cli_job *job, running *r, ovr_error *err)
{
    ovr_setup *setup = job->setup;
    ovr_simulation *sim = job->sim;
    ovr_march how = setup->march;
    ovr_status status = OVR_OK;
    if (!job->restored)
        status = ovr_simulation_steady(sim, err);
    if (status)
        return status;
    if (!setup->transient)
        return observe(r, sim, err);
    how.observe = observe;
    how.next_time = next_time;
    how.data = r;
    return ovr_simulation_march(sim, &how, err);
}

static ovr_run_status ending(ovr_status status)
{
    if (status == OVR_OK)
        return OVR_RUN_COMPLETE;
    return status == OVR_STOPPED ? OVR_RUN_STOPPED : OVR_RUN_FAILED;
}

/* Closes the file whatever happened; the first error is the one told. */
static ovr_status close_file(running *r, cli_summary *summary,
                             ovr_status status, ovr_error *err)
{
    ovr_error late = {0};
    ovr_status closed;
    if (!r->writer)
        return status;
    if (ending(status) == OVR_RUN_FAILED)
        ovr_writer_reason(r->writer, err->message);
    closed = ovr_writer_close(r->writer, ending(status), &late);
    summary->snapshots = cli_count_snapshots(summary->output);
    if (status || !closed)
        return status;
    *err = late;
    return closed;
}

static int exit_code(const cli_call *call, const cli_summary *summary,
                     ovr_status status, const ovr_error *err)
{
    long marked = ovr_simulation_statistics(summary->sim)->marked;
    if (status == OVR_STOPPED && cli_signal()) {
        if (call->verbosity >= 0)
            fprintf(stderr, "overroll: %s\n", err->message);
        return CLI_SIGNAL + cli_signal();
    }
    if (status)
        return cli_fail(err);
    if (marked && call->verbosity >= 0)
        fprintf(stderr,
                "overroll: %ld of %ld steps were accepted above the "
                "tolerance; they are marked in the history\n",
                marked, ovr_simulation_statistics(summary->sim)->steps);
    return marked ? CLI_EARLY : CLI_DONE;
}

/* What is done of the whole when it begins. */
static double done_before(const cli_job *job, double end)
{
    return job->restored ? ovr_simulation_state(job->sim)->T / end : 0;
}

int cli_march(const cli_call *call, const cli_job *job)
{
    cli_summary summary = {
        .setup = job->setup, .sim = job->sim, .output = job->output};
    bool transient = job->setup->transient;
    running r = {.writer = job->writer, .done = call->done};
    ovr_error err = {0};
    double begun = cli_seconds();
    ovr_status status;
    summary.run = transient;
    cli_say_assumed(call, &summary);
    cli_warn_before(call, &summary);
    cli_catch_signals();
    r.end = transient ? job->setup->march.end : 1;
    r.progress = cli_progress_begin(transient ? call->verbosity : -1,
                                    done_before(job, r.end));
    status = march(job, &r, &err);
    cli_progress_end(&r.progress);
    status = close_file(&r, &summary, status, &err);
    summary.seconds = cli_seconds() - begun;
    summary.converged = status == OVR_OK &&
                        ovr_simulation_observation(job->sim)->converged &&
                        ovr_simulation_statistics(job->sim)->marked == 0;
    if (!status && job->c && cli_flag(call, "estimate-error"))
        status = cli_estimate_error(job->c, job->sim, !transient,
                                    &summary.error, &err);
    if (!status || status == OVR_STOPPED || status == OVR_NOT_CONVERGED ||
        status == OVR_IMPOSSIBLE) {
        cli_warn_after(call, &summary);
        cli_report(call, &summary);
    }
    return exit_code(call, &summary, status, &err);
}
