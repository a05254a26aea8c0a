/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * overroll resume OUT.h5: goes on where a run ended, from the checkpoint
 * beside its file.  Without a checkpoint (it was lost, or the run was killed
 * before its first one) the run begins again, on the case in the file.
 */
#include <stdio.h>
#include <unistd.h>

#include "cli/case_args.h"
#include "cli/march.h"
#include "cli/run.h"
#include "cli/store.h"

typedef struct resuming {
    const cli_call *call;
    const char *path;
    ovr_restart *restart; /* NULL: there is none */
    ovr_case *c;
    ovr_setup *setup;
    ovr_simulation *sim;
    ovr_writer *writer;
    bool restored;
} resuming;

static void say(const resuming *r, const char *what)
{
    if (r->call->verbosity >= 0)
        fprintf(stderr, "%s: %s\n", r->path, what);
}

static bool has_checkpoint(const char *path)
{
    char name[4096];
    int length = snprintf(name, sizeof name, "%s.restart", path);
    return length > 0 && length < (int)sizeof name && access(name, F_OK) == 0;
}

/* The case as the result file holds it, for want of a checkpoint. */
static ovr_status case_of_result(resuming *r, ovr_error *err)
{
    ovr_result *result = ovr_result_open(r->path, NULL, err);
    if (!result)
        return OVR_BAD_INPUT;
    r->c = ovr_case_read_text(ovr_result_about(result)->case_text, r->path,
                              NULL, NULL, err);
    ovr_result_close(result);
    return r->c ? OVR_OK : OVR_BAD_INPUT;
}

static ovr_status find_case(resuming *r, ovr_error *err)
{
    const ovr_restart_info *about;
    if (access(r->path, F_OK) != 0 || !has_checkpoint(r->path))
        return case_of_result(r, err);
    r->restart = ovr_restart_open(r->path, NULL, err);
    if (!r->restart)
        return OVR_BAD_INPUT;
    about = ovr_restart_about(r->restart);
    r->c = ovr_case_read_text(about->case_text, r->path, about->case_path, NULL,
                              err);
    return r->c ? OVR_OK : OVR_BAD_INPUT;
}

static ovr_status make_simulation(resuming *r, ovr_error *err)
{
    if (cli_apply_options(r->call, r->c, err))
        return OVR_BAD_INPUT;
    r->setup = ovr_case_resolve(r->c, NULL, err);
    if (r->setup)
        r->sim = ovr_setup_simulation(r->setup, NULL, err);
    return r->sim ? OVR_OK : OVR_BAD_INPUT;
}

static ovr_status go_back(resuming *r, ovr_error *err)
{
    r->writer = cli_reopen_output(r->c, r->setup, r->sim, r->path, r->restart,
                                  err);
    if (!r->writer)
        return OVR_BAD_INPUT;
    r->restored = r->restart && ovr_restart_about(r->restart)->has_state;
    if (ovr_writer_repaired(r->writer))
        say(r, "its last write had been cut and is repaired");
    if (!r->restored)
        say(r, "has no checkpoint: the run begins again");
    return OVR_OK;
}

static void say_where(const resuming *r)
{
    char what[120];
    const ovr_state *state = ovr_simulation_state(r->sim);
    if (!r->restored)
        return;
    snprintf(what, sizeof what, "goes on from T = %g, step %ld", state->T,
             state->step);
    say(r, what);
}

static int go_on(resuming *r)
{
    ovr_error err = {0};
    cli_job job;
    if (find_case(r, &err) || make_simulation(r, &err) || go_back(r, &err))
        return cli_fail(&err);
    say_where(r);
    job = (cli_job){NULL, r->setup, r->sim, r->writer, r->path, r->restored};
    return cli_march(r->call, &job);
}

int cli_resume_file(const cli_call *call, const char *path)
{
    resuming r = {.call = call, .path = path};
    int code = go_on(&r);
    ovr_simulation_free(r.sim);
    ovr_setup_free(r.setup);
    ovr_case_free(r.c);
    ovr_restart_close(r.restart);
    return code;
}

static int run(cli_call *call)
{
    return cli_resume_file(call, call->argument[0]);
}

static const cli_option options[] = {CLI_CASE_OPTIONS, {0}};

const cli_verb cli_resume = {
    .name = "resume",
    .arguments = "OUT.h5",
    .summary = "go on where a stopped run ended",
    .help = "The result is the one of a run that was never interrupted.  "
            "--set may change\ntime.end and what is stored ([output]), not "
            "what is solved.",
    .options = options,
    .least = 1,
    .most = 1,
    .run = run,
};
