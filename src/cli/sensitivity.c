/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the sensitivity of the results of a run to its keys. */
#include "cli/sensitivity.h"

#include <math.h>

#include "cli/json.h"
#include "cli/signals.h"
#include "cli/watch.h"

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
    puts("change of a quantity in % per 1 % of a key (for keys that may be "
         "zero: per\n"
         "unit of the key)\n");
    for (size_t k = 0; (r = ovr_sensitivity_at(found, k)); k++) {
        printf("%-24s %-18s ", r->key, r->quantity);
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

int cli_sensitivity(cli_call *call, ovr_case *c, bool steady)
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
