/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll stress OUT.h5: stresses from the stored pressure. */
#include "cli/case_args.h"
#include "cli/report.h"

static ovr_status change(void *call, ovr_case *c, ovr_error *err)
{
    return cli_apply_options(call, c, err);
}

static void report(const cli_call *call, const ovr_stored_stress *s)
{
    const ovr_setup *setup = ovr_stored_stress_setup(s);
    const ovr_stress_report *both[] = {ovr_stored_stress_report(s, 1),
                                       ovr_stored_stress_report(s, 2)};
    json_writer json;
    if (call->json) {
        json = json_begin(stdout);
        ovr_stress_summary(both, setup, cli_put_line, &json);
        cli_json_lengths(&json, both);
        json_end(&json);
    } else if (call->verbosity >= 0)
        ovr_stress_summary(both, setup, cli_put_line, NULL);
}

static int run(cli_call *call)
{
    ovr_error err = {0};
    ovr_stored_stress *s = ovr_stored_stress_create(call->argument[0], change,
                                                    call, &err);
    if (!s)
        return cli_fail(&err);
    report(call, s);
    ovr_stored_stress_free(s);
    return CLI_DONE;
}

static const cli_option options[] = {CLI_CASE_OPTIONS, {0}};

const cli_verb cli_stress = {
    .name = "stress",
    .arguments = "OUT.h5",
    .summary = "stresses and fatigue from a stored run",
    .help = "Computed from the stored pressure and, with traction, shear "
            "stress.  [stress] and\n[fatigue] are those of the run or as "
            "changed by --set (--set\nfatigue.criterion=orthogonal).  Depths "
            "that the stored times do not resolve are\nrejected; the message "
            "states the necessary `every`.",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = run,
};
