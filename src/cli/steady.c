/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll steady [CASE]: one steady contact. */
#include "cli/case_args.h"
#include "cli/run.h"
#include "cli/sensitivity.h"
#include "cli/watch.h"

static const cli_option options[] = {
    {"at", "STATION",
     "contact position of [gear] or [cam]: A to E, nose, an angle or a time "
     "(default: pitch point or nose)",
     false},
    CLI_ESTIMATE_OPTION,
    CLI_SENSITIVITY_OPTIONS,
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_steady = {
    .name = "steady",
    .arguments = "[CASE] [--M 20 --L 10 --level 9]",
    .summary = "solve one steady contact",
    .help = "Solves the steady contact of the case (ignoring [time] and the "
            "growth of\n"
            "features), or of --M and --L without a case.",
    .options = options,
    .minimum = 0,
    .maximum = 1,
    .run = cli_run_case,
    .steady = true,
};
