/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll check CASE: prints derived quantities, solves nothing.
 */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/case_print.h"
#include "cli/report.h"
#include "cli/stations.h"

/* ----------------------------------------------------------------- memory */

/* Allocator that counts the bytes in use; each block is preceded by its size.
 */
enum { HEAD = sizeof(max_align_t) };

static void *take(void *live, size_t bytes)
{
    unsigned char *piece = malloc(HEAD + bytes);
    if (!piece)
        return NULL;
    memcpy(piece, &bytes, sizeof bytes);
    *(double *)live += (double)bytes;
    return piece + HEAD;
}

static void give(void *live, void *memory)
{
    unsigned char *piece = (unsigned char *)memory - HEAD;
    size_t bytes;
    memcpy(&bytes, piece, sizeof bytes);
    *(double *)live -= (double)bytes;
    free(piece);
}

/* ------------------------------------------------------------------ table */

/* Prints a line as a comment of a case; lines of the complete list only with
 * -v. */
static void put_comment(void *data, const ovr_summary_line *line)
{
    const cli_call *call = data;
    if (line->key || (line->detail && call->verbosity <= 0))
        return;
    if (!line->label)
        printf("# %s\n", line->text);
    else
        printf("#   %-*s %s\n", OVR_LABEL_WIDTH, line->label, line->text);
}

static void put_line(void *data, const char *name, const char *text)
{
    if (!*(bool *)data)
        puts("# Models");
    *(bool *)data = true;
    printf("#   %-*s %s\n", OVR_LABEL_WIDTH, name, text);
}

/* ------------------------------------------------------------------- JSON */

static void hear_json(void *data, ovr_message_kind kind, const char *text)
{
    if (kind == OVR_MESSAGE_WARNING)
        json_text(data, NULL, text);
}

static ovr_status report_json(const ovr_case *c, const ovr_setup *setup,
                              double live, ovr_error *err)
{
    json_writer json = json_begin(stdout);
    ovr_status status = ovr_setup_report(setup, live, cli_put_line, &json, err);
    cli_json_stations(&json, setup);
    json_open_array(&json, "warnings");
    ovr_setup_review(setup, hear_json, &json);
    json_close_array(&json);
    cli_json_case(&json, c);
    json_end(&json);
    return status;
}

static ovr_status report(cli_call *call, const ovr_case *c,
                         const ovr_setup *setup, double live, ovr_error *err)
{
    ovr_status status;
    bool begun = false;
    if (call->json)
        return report_json(c, setup, live, err);
    status = ovr_setup_report(setup, live, put_comment, call, err);
    if (status)
        return status;
    cli_put_stations(setup);
    ovr_setup_describe(setup, put_line, &begun);
    if (call->verbosity > 0)
        cli_put_case(c);
    return OVR_OK;
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup;
    ovr_error err = {0};
    double live = 0, depth;
    const ovr_allocator counted = {take, give, &live};
    if (!c)
        return code;
    setup = ovr_case_resolve(c, &counted, &err);
    if (setup && !ovr_setup_prepare(setup, &counted, &err) &&
        !ovr_setup_stress_depth(setup, &depth, &err)) {
        ovr_setup_review(setup, cli_say, call);
        if (report(call, c, setup, live, &err))
            code = cli_fail(&err);
    } else {
        code = cli_fail(&err);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {CLI_CASE_OPTIONS, {0}};

const cli_verb cli_check = {
    .name = "check",
    .arguments = "[CASE]",
    .summary =
        "print operating conditions, predictions and cost; solve nothing",
    .help =
        "Prints a summary of operating conditions, predicted film thickness, "
        "features, grid\nand cost. With -v the list is complete and every "
        "parameter follows with its value;\nthat output is itself a "
        "case.",
    .options = options,
    .minimum = 0,
    .maximum = 1,
    .run = run,
};
