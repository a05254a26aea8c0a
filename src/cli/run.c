/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll run CASE: from the steady start through time, stored on the way. */
#include "cli/run.h"
#include "cli/case_args.h"
#include "cli/estimate.h"
#include "cli/march.h"
#include "cli/store.h"

static int march_case(const cli_call *call, ovr_case *c, ovr_setup *setup,
                      const char *output, bool force)
{
    ovr_error err = {0};
    ovr_writer *writer = NULL;
    ovr_simulation *sim = NULL;
    int code;
    if (cli_check_output(output, force, &err))
        sim = ovr_setup_simulation(setup, NULL, &err);
    if (sim && output)
        writer = cli_open_output(c, setup, sim, output, force, &err);
    if (sim && (writer || !output)) {
        cli_job job = {c, setup, sim, writer, output, false};
        code = cli_march(call, &job);
    } else {
        code = cli_fail(&err);
    }
    ovr_simulation_free(sim);
    return code;
}

int cli_run_case(const cli_call *call, ovr_case *c, const char *output,
                 bool force)
{
    ovr_error err = {0};
    ovr_setup *setup = ovr_case_resolve(c, NULL, &err);
    int code;
    if (setup && !output)
        output = setup->output.file;
    code = setup ? march_case(call, c, setup, output, force) : cli_fail(&err);
    ovr_setup_free(setup);
    return code;
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    if (!c)
        return code;
    code = cli_run_case(call, c, cli_value(call, "o"), cli_flag(call, "force"));
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
