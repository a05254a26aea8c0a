/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll find CASE KEY between A and B so that QUANTITY is
 * VALUE. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/find_report.h"
#include "cli/json.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/watch.h"

enum { CAPACITY = 600 };

/* The search from the command line, split into its parts. */
typedef struct question {
    char words[CAPACITY]; /* all words, separated by blanks */
    const char *which;
    char key[CAPACITY], low[CAPACITY], high[CAPACITY], condition[CAPACITY];
} question;

/* Copies the words between two keywords without leading and trailing blanks. */
static bool copy_trimmed(const char *from, const char *to, char *text)
{
    while (from < to && *from == ' ')
        from++;
    while (to > from && to[-1] == ' ')
        to--;
    memcpy(text, from, (size_t)(to - from));
    text[to - from] = '\0';
    return to > from;
}

static bool join_words(const cli_call *call, char *words)
{
    size_t used = 0;
    words[0] = '\0';
    for (int k = 1; k < call->arguments && used < CAPACITY; k++)
        used += (size_t)snprintf(words + used, CAPACITY - used, "%s%s",
                                 k > 1 ? " " : "", call->argument[k]);
    return used < CAPACITY;
}

static bool parse(question *q)
{
    const char *at = q->words, *between, *and, *so;
    static const char *const whiches[] = {"largest ", "smallest "};
    for (int k = 0; k < 2; k++)
        if (!strncmp(at, whiches[k], strlen(whiches[k]))) {
            q->which = k ? "smallest" : "largest";
            at += strlen(whiches[k]);
        }
    between = strstr(at, " between ");
    and = between ? strstr(between, " and ") : NULL;
    so = and? strstr(and, " so that ") : NULL;
    return so && copy_trimmed(at, between, q->key) &&
           copy_trimmed(between + 9, and, q->low) &&
           copy_trimmed(and+5, so, q->high) &&
           copy_trimmed(so + 9, so + strlen(so), q->condition);
}

/* ----------------------------------------------------------------- options */

static int parse_numbers(const cli_call *call, ovr_find_options *how)
{
    const char *tolerance = cli_value(call, "tolerance");
    char *end;
    how->workers = (int)cli_count(call, "j", 64, 1);
    if (!how->workers)
        return CLI_USAGE;
    if (tolerance) {
        how->tolerance = strtod(tolerance, &end);
        if (*end || end == tolerance || !(how->tolerance > 0))
            return cli_usage(call, "--tolerance %s: must be a number",
                             tolerance);
    }
    return CLI_DONE;
}

/* ------------------------------------------------------------------- report */

/* Returns the number of digits that the discretization error justifies. */
static int digits_of(const ovr_find_info *i)
{
    double share = fabs(i->value / i->error);
    if (i->exact || !isfinite(share) || !(share > 0))
        return i->exact ? 10 : 4;
    int digits = 1 + (int)ceil(log10(share));
    return digits < 2 ? 2 : digits > 9 ? 9 : digits;
}

/* The heading of a column: "minimum film thickness (b^2/R)". */
static void write_heading(const char *name, const char *unit, char *to,
                          size_t size)
{
    snprintf(to, size, "%s%s%s%s", name, *unit ? " (" : "", unit,
             *unit ? ")" : "");
}

static void print_table(const ovr_find *find, const ovr_find_info *i)
{
    char at[CAPACITY], of[CAPACITY];
    write_heading(i->key, i->unit, at, sizeof at);
    write_heading(i->name, i->quantity_unit, of, sizeof of);
    int key = (int)strlen(at), quantity = (int)strlen(of);
    key = key > 14 ? key : 14;
    quantity = quantity > 14 ? quantity : 14;
    printf("\n%-*s %-*s order level  seconds\n", key, at, quantity, of);
    for (size_t k = 0; k < i->evaluations; k++) {
        ovr_find_evaluation e = ovr_find_evaluation_at(find, k);
        printf("%-*.8g ", key, e.value);
        if (isnan(e.quantity))
            printf("%-*s ", quantity, "-");
        else
            printf("%-*.8g ", quantity, e.quantity);
        if (i->exact)
            putchar('\n');
        else if (!e.order)
            printf("%5s %5s %8s  %s\n", "-", "-", "-", e.message);
        else
            printf("%5d %5d %8.3g%s%s\n", e.order, e.level, e.seconds,
                   e.marked     ? "  above tolerance"
                   : *e.message ? "  "
                                : "",
                   e.message);
    }
}

/* Prints a row: quantity, value, unit and remark. */
static void print_row(const char *label, int digits, double value,
                      const char *unit, const char *remark)
{
    int wide = *remark ? 10 : 0;
    printf("%-*s %-12.*g%s%-*s%s\n", OVR_LABEL_WIDTH, label, digits, value,
           *unit || *remark ? " " : "", wide, unit, remark);
}

static void print_answer(const ovr_find_info *i)
{
    char remark[CAPACITY];
    printf("%s = %.*g%s%s\n\n", i->key, digits_of(i), i->value,
           *i->unit ? " " : "", i->unit);
    printf("%-*s %-12s in units\n", OVR_LABEL_WIDTH, "quantity", "value");
    snprintf(remark, sizeof remark, " (%s; condition: %s %.6g)", i->quantity,
             !i->sense      ? "is"
             : i->sense > 0 ? "at least"
                            : "at most",
             i->target);
    print_row(i->name, 6, i->at_value, i->quantity_unit, remark);
    snprintf(remark, sizeof remark, " (of %s)", i->key);
    if (isfinite(i->error))
        print_row("discretization error", 2, i->error, i->unit, remark);
    if (isfinite(i->scatter) && i->end == OVR_FIND_SCATTERED)
        print_row("scatter", 2, fabs(i->scatter * i->target / i->slope),
                  i->unit, remark);
    snprintf(remark, sizeof remark, " (change of the quantity per 1 %% of %s)",
             i->key);
    if (isfinite(i->slope))
        print_row("sensitivity", 3, i->slope * i->value / i->at_value, "%",
                  remark);
}

static void report_table(const cli_call *call, const ovr_find *find)
{
    const ovr_find_info *i = ovr_find_get_info(find);
    if (i->end == OVR_FIND_FOUND || i->end == OVR_FIND_SCATTERED)
        print_answer(i);
    if (i->evaluations &&
        (call->verbosity > 0 || (i->end != OVR_FIND_FOUND && !i->exact)))
        print_table(find, i);
}

static void json_find(json_writer *json, const ovr_find *find)
{
    const ovr_find_info *i = ovr_find_get_info(find);
    ovr_find_summary(find, false, cli_put_line, json);
    json_open_array(json, "evaluations");
    for (size_t k = 0; k < i->evaluations; k++) {
        ovr_find_evaluation e = ovr_find_evaluation_at(find, k);
        json_open(json, NULL);
        json_number(json, "value", e.value);
        json_number(json, "quantity", e.quantity);
        json_integer(json, "order", e.order);
        json_integer(json, "level", e.level);
        json_flag(json, "converged", e.converged);
        json_integer(json, "marked", e.marked);
        json_number(json, "seconds", e.seconds);
        json_text(json, "message", e.message);
        json_close(json);
    }
    json_close_array(json);
}

int cli_report_find(const cli_call *call, const ovr_find *find,
                    ovr_status status, const ovr_error *err)
{
    const ovr_find_info *i = ovr_find_get_info(find);
    int code = CLI_DONE;
    if (call->json) {
        json_writer json = json_begin(stdout);
        json_find(&json, find);
        json_end(&json);
    } else if (call->verbosity >= 0) {
        report_table(call, find);
    }
    if (status == OVR_STOPPED && cli_signal())
        return CLI_SIGNAL + cli_signal();
    if (status)
        code = cli_fail(err);
    else if (i->end == OVR_FIND_SCATTERED || i->marked)
        code = CLI_EARLY;
    return code;
}

/* --------------------------------------------------------------------- run */

static int create_find(cli_call *call, const question *q)
{
    int code;
    ovr_error err = {0};
    ovr_find_options how = {0};
    ovr_case *c;
    ovr_find *find;
    how.key = q->key;
    how.low = q->low;
    how.high = q->high;
    how.condition = q->condition;
    how.which = q->which;
    how.steady = cli_flag(call, "steady");
    how.table = cli_value(call, "table");
    how.results = cli_value(call, "results");
    how.force = cli_flag(call, "force");
    how.data = call;
    how.say = cli_say;
    how.stop = cli_stop;
    code = parse_numbers(call, &how);
    c = code ? NULL : cli_open_case(call, &code);
    if (!c)
        return code;
    find = ovr_find_create(c, &how, &err);
    if (find) {
        cli_silence_the_end();
        cli_catch_signals();
        ovr_status status = ovr_find_execute(find, &err);
        code = cli_report_find(call, find, status, &err);
    } else {
        code = cli_fail(&err);
    }
    ovr_find_free(find);
    ovr_case_free(c);
    return code;
}

static int run(cli_call *call)
{
    question q = {.which = NULL};
    if (join_words(call, q.words) && parse(&q))
        return create_find(call, &q);
    return cli_usage(call,
                     "'%.80s' must be [largest | smallest] KEY between A and B "
                     "so that QUANTITY is VALUE (at most, at least)",
                     q.words);
}

static const cli_option options[] = {
    {"j", "N", "maximum number of runs at the same time", false},
    {"tolerance", "NUMBER", "relative tolerance of the key; default: 1e-3",
     false},
    {"steady", NULL, "solve only the steady contact, as 'overroll steady'",
     false},
    {"table", "FILE.csv", "table of evaluations, written row by row", false},
    {"results", "FOLDER",
     "folder for the result files of all runs; existing results are not "
     "computed again",
     false},
    {"force", NULL, "replace a table of another program", false},
    CLI_CASE_OPTIONS,
    {0}};

const cli_verb cli_find = {
    .name = "find",
    .arguments =
        "CASE [largest | smallest] KEY between A and B so that QUANTITY "
        "is | at most | at least VALUE",
    .summary = "find the value of a key at which a result has a given value",
    .help =
        "Runs the case at values of KEY from A to B and finds the value by "
        "Brent's method.\nQUANTITY is any number of the summary by its name "
        "in --json; if VALUE has a unit,\nthe quantity in SI is used.  Scales "
        "and formulas of 'check' need no runs.\nThe answer to at most or at "
        "least has been run and satisfies the condition.\n\n"
        "  overroll find dent.ini feature.dent.depth between 0.1 um and 2 um "
        "\\\n"
        "      so that H_min_overall is 0.05\n"
        "  overroll find dent.ini largest contact.load between 50 and 500 kN/m "
        "\\\n      so that P_max_overall at most 2 GPa",
    .options = options,
    .minimum = 2,
    .maximum = 40,
    .run = run,
};
