/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll sweep STUDY.ini: all cases of a study, alone or together
 * with other hosts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cli/cli.h"
#include "cli/find_report.h"
#include "cli/json.h"
#include "cli/report.h"
#include "cli/signals.h"
#include "cli/watch.h"

/* --------------------------------------------------------------- statistics */

/* Prints the statistics of a study as text and JSON. */

/* Number of samples up to which percentages have one digit. */
enum { FEW = 200 };

/* -------------------------------------------------------------------- JSON */

static void json_quantiles(json_writer *json, const ovr_sample_row *r)
{
    json_open_array(json, "quantiles");
    for (int k = 0; k < OVR_SAMPLE_QUANTILES; k++) {
        json_open(json, NULL);
        json_number(json, "p", r->p[k]);
        json_number(json, "value", r->quantile[k]);
        json_number(json, "low", r->low[k]);
        json_number(json, "high", r->high[k]);
        json_close(json);
    }
    json_close_array(json);
}

static void json_limits(json_writer *json, const ovr_sample_row *r)
{
    json_open_array(json, "limits");
    for (size_t k = 0; k < r->limits; k++) {
        json_open(json, NULL);
        json_text(json, "relation", r->sense[k] > 0 ? "at least" : "at most");
        json_number(json, "limit", r->limit[k]);
        json_number(json, "P", r->P[k]);
        json_number(json, "P_low", r->P_low[k]);
        json_number(json, "P_high", r->P_high[k]);
        json_close(json);
    }
    json_close_array(json);
}

static void json_inputs(json_writer *json, const ovr_sample *sample, size_t row)
{
    const ovr_sample_input *in;
    json_open_array(json, "inputs");
    for (size_t k = 0; (in = ovr_sample_input_at(sample, row, k)); k++) {
        json_open(json, NULL);
        json_text(json, "key", in->key);
        json_number(json, "share", in->share);
        json_number(json, "share_low", in->share_low);
        json_number(json, "share_high", in->share_high);
        json_number(json, "rho", in->rho);
        json_number(json, "rho_low", in->rho_low);
        json_number(json, "rho_high", in->rho_high);
        json_number(json, "lowest", in->lowest);
        json_number(json, "highest", in->highest);
        json_close(json);
    }
    json_close_array(json);
}

/* Writes the statistics as an array of objects. */
static void json_sample(json_writer *json, const ovr_sample *sample)
{
    const ovr_sample_row *r;
    json_open_array(json, "statistics");
    for (size_t k = 0; (r = ovr_sample_at(sample, k)); k++) {
        json_open(json, NULL);
        json_text(json, "group", r->group);
        json_text(json, "quantity", r->quantity);
        json_integer(json, "draws", (long long)r->draws);
        json_integer(json, "finished", (long long)r->finished);
        json_integer(json, "failed", (long long)r->failed);
        json_integer(json, "marked", (long long)r->marked);
        json_integer(json, "known", (long long)r->known);
        json_integer(json, "order_least", r->order[0]);
        json_integer(json, "order_most", r->order[1]);
        json_number(json, "mean", r->mean);
        json_number(json, "mean_error", r->error);
        json_number(json, "sd", r->sd);
        json_quantiles(json, r);
        json_limits(json, r);
        json_inputs(json, sample, k);
        json_close(json);
    }
    json_close_array(json);
}

/* ------------------------------------------------------------------- tables */

static void print_range(const char *name, const int range[2])
{
    if (range[0] == range[1] && range[0])
        printf(", %s %d", name, range[0]);
    else if (range[1])
        printf(", %ss %d to %d", name, range[0], range[1]);
}

/* Prints the number of samples and how they ended. */
static void print_counts(const ovr_sample_row *r)
{
    printf("%zu samples%s%s: %zu finished, %zu failed, %zu with steps accepted "
           "above tolerance",
           r->draws, *r->label ? " with " : "", r->label, r->finished,
           r->failed, r->marked);
    print_range("order", r->order);
    print_range("level", r->level);
    putchar('\n');
    if ((double)r->failed > 0.01 * (double)r->draws)
        printf("%.2g %% of the samples failed and are excluded; the statistics "
               "may be biased\n",
               100 * (double)r->failed / (double)r->draws);
    if (r->order[0] != r->order[1])
        puts("the samples contain solutions of different order; set "
             "domain.order = 2 in [set]");
}

/* Prints "LOW to HIGH", or the finite limit. */
static void print_interval(double low, double high, double factor)
{
    if (isnan(low) && isfinite(high))
        printf(" below %.4g\n", high * factor);
    else if (isnan(high) && isfinite(low))
        printf(" above %.4g\n", low * factor);
    else if (isfinite(low))
        printf(" %.4g to %.4g\n", low * factor, high * factor);
    else
        putchar('\n');
}

static void print_value(const char *label, double value)
{
    printf("%-*s %-12.5g", OVR_LABEL_WIDTH, label, value);
}

static void print_moments(const ovr_sample_row *r, cli_unit as)
{
    double half = r->factor * r->error;
    char label[64];
    printf("\n%s%s%s (%s)\n", r->name, *as.name ? ", " : "", as.name,
           r->quantity);
    printf("%-*s %-12s 95 %% confidence interval\n", OVR_LABEL_WIDTH,
           "statistic", "value");
    print_value("mean", r->mean * as.factor);
    print_interval(r->mean - half, r->mean + half, as.factor);
    printf("%-*s %.5g\n", OVR_LABEL_WIDTH, "standard deviation",
           r->sd * as.factor);
    for (int k = 0; k < OVR_SAMPLE_QUANTILES; k++) {
        snprintf(label, sizeof label, "%.0f %% quantile", 100 * r->p[k]);
        print_value(label, r->quantile[k] * as.factor);
        print_interval(r->low[k], r->high[k], as.factor);
    }
}

static void print_limits(const ovr_sample_row *r, cli_unit as)
{
    char label[64];
    for (size_t k = 0; k < r->limits; k++) {
        snprintf(label, sizeof label, "probability of at %s %.6g%s%s",
                 r->sense[k] > 0 ? "least" : "most", r->limit[k] * as.factor,
                 *as.name ? " " : "", as.name);
        print_value(label, r->P[k]);
        print_interval(r->P_low[k] <= 0 ? NAN : r->P_low[k], r->P_high[k], 1);
    }
}

static void print_inputs(const ovr_sample *sample, size_t row, size_t known)
{
    const ovr_sample_input *in;
    int d = known < FEW ? 1 : 2;
    if (ovr_sample_input_at(sample, row, 0))
        printf("%-*s %-23s rank correlation rho\n", OVR_LABEL_WIDTH,
               "effect of the input", "share of the variance");
    for (size_t k = 0; (in = ovr_sample_input_at(sample, row, k)); k++) {
        char share[64] = "";
        if (!in->related)
            snprintf(share, sizeof share, "%.*f (%.*f to %.*f)", d, in->share,
                     d, in->share_low, d, in->share_high);
        printf("%-*s %-23s %+.*f (%+.*f to %+.*f)\n", OVR_LABEL_WIDTH, in->key,
               share, d, in->rho, d, in->rho_low, d, in->rho_high);
    }
}

/* Prints the statistics of a study as tables on standard output. */
static void print_sample(const ovr_sample *sample)
{
    const ovr_sample_row *r;
    const char *group = NULL;
    for (size_t k = 0; (r = ovr_sample_at(sample, k)); k++) {
        if (!group || strcmp(group, r->group) != 0)
            print_counts(r);
        group = r->group;
        if (!r->known)
            continue;
        cli_unit as = cli_choose_unit(r->unit,
                                      r->quantile[OVR_SAMPLE_QUANTILES / 2]);
        print_moments(r, as);
        print_limits(r, as);
        print_inputs(sample, k, r->known);
    }
}

typedef struct sweeping {
    const cli_call *call;
    ovr_study *s;
    ovr_sweep_options how;
    cli_progress progress;
    cli_call logged; /* writes messages to the log of the case */
    cli_watch watch;
    ovr_run_options run;
    double begun;
} sweeping;

/* -------------------------------------------------------------- callbacks */

/* Reports within the case's process: its summary, and on its log the final
 * status. */
static void report_case(void *data, const ovr_run *run, const ovr_error *err,
                        FILE *summary)
{
    const sweeping *w = data;
    if (summary && run && cli_has_result(run, err->status))
        cli_report_json(ovr_run_get_info(run), summary);
    if (run)
        cli_run_code(&w->logged, run, err->status, err);
    else
        cli_fail(err);
}

/* Reports the answer of a search in the same way. */
static void report_found(void *data, const ovr_find *find, const ovr_error *err)
{
    const sweeping *w = data;
    if (find)
        cli_report_find(&w->logged, find, err->status, err);
    else
        cli_fail(err);
}

static void progress(void *data, size_t ended, size_t cases, int running,
                     size_t failed, double fraction)
{
    sweeping *w = data;
    char what[120];
    snprintf(what, sizeof what, "%zu of %zu cases, %d running, %zu failed",
             ended, cases, running, failed);
    cli_progress_show(&w->progress, fraction, what);
}

/* --------------------------------------------------------------- the list */

/* Prints a path quoted for the shell. */
static void print_shell_quoted(const char *text)
{
    if (!text[strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVW"
                           "XYZ0123456789_-./+=,")]) {
        fputs(text, stdout);
        return;
    }
    putchar('\'');
    for (; *text; text++)
        if (*text == '\'')
            fputs("'\\''", stdout);
        else
            putchar(*text);
    putchar('\'');
}

static void print_list(const sweeping *w)
{
    for (size_t i = 0; i < ovr_study_cases(w->s); i++) {
        if (!ovr_sweep_is_due(&w->how, ovr_sweep_state_of(w->s, i)))
            continue;
        fputs("overroll sweep ", stdout);
        print_shell_quoted(w->call->argument[0]);
        if (cli_value(w->call, "o")) {
            fputs(" -o ", stdout);
            print_shell_quoted(ovr_study_output(w->s));
        }
        printf(" --task %zu%s%s%s\n", i + 1, w->how.retry ? " --retry" : "",
               w->how.redo ? " --redo" : "", w->how.force ? " --force" : "");
    }
}

/* ---------------------------------------------------------------- reports */

static void report_json(const sweeping *w, const ovr_sweep_totals *t)
{
    json_writer json = json_begin(stdout);
    char text[1100];
    json_text(&json, "study", w->call->argument[0]);
    json_integer(&json, "cases", (long long)ovr_study_cases(w->s));
    for (int state = 0; state < OVR_SWEEP_STATES; state++)
        json_integer(&json, ovr_sweep_state_name((ovr_sweep_state)state),
                     (long long)t->count[state]);
    snprintf(text, sizeof text, "%.1000s/manifest.csv", ovr_study_output(w->s));
    json_text(&json, "manifest", text);
    json_number(&json, "seconds", cli_seconds() - w->begun);
    json_end(&json);
}

/* Prints the first case of each kind of message, at most five. */
static void list_state(const sweeping *w, ovr_sweep_state state)
{
    enum { KINDS = 5 };
    char text[1100], kind[KINDS][1100], name[160];
    size_t kinds = 0, more = 0;
    for (size_t i = 0; i < ovr_study_cases(w->s); i++) {
        size_t k = 0;
        if (ovr_sweep_state_of(w->s, i) != state)
            continue;
        ovr_sweep_message(w->s, i, text, sizeof text);
        while (k < kinds && strcmp(kind[k], text) != 0)
            k++;
        if (k < kinds || kinds == KINDS) {
            more++;
            continue;
        }
        strcpy(kind[kinds++], text);
        ovr_study_name(w->s, i, name, sizeof name);
        printf("  %zu %s %s: %s\n", i + 1, ovr_sweep_state_name(state), name,
               state == OVR_SWEEP_FAILED ? text : "belongs to another case");
    }
    if (more)
        printf("  and %zu more, see manifest.csv\n", more);
}

static void report_table(const sweeping *w, const ovr_sweep_totals *t)
{
    printf("%zu cases:", ovr_study_cases(w->s));
    for (int state = 0; state < OVR_SWEEP_STATES; state++)
        if (t->count[state])
            printf(" %zu %s", t->count[state],
                   ovr_sweep_state_name((ovr_sweep_state)state));
    printf("; %s/manifest.csv\n", ovr_study_output(w->s));
    if (t->count[OVR_SWEEP_FAILED])
        list_state(w, OVR_SWEEP_FAILED);
    if (t->count[OVR_SWEEP_CHANGED])
        list_state(w, OVR_SWEEP_CHANGED);
    if (t->count[OVR_SWEEP_FAILED])
        puts("--retry repeats failed cases");
    if (t->count[OVR_SWEEP_CHANGED])
        puts("--redo repeats all cases from the start");
}

/* Prints the statistics of the samples and writes summary.csv. */
static int report_sample(const sweeping *w, json_writer *json)
{
    char path[4400];
    ovr_error err = {0};
    int code = CLI_DONE;
    ovr_sample *sample = ovr_study_sample(w->s, cli_value(w->call, "quantity"),
                                          &err);
    snprintf(path, sizeof path, "%.4300s/summary.csv", ovr_study_output(w->s));
    if (!sample || ovr_sample_write(sample, path, w->how.force, &err))
        code = cli_fail(&err);
    else if (json)
        json_sample(json, sample);
    else if (w->call->verbosity >= 0)
        print_sample(sample);
    ovr_sample_free(sample);
    return code;
}

/* Performs --statistics without running cases. */
static int show_sample(const sweeping *w)
{
    json_writer json;
    int code;
    if (!w->call->json)
        return report_sample(w, NULL);
    json = json_begin(stdout);
    code = report_sample(w, &json);
    json_end(&json);
    return code;
}

/* Writes manifest and table, prints the report and returns the exit code. */
static int finish(sweeping *w)
{
    ovr_sweep_totals totals = {0};
    ovr_error err = {0};
    if (ovr_sweep_collect(w->s, cli_value(w->call, "collect"), w->how.force,
                          &totals, &err))
        return cli_fail(&err);
    if (w->call->json)
        report_json(w, &totals);
    else if (w->call->verbosity >= 0)
        report_table(w, &totals);
    if (cli_value(w->call, "collect") && w->call->verbosity >= 0)
        fprintf(stderr, "%s: written, %zu of %zu cases finished\n",
                cli_value(w->call, "collect"), totals.count[OVR_SWEEP_FINISHED],
                ovr_study_cases(w->s));
    if (ovr_study_random(w->s) && totals.count[OVR_SWEEP_FINISHED] &&
        !w->call->json && report_sample(w, NULL))
        return CLI_FAILED;
    if (totals.count[OVR_SWEEP_FAILED])
        return CLI_FAILED;
    return totals.count[OVR_SWEEP_FINISHED] < ovr_study_cases(w->s) ||
                   totals.marked
               ? CLI_EARLY
               : CLI_DONE;
}

/* -------------------------------------------------------------------- run */

/* Runs the sweep; true if it ran, *code is then its exit code. */
static bool start(sweeping *w, int *code)
{
    ovr_error err = {0};
    ovr_status status;
    cli_silence_the_end();
    cli_catch_signals();
    w->progress = cli_progress_begin(w->call->verbosity, 0);
    status = ovr_sweep(w->s, &w->how, &err);
    cli_progress_end(&w->progress);
    *code = status ? CLI_SIGNAL + cli_signal() : CLI_DONE;
    if (status && status != OVR_STOPPED)
        *code = cli_fail(&err);
    return !status || status == OVR_STOPPED;
}

static int run_all(sweeping *w)
{
    int code, left;
    if (!start(w, &code))
        return code;
    left = finish(w);
    return code ? code : left;
}

/* Prints the final status of a task; returns the exit code. */
static int report_task(const sweeping *w, size_t task)
{
    ovr_sweep_state state = ovr_sweep_state_of(w->s, task);
    char text[1100], name[160];
    ovr_sweep_message(w->s, task, text, sizeof text);
    ovr_study_name(w->s, task, name, sizeof name);
    if (w->call->verbosity >= 0)
        printf("%zu %s %s%s%s\n", task + 1, ovr_sweep_state_name(state), name,
               *text ? ": " : "", text);
    if (state == OVR_SWEEP_FAILED)
        return CLI_FAILED;
    return state == OVR_SWEEP_FINISHED ? CLI_DONE : CLI_EARLY;
}

/* Runs a block of tasks, for job arrays. Other tasks may be running, so no
 * manifest is written. */
static int run_block(sweeping *w, size_t first, size_t last)
{
    int code, worst = CLI_DONE;
    w->how.one = true;
    w->how.only = first;
    w->how.more = last - first;
    if (!start(w, &code))
        return code;
    for (size_t task = first; task <= last; task++) {
        int ended = report_task(w, task);
        if (ended == CLI_FAILED || worst == CLI_DONE)
            worst = ended;
    }
    return code ? code : worst;
}

/* Parses --tasks I-J, numbered from 1, to numbers from 0. */
static bool read_block(const cli_call *call, size_t cases, size_t *first,
                       size_t *last)
{
    const char *text = cli_value(call, "tasks");
    char *end;
    long from = strtol(text, &end, 10), to = 0;
    bool good = end != text && *end == '-' && end[1] >= '0' && end[1] <= '9';
    if (good)
        to = strtol(end + 1, &end, 10);
    good = good && !*end && from >= 1 && to >= from && (size_t)to <= cases;
    if (!good) {
        cli_usage(call,
                  "--tasks %s: must be I-J with whole numbers from 1 to %zu",
                  text, cases);
        return false;
    }
    *first = (size_t)from - 1;
    *last = (size_t)to - 1;
    return true;
}

/* Prints the case of a task. */
static int show_case(const sweeping *w, size_t task)
{
    ovr_error err = {0};
    ovr_case *c = ovr_study_case(w->s, task, &err);
    const char *text = c ? ovr_case_text(c, &err) : NULL;
    int code = text ? CLI_DONE : cli_fail(&err);
    if (text)
        fputs(text, stdout);
    ovr_case_free(c);
    return code;
}

/* ---------------------------------------------------------------- options */

static int do_what_is_asked(sweeping *w)
{
    const cli_call *call = w->call;
    size_t cases = ovr_study_cases(w->s), task, shown, first, last;
    w->how.workers = (int)cli_count(call, "j", OVR_SWEEP_MAX_WORKERS, 0);
    task = cli_count(call, "task", cases, cases);
    shown = cli_count(call, "case", cases, cases);
    if ((cli_flag(call, "j") && !w->how.workers) || !task || !shown)
        return CLI_USAGE;
    if (cli_flag(call, "case"))
        return show_case(w, shown - 1);
    if (cli_flag(call, "list"))
        print_list(w);
    else if (cli_flag(call, "task"))
        return run_block(w, task - 1, task - 1);
    else if (cli_flag(call, "tasks"))
        return read_block(call, cases, &first, &last)
                   ? run_block(w, first, last)
                   : CLI_USAGE;
    else if (cli_flag(call, "statistics"))
        return show_sample(w);
    else
        return cli_flag(call, "collect") ? finish(w) : run_all(w);
    return CLI_DONE;
}

static int run(cli_call *call)
{
    sweeping w = {.call = call,
                  .how = (ovr_sweep_options){0},
                  .logged = *call,
                  .begun = cli_seconds()};
    ovr_error err = {0};
    const char *folder = cli_value(call, "o");
    int code;
    w.logged.verbosity = 0;
    w.watch.call = &w.logged;
    w.run = cli_run_options(&w.watch);
    w.how.run = &w.run;
    w.how.retry = cli_flag(call, "retry");
    w.how.redo = cli_flag(call, "redo");
    w.how.force = cli_flag(call, "force");
    w.how.data = &w;
    w.how.report = report_case;
    w.how.report_find = report_found;
    w.how.progress = progress;
    w.how.stop = cli_stop;
    w.s = ovr_study_read(call->argument[0], NULL, &err);
    if (!w.s || (folder && ovr_study_output_set(w.s, folder, &err)))
        code = cli_fail(&err);
    else
        code = do_what_is_asked(&w);
    ovr_study_free(w.s);
    return code;
}

static const cli_option options[] = {
    {"j", "N", "number of cases at the same time; default: all processors",
     false},
    {"o", "FOLDER", "folder of the results (instead of study.output)", false},
    {"list", NULL, "print the commands of the cases still to be run", false},
    {"task", "I", "run only case I, from 1 (for job arrays)", false},
    {"tasks", "I-J", "run only cases I to J (a block for each job)", false},
    {"case", "I", "print case I as text; runs nothing", false},
    {"collect", "FILE", "write the summaries to FILE.csv or FILE.nc", false},
    {"statistics", NULL,
     "print statistics of the samples of [random]; runs nothing", false},
    {"quantity", "NAME,...",
     "quantities of the statistics (names of the "
     "summary)",
     false},
    {"retry", NULL, "run failed cases again", false},
    {"redo", NULL, "repeat all cases from the start", false},
    {"force", NULL, "replace files of other programs", false},
    {0}};

const cli_verb cli_sweep = {
    .name = "sweep",
    .arguments = "STUDY.ini",
    .summary = "run a parameter study: lists, ranges and products of any "
               "parameters",
    .help =
        "Runs every case of the study that has not finished, resumes stopped "
        "ones, and\n"
        "writes manifest.csv in the folder of the results, one row per case. "
        " --collect\n"
        "runs nothing.  The study is described in overroll-study(5).",
    .options = options,
    .minimum = 1,
    .maximum = 1,
    .run = run,
};
