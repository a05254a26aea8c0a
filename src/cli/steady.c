/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll steady [CASE]: one steady contact. */
#include <string.h>

#include "cli/case_args.h"
#include "cli/progress.h"
#include "cli/report.h"

/* A steady solve has features fully grown: what the run in time ends in. */
static void stop_growing(ovr_case *c)
{
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        char where[128];
        if (!entry.name || !entry.given || strncmp(entry.key, "grow", 4) != 0)
            continue;
        snprintf(where, sizeof where, "feature %s.%s", entry.name, entry.key);
        ovr_case_unset(c, where);
    }
}

static int solve(const cli_call *call, const ovr_case *c, ovr_setup *setup,
                 ovr_simulation *sim)
{
    cli_summary summary = {.setup = setup, .sim = sim};
    ovr_error err = {0};
    double begun = cli_seconds();
    ovr_status status;
    cli_say_assumed(call, &summary);
    cli_warn_before(call, &summary);
    status = ovr_simulation_steady(sim, &err);
    summary.seconds = cli_seconds() - begun;
    summary.converged = status == OVR_OK &&
                        ovr_simulation_observation(sim)->converged;
    if (status && status != OVR_NOT_CONVERGED && status != OVR_IMPOSSIBLE)
        return cli_fail(&err);
    if (!status && cli_flag(call, "estimate-error") &&
        cli_estimate_error(c, sim, true, &summary.error, &err))
        return cli_fail(&err);
    cli_warn_after(call, &summary);
    cli_report(call, &summary);
    if (status)
        return cli_fail(&err);
    return summary.converged ? CLI_DONE : CLI_FAILED;
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup = NULL;
    ovr_simulation *sim = NULL;
    ovr_error err = {0};
    if (!c)
        return code;
    stop_growing(c);
    setup = ovr_case_resolve(c, NULL, &err);
    if (setup)
        sim = ovr_setup_simulation(setup, NULL, &err);
    code = sim ? solve(call, c, setup, sim) : cli_fail(&err);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {
    CLI_ESTIMATE_OPTION, CLI_CASE_OPTIONS, {0}};

const cli_verb cli_steady = {
    .name = "steady",
    .arguments = "[CASE] [--M 20 --L 10 --level 9]",
    .summary = "solve one steady contact",
    .help = "Solves the steady contact of the case (its [time] and the growth "
            "of its\nfeatures do not count), or of --M and --L without a case.",
    .options = options,
    .least = 0,
    .most = 1,
    .run = run,
};
