/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll resume OUT.h5: continues where a run ended. */
#include "cli/case_args.h"
#include "cli/watch.h"

static ovr_status change(void *data, ovr_case *c, ovr_error *err)
{
    const cli_watch *watch = data;
    return cli_apply_options(watch->call, c, err);
}

static int run(cli_call *call)
{
    ovr_error err = {0};
    cli_watch watch = {.call = call};
    ovr_run_options how = cli_run_options(&watch);
    how.change = change;
    how.from_start = cli_flag(call, "from-start");
    how.force = cli_flag(call, "force");
    cli_silence_the_end();
    return cli_finish_run(
        &watch, ovr_run_resume(call->argument[0], &how, NULL, &err), &err);
}

static const cli_option options[] = {
    {"from-start", NULL, "with --force: start again if the checkpoint is lost",
     false},
    {"force", NULL, "replace the contents of the file", false},
    CLI_ESTIMATE_OPTION,
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_resume = {
    .name = "resume",
    .arguments = "OUT.h5",
    .summary = "continue a stopped run",
    .help = "The result equals that of an uninterrupted run.  --set may change "
            "time.end and\n[output], but not the problem.  A complete file is "
            "not changed.",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = run,
};
