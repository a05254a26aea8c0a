/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll run CASE: from the steady start through time, stored on the way. */
#include "cli/case_args.h"
#include "cli/estimate.h"
#include "cli/march.h"
#include "cli/store.h"

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup = NULL;
    ovr_simulation *sim = NULL;
    ovr_writer *writer = NULL;
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
        writer = cli_open_output(c, setup, sim, output, cli_flag(call, "force"),
                                 &err);
    if (sim && (writer || !output)) {
        cli_job job = {c, setup, sim, writer, output, false};
        code = cli_march(call, &job);
    } else {
        code = cli_fail(&err);
    }
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    {"o", "OUT.h5", "result file, instead of [output] file", false},
    {"force", NULL, "replace an existing result file", false},
    CLI_ESTIMATE_OPTION,
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
