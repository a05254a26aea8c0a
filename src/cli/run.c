/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll run CASE: from the steady start through time, stored on the way. */
#include "cli/run.h"

#include "cli/case_args.h"
#include "cli/sensitivity.h"
#include "cli/watch.h"

int cli_run_case(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_error err = {0};
    cli_watch watch = {.call = call};
    ovr_run_options how = cli_run_options(&watch);
    if (!c)
        return code;
    how.steady = call->verb->steady;
    how.at = cli_value(call, "at");
    how.output = cli_value(call, "o");
    how.force = cli_flag(call, "force");
    if (!how.steady)
        cli_silence_the_end();
    code = cli_flag(call, "sensitivity")
               ? cli_sensitivity(call, c, how.steady)
               : cli_finish_run(&watch, ovr_run_create(c, &how, NULL, &err),
                                &err);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    {"o", "OUT.h5", "result file (instead of output.file)", false},
    {"force", NULL, "replace an existing result file", false},
    CLI_ESTIMATE_OPTION,
    CLI_SENSITIVITY_OPTIONS,
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_run = {
    .name = "run",
    .arguments = "CASE [-o OUT.h5]",
    .summary = "run a case in time (without time.end: the steady contact)",
    .help =
        "Solves the steady start and advances to the end time.  Snapshots "
        "and the history\n"
        "are written to the result file during the run.  Without a file only "
        "the summary\n"
        "is printed.  After SIGINT, SIGTERM or SIGHUP the step is finished "
        "and the file is\n"
        "closed.",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = cli_run_case,
};
