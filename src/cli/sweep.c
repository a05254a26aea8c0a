/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overroll sweep STUDY.ini: all cases of a study, here or on other hosts. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/json.h"
#include "cli/progress.h"
#include "cli/sweep_pool.h"
#include "cli/sweep_table.h"

typedef struct sweeping {
    const cli_call *call;
    study s;
    sweep_how how;
    size_t *task; /* those to work on */
    size_t tasks;
    size_t failed;
    cli_progress progress;
    double begun;
} sweeping;

/* ---------------------------------------------------------------- workers */

static int work(void *data, size_t task, volatile double *done)
{
    sweeping *w = data;
    return sweep_work(&w->s, task, &w->how, done);
}

static void ended(void *data, size_t task, int code, int number)
{
    sweeping *w = data;
    if (number)
        sweep_died(&w->s, task, number);
    w->failed += number || code == CLI_FAILED || code == CLI_USAGE;
}

static void tick(void *data, size_t count, int running, double done)
{
    sweeping *w = data;
    char what[120];
    snprintf(what, sizeof what, "%zu of %zu cases, %d running, %zu failed",
             count, w->tasks, running, w->failed);
    cli_progress_show(&w->progress, done / (double)w->tasks, what);
}

/* --------------------------------------------------------------- the list */

static ovr_status make_list(sweeping *w, ovr_error *err)
{
    w->task = ovr_arena_take(&w->s.arena, w->s.tasks, sizeof *w->task, err);
    if (!w->task)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < w->s.tasks; i++)
        if (sweep_wanted(&w->how, sweep_state_of(&w->s, i)))
            w->task[w->tasks++] = i;
    return OVR_OK;
}

/* A path for the shell: in quotes, quotes inside broken out of. */
static void put_quoted(const char *text)
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
    for (size_t i = 0; i < w->tasks; i++) {
        fputs("overroll sweep ", stdout);
        put_quoted(w->s.path);
        if (cli_value(w->call, "o")) {
            fputs(" -o ", stdout);
            put_quoted(w->s.output);
        }
        printf(" --task %zu%s%s\n", w->task[i] + 1,
               w->how.retry ? " --retry" : "", w->how.redo ? " --redo" : "");
    }
}

/* ---------------------------------------------------------------- reports */

static void report_json(const sweeping *w, const sweep_table *t)
{
    json_writer json = json_begin(stdout);
    char text[1100];
    json_text(&json, "study", w->s.path);
    json_integer(&json, "cases", (long long)w->s.tasks);
    for (int state = 0; state < SWEEP_STATES; state++)
        json_integer(&json, sweep_state_name((sweep_state)state),
                     (long long)t->count[state]);
    snprintf(text, sizeof text, "%.1000s/manifest.csv", w->s.output);
    json_text(&json, "manifest", text);
    json_number(&json, "seconds", cli_seconds() - w->begun);
    json_end(&json);
}

static void list_state(const sweeping *w, const sweep_table *t,
                       sweep_state state)
{
    char text[1100];
    for (size_t i = 0; i < w->s.tasks; i++) {
        if (t->state[i] != state)
            continue;
        sweep_message(&w->s, i, text, sizeof text);
        printf("  %zu %s %s: %s\n", i + 1, sweep_state_name(state),
               w->s.name[i],
               state == SWEEP_FAILED ? text : "was made from another case");
    }
}

static void report_table(const sweeping *w, const sweep_table *t)
{
    printf("%zu cases:", w->s.tasks);
    for (int state = 0; state < SWEEP_STATES; state++)
        if (t->count[state])
            printf(" %zu %s", t->count[state],
                   sweep_state_name((sweep_state)state));
    printf("; %s/manifest.csv\n", w->s.output);
    list_state(w, t, SWEEP_FAILED);
    list_state(w, t, SWEEP_CHANGED);
    if (t->count[SWEEP_FAILED])
        puts("--retry runs failed ones again");
    if (t->count[SWEEP_CHANGED])
        puts("--redo runs all again from their beginning");
}

static int code_of(const sweep_table *t)
{
    if (t->count[SWEEP_FAILED])
        return CLI_FAILED;
    if (t->count[SWEEP_FINISHED] < t->s->tasks)
        return CLI_EARLY;
    for (size_t k = 0; k < t->columns; k++)
        for (size_t i = 0; i < t->s->tasks; i++)
            if (!strcmp(t->column[k].name, "steps_marked") &&
                t->column[k].value[i] > 0)
                return CLI_EARLY;
    return CLI_DONE;
}

static ovr_status collect(const sweep_table *t, const char *path,
                          ovr_error *err)
{
    const char *end = strrchr(path, '.');
    if (end && !strcmp(end, ".csv"))
        return sweep_write_csv(t, path, err);
    if (end && (!strcmp(end, ".nc") || !strcmp(end, ".h5")))
        return sweep_write_netcdf(t, path, err);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: its name must end with .csv, .nc "
                    "or .h5",
                    path);
}

/* Manifest, table, report; the exit code. */
static int finish(sweeping *w)
{
    sweep_table table;
    ovr_error err = {0};
    const char *path = cli_value(w->call, "collect");
    ovr_status status = sweep_gather(&w->s, &table, &err);
    int code;
    if (!status)
        status = sweep_write_manifest(&table, &err);
    if (!status && path)
        status = collect(&table, path, &err);
    code = status ? cli_fail(&err) : code_of(&table);
    if (!status && w->call->json)
        report_json(w, &table);
    else if (!status && w->call->verbosity >= 0)
        report_table(w, &table);
    sweep_table_free(&table);
    return code;
}

/* -------------------------------------------------------------------- run */

static int start(sweeping *w, int workers)
{
    pool_job job = {w->tasks, w->task, workers, work, ended, tick, w};
    int stopped;
    w->progress = cli_progress_begin(w->call->verbosity, 0);
    stopped = pool_run(&job);
    cli_progress_end(&w->progress);
    if (stopped < 0)
        fprintf(stderr, "overroll sweep: no worker could be started: %s\n",
                strerror(errno));
    return stopped;
}

static int run_all(sweeping *w, int workers)
{
    int stopped = w->tasks ? start(w, workers) : 0;
    int code = finish(w);
    if (stopped < 0)
        return CLI_FAILED;
    return stopped ? CLI_SIGNAL + stopped : code;
}

/* One task, for job arrays: other tasks may be under way, so no manifest. */
static int run_task(sweeping *w, size_t task)
{
    sweep_state state;
    char text[1100];
    int stopped = 0;
    w->task = ovr_arena_take(&w->s.arena, 1, sizeof *w->task, NULL);
    if (!w->task)
        return CLI_FAILED;
    w->task[0] = task;
    w->tasks = sweep_wanted(&w->how, sweep_state_of(&w->s, task));
    if (w->tasks)
        stopped = start(w, 1);
    w->task = NULL;
    state = sweep_state_of(&w->s, task);
    sweep_message(&w->s, task, text, sizeof text);
    if (w->call->verbosity >= 0)
        printf("%zu %s %s%s%s\n", task + 1, sweep_state_name(state),
               w->s.name[task], *text ? ": " : "", text);
    if (stopped)
        return stopped < 0 ? CLI_FAILED : CLI_SIGNAL + stopped;
    if (state == SWEEP_FAILED)
        return CLI_FAILED;
    return state == SWEEP_FINISHED ? CLI_DONE : CLI_EARLY;
}

/* ---------------------------------------------------------------- options */

/* A whole number from 1 to most; 0 after having said why not. */
static size_t count_option(const cli_call *call, const char *name, size_t most,
                           size_t otherwise)
{
    const char *text = cli_value(call, name);
    char *end;
    unsigned long n;
    if (!text)
        return otherwise;
    n = strtoul(text, &end, 10);
    if (*text >= '0' && *text <= '9' && !*end && n >= 1 && n <= most)
        return n;
    cli_usage(call, "%s%s %s: a whole number from 1 to %zu is wanted",
              name[1] ? "--" : "-", name, text, most);
    return 0;
}

static size_t processors(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > POOL_MOST ? POOL_MOST : (size_t)n;
}

static bool make_folder(const char *path, ovr_error *err)
{
    if ((mkdir(path, 0777) == 0 || errno == EEXIST) &&
        access(path, W_OK | X_OK) == 0)
        return true;
    ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be written: %s", path,
             strerror(errno));
    return false;
}

static int do_what_is_asked(sweeping *w)
{
    ovr_error err = {0};
    size_t workers = count_option(w->call, "j", POOL_MOST, processors());
    size_t task = count_option(w->call, "task", w->s.tasks, w->s.tasks);
    if (!workers || !task)
        return CLI_USAGE;
    if (!cli_flag(w->call, "list") && !make_folder(w->s.output, &err))
        return cli_fail(&err);
    if (cli_flag(w->call, "task"))
        return run_task(w, task - 1);
    if (cli_flag(w->call, "collect"))
        return finish(w);
    if (make_list(w, &err))
        return cli_fail(&err);
    if (cli_flag(w->call, "list")) {
        print_list(w);
        return CLI_DONE;
    }
    return run_all(w, (int)workers);
}

static int run(cli_call *call)
{
    sweeping w = {.call = call, .begun = cli_seconds()};
    ovr_error err = {0};
    int code;
    w.how = (sweep_how){call, cli_flag(call, "retry"), cli_flag(call, "redo")};
    if (study_read(call->argument[0], &w.s, &err)) {
        code = cli_fail(&err);
    } else {
        if (cli_value(call, "o"))
            w.s.output = cli_value(call, "o");
        code = do_what_is_asked(&w);
    }
    study_free(&w.s);
    return code;
}

static const cli_option options[] = {
    {"j", "N", "so many cases at once; all processors unless given", false},
    {"o", "FOLDER", "results, instead of [study] output", false},
    {"list", NULL, "print the commands of the cases still to be run", false},
    {"task", "I", "only case I, from 1: for job arrays", false},
    {"collect", "FILE", "gather the summaries into FILE.csv or FILE.nc", false},
    {"retry", NULL, "failed cases again", false},
    {"redo", NULL, "all cases again from their beginning", false},
    {0}};

const cli_verb cli_sweep = {
    .name = "sweep",
    .arguments = "STUDY.ini",
    .summary = "many runs: lists, ranges and products over any parameter",
    .help =
        "Runs every case of the study that has not finished, resumes stopped "
        "ones, and\nwrites manifest.csv in the folder of the results: a row "
        "each case.  --collect\nruns nothing.  The study is described in "
        "overroll-study(5).",
    .options = options,
    .least = 1,
    .most = 1,
    .run = run,
};
