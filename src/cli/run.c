/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll run CASE: from the steady start through time, stored on the way. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/store.h"

/* What the observer of the march needs. */
typedef struct running {
    ovr_writer *writer; /* NULL: nothing is stored */
    cli_progress progress;
    double end;
} running;

static void show(running *r, const ovr_simulation *sim)
{
    const ovr_observation *o = ovr_simulation_observation(sim);
    const ovr_state *state = ovr_simulation_state(sim);
    char what[120];
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

static ovr_status march(ovr_setup *setup, ovr_simulation *sim, running *r,
                        ovr_error *err)
{
    ovr_march how = setup->march;
    ovr_status status = ovr_simulation_steady(sim, err);
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

static int solve(const cli_call *call, ovr_setup *setup, ovr_simulation *sim,
                 running *r, const char *output)
{
    cli_summary summary = {.setup = setup, .sim = sim, .output = output};
    ovr_error err = {0};
    double begun = cli_seconds();
    ovr_status status;
    summary.run = setup->transient;
    cli_warn_before(call, &summary);
    cli_catch_signals();
    r->end = setup->transient ? setup->march.end : 1;
    r->progress = cli_progress_begin(setup->transient ? call->verbosity : -1,
                                     0);
    status = march(setup, sim, r, &err);
    cli_progress_end(&r->progress);
    status = close_file(r, &summary, status, &err);
    summary.seconds = cli_seconds() - begun;
    summary.converged = status == OVR_OK &&
                        ovr_simulation_observation(sim)->converged &&
                        ovr_simulation_statistics(sim)->marked == 0;
    if (!status || status == OVR_STOPPED || status == OVR_NOT_CONVERGED) {
        cli_warn_after(call, &summary);
        cli_report(call, &summary);
    }
    return exit_code(call, &summary, status, &err);
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup = NULL;
    ovr_simulation *sim = NULL;
    running r = {0};
    ovr_error err = {0};
    const char *output;
    bool ready;
    if (!c)
        return code;
    setup = ovr_case_resolve(c, NULL, &err);
    output = cli_value(call, "o");
    if (setup && !output)
        output = setup->output.file;
    ready = setup && cli_check_output(output, cli_flag(call, "force"), &err);
    if (ready)
        sim = ovr_setup_simulation(setup, NULL, &err);
    if (sim && output)
        r.writer = cli_open_output(c, setup, sim, output,
                                   cli_flag(call, "force"), &err);
    if (r.writer)
        ovr_writer_checkpoints(r.writer, sim);
    if (sim && (r.writer || !output))
        code = solve(call, setup, sim, &r, output);
    else
        code = cli_fail(&err);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    {"o", "OUT.h5", "result file, instead of [output] file", false},
    {"force", NULL, "replace an existing result file", false},
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_run = {
    .name = "run",
    .arguments = "CASE [-o OUT.h5]",
    .summary = "march in time (a case without [time] end is steady)",
    .help =
        "Solves the steady start and marches to the end of time, storing "
        "snapshots and\nthe history in the result file as it goes.  Without a "
        "file only the summary is\nprinted.  SIGINT and SIGTERM finish the "
        "step and close the file.",
    .options = options,
    .least = 1,
    .most = 1,
    .run = run,
};
