/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll steady [CASE]: one steady contact. */
#include "cli/case_args.h"
#include "cli/sensitivity.h"
#include "cli/watch.h"

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_error err = {0};
    cli_watch watch = {.call = call};
    ovr_run_options how = cli_run_options(&watch);
    if (!c)
        return code;
    if (cli_flag(call, "sensitivity")) {
        code = cli_sensitivity(call, c, true);
        ovr_case_free(c);
        return code;
    }
    how.steady = true;
    how.at = cli_value(call, "at");
    code = cli_finish_run(&watch, ovr_run_create(c, &how, NULL, &err), &err);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    {"at", "STATION",
     "of [gear] or [cam]: A to E, nose, an angle or a time; the pitch point or "
     "the nose unless given",
     false},
    CLI_ESTIMATE_OPTION,
    CLI_SENSITIVITY_OPTIONS,
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_steady = {
    .name = "steady",
    .arguments = "[CASE] [--M 20 --L 10 --level 9]",
    .summary = "solve one steady contact",
    .help = "Solves the steady contact of the case (its [time] and the growth "
            "of its\nfeatures do not count), or of --M and --L without a case.",
    .options = options,
    .minimum = 0,
    .maximum = 1,
    .run = run,
    .steady = true,
};
