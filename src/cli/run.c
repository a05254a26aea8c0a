/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The commands run, steady and resume: a transient case from its steady start,
 * a steady contact, and an interrupted run. */
#include <math.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/cli.h"
#include "cli/json.h"
#include "cli/signals.h"
#include "cli/watch.h"

#define CLI_SENSITIVITY_OPTIONS                                                \
    {"sensitivity", "[KEY,...]",                                               \
     "elasticities: relative change of film thickness, pressure and friction " \
     "per relative change of each key",                                        \
     false},                                                                   \
    {                                                                          \
        "j", "N", "with --sensitivity: number of runs at the same time", false \
    }

/* -------------------------------------------------------------- sensitivity */

/* Prints the sensitivity of the results of a run to its keys. */

static void report_json(const ovr_sensitivity *found)
{
    json_writer json = json_begin(stdout);
    const ovr_sensitivity_row *r;
    json_open_array(&json, "sensitivity");
    for (size_t k = 0; (r = ovr_sensitivity_at(found, k)); k++) {
        json_open(&json, NULL);
        json_text(&json, "key", r->key);
        json_text(&json, "quantity", r->quantity);
        json_text(&json, "per", r->unit);
        json_number(&json, r->unit ? "slope" : "elasticity",
                    r->why_none ? NAN : r->slope);
        json_number(&json, "doubt", r->doubt);
        json_number(&json, "coarser", r->coarser);
        json_number(&json, "step", r->step);
        json_text(&json, "why_none", r->why_none);
        json_close(&json);
    }
    json_close_array(&json);
    json_end(&json);
}

static void report_table(const ovr_sensitivity *found)
{
    const ovr_sensitivity_row *r;
    size_t key = strlen("key"), name = strlen("quantity");
    for (size_t k = 0; (r = ovr_sensitivity_at(found, k)); k++) {
        key = strlen(r->key) > key ? strlen(r->key) : key;
        name = strlen(r->name) > name ? strlen(r->name) : name;
    }
    puts("change of a quantity in % per 1 % of a key (for keys that may be "
         "zero: per\n"
         "unit of the key)\n");
    printf("%-*s  %-*s  change\n", (int)key, "key", (int)name, "quantity");
    for (size_t k = 0; (r = ovr_sensitivity_at(found, k)); k++) {
        printf("%-*s  %-*s  ", (int)key, r->key, (int)name, r->name);
        if (r->why_none)
            printf("-          %s\n", r->why_none);
        else {
            printf("%+-10.3g +- %.1g", r->slope, r->doubt);
            if (isfinite(r->coarser))
                printf("  (%+.3g one level coarser)", r->coarser);
            if (r->unit)
                printf("  per 1%s%s", *r->unit ? " " : "", r->unit);
            putchar('\n');
        }
    }
}

/* Performs --sensitivity of steady and run. Prints a table of elasticities and
 * returns the exit code. */
static int sensitivity(cli_call *call, ovr_case *c, bool steady)
{
    const char *keys = cli_value(call, "sensitivity");
    ovr_sensitivity_options how = {0};
    ovr_sensitivity *found;
    ovr_error err = {0};
    how.workers = (int)cli_count(call, "j", 64, 1);
    if (!how.workers)
        return CLI_USAGE;
    how.keys = keys && *keys ? keys : NULL;
    how.steady = steady;
    how.estimate = cli_flag(call, "estimate-error");
    how.data = call;
    how.say = cli_say;
    how.stop = cli_stop;
    cli_silence_the_end();
    cli_catch_signals();
    found = ovr_sensitivity_create(c, &how, &err);
    if (!found)
        return cli_signal() ? CLI_SIGNAL + cli_signal() : cli_fail(&err);
    if (call->json)
        report_json(found);
    else if (call->verbosity >= 0)
        report_table(found);
    ovr_sensitivity_free(found);
    return CLI_DONE;
}

/* Runs the case according to options and command, or computes sensitivities;
 * returns the exit code. */
static int run_case(cli_call *call)
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
               ? sensitivity(call, c, how.steady)
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
    .run = run_case,
};

/* ------------------------------------------------------------------- steady */

static const cli_option steady_options[] = {
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
    .options = steady_options,
    .minimum = 0,
    .maximum = 1,
    .run = run_case,
    .steady = true,
};

/* ------------------------------------------------------------------- resume */

static ovr_status change(void *data, ovr_case *c, ovr_error *err)
{
    const cli_watch *watch = data;
    return cli_apply_options(watch->call, c, err);
}

static int resume(cli_call *call)
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

static const cli_option resume_options[] = {
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
    .options = resume_options,
    .minimum = 1,
    .maximum = 1,
    .run = resume,
};
