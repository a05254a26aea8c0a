/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The program inside a web page: its command line and three additional
 * commands.
 *
 *     keys                            the table of keys and sections
 *     entries CASE                    the keys of a case
 *     solve CASE [-o OUT.h5] [--steady] [--resume] [--json] [--set ...]
 *
 * `solve` is `steady`, `run` or `resume`; it passes each state to the page and
 * asks the page whether to stop.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "case/setup.h"
#include "cli/case_args.h"
#include "cli/cli.h"
#include "cli/json.h"
#include "cli/report.h"
#include "cli/watch.h"
#include "simulation/simulation.h"

int overroll_main(int argc, char **argv);

#ifdef __wasm__
#define IMPORT(name)                                                           \
    __attribute__((import_module("page"), import_name(#name))) extern
#define EXPORT(name) __attribute__((export_name(#name)))
#else /* In tests, tests/unit/page_test.c implements the page. */
#define IMPORT(name) extern
#define EXPORT(name)
#endif

/* Returns nonzero if the user has requested a stop. */
IMPORT(stop) int page_stop(void);
/* Returns nonzero if the page is ready for another state. */
IMPORT(wants) int page_wants(void);
/* Passes field k of `fields` below to the page, which copies it: n values in
 * Hertzian units (temperatures in K). Field 0 is X. */
IMPORT(field) void page_field(int k, size_t n, const double *values);
/* Called after all fields of the state at T have been passed. b and p are those
 * of the dry contact for the load and radius at T. */
IMPORT(state)
void page_state(double T, double fraction, double b, double p);

/* Runs a command line like main and returns the exit code. */
EXPORT(page_main) int page_main(int argc, char **argv);
EXPORT(page_alloc) void *page_alloc(size_t bytes);
EXPORT(page_free) void page_free(void *memory);

/* ----------------------------------------------------------------- solving */

typedef struct page_watch {
    cli_watch watch; /* must be the first member: callbacks of the command line
                      * use it */
    double fraction;
    bool steady;
} page_watch;

/* Fields of a state that the player draws, in the order of worker.js. */
static const struct {
    const char *name;
    unsigned needs; /* physical models; 0: always available */
} fields[] = {{"pressure", 0},
              {"film_thickness", 0},
              {"roughness", OVR_PHYSICS_FEATURES},
              {"filling", OVR_PHYSICS_CONTENT},
              {"temperature_1", OVR_PHYSICS_HEAT},
              {"temperature_2", OVR_PHYSICS_HEAT},
              {"temperature_middle", OVR_PHYSICS_HEAT},
              {"contact_pressure", OVR_PHYSICS_BOUNDARY}};

static void post_state(page_watch *w, const ovr_run *run,
                       const ovr_simulation *sim)
{
    const ovr_state *s = ovr_simulation_state(sim);
    const ovr_observation *now = ovr_simulation_observation(sim);
    const unsigned physics = ovr_setup_physics(ovr_run_get_info(run)->setup);
    double *workspace = malloc(s->n * sizeof *workspace);
    page_field(0, s->n, s->X);
    for (size_t k = 0; workspace && k < sizeof fields / sizeof *fields; k++) {
        const ovr_observable *o = ovr_observable_field(fields[k].name);
        if (o && (fields[k].needs & physics) == fields[k].needs)
            page_field((int)k + 1, s->n, o->field(sim, workspace));
    }
    free(workspace);
    page_state(s->T, w->fraction, sqrt(now->load_ratio * now->radius_ratio),
               sqrt(now->load_ratio / now->radius_ratio));
}

static void progress(void *data, const ovr_run *run, double fraction)
{
    page_watch *w = data;
    w->fraction = fraction;
    if (page_wants())
        post_state(w, run, ovr_run_get_info(run)->sim);
}

static bool stop(void *data)
{
    (void)data;
    return page_stop() != 0;
}

static ovr_status change(void *data, ovr_case *c, ovr_error *err)
{
    const page_watch *w = data;
    return cli_apply_options(w->watch.call, c, err);
}

static ovr_run *create(cli_call *call, page_watch *w, ovr_case *c,
                       ovr_error *err)
{
    ovr_run_options how = cli_run_options(&w->watch);
    how.stop = how.interrupt = stop;
    how.progress = progress;
    how.steady = w->steady;
    how.output = cli_value(call, "o");
    how.force = true;
    if (!c) {
        how.change = change;
        how.from_start = true;
        return ovr_run_resume(call->argument[0], &how, NULL, err);
    }
    return ovr_run_create(c, &how, NULL, err);
}

/* Like cli_finish_run, but passes the last state to the page. */
static int finish(page_watch *w, ovr_run *run, ovr_error *err)
{
    const cli_call *call = w->watch.call;
    ovr_status status;
    int code;
    if (!run)
        return err->status ? cli_fail(err) : CLI_DONE;
    w->watch.progress = cli_progress_begin(-1, 0);
    status = ovr_run_execute(run, err);
    if (cli_has_result(run, status)) {
        w->fraction = ovr_run_get_info(run)->fraction;
        post_state(w, run, ovr_run_get_info(run)->sim);
        cli_report(call, ovr_run_get_info(run));
    }
    code = status == OVR_STOPPED ? CLI_EARLY
                                 : cli_run_code(call, run, status, err);
    ovr_run_free(run);
    return code;
}

static int solve(cli_call *call)
{
    page_watch w = {.watch = {.call = call},
                    .steady = cli_flag(call, "steady")};
    ovr_error err = {0};
    ovr_case *c = NULL;
    int code = CLI_DONE;
    if (!cli_flag(call, "resume")) {
        c = cli_open_case(call, &code);
        if (!c)
            return code;
    }
    code = finish(&w, create(call, &w, c, &err), &err);
    ovr_case_free(c);
    return code;
}

static const cli_option solve_options[] = {
    {"o", "OUT.h5", "result file", false},
    {"steady", NULL, "solve only the steady contact", false},
    {"resume", NULL, "CASE is a result file to be resumed", false},
    CLI_ESTIMATE_OPTION,
    CLI_CASE_OPTIONS,
    {0}};

static const cli_verb cli_solve = {
    .name = "solve",
    .arguments = "CASE",
    .summary = "solve a case and send messages and results to the page",
    .options = solve_options,
    .minimum = 1,
    .maximum = 1,
    .run = solve,
};

/* ------------------------------------------------------------------- table */

static void write_key(json_writer *json, const ovr_parameter_info *p)
{
    json_open(json, NULL);
    json_text(json, "section", p->section);
    json_text(json, "key", p->key);
    json_text(json, "type", p->type);
    json_text(json, "units", p->units);
    json_text(json, "bare", p->bare);
    json_text(json, "initial", p->initial);
    json_number(json, "minimum", p->minimum);
    json_number(json, "maximum", p->maximum);
    json_text(json, "when", p->when);
    json_text(json, "help", p->help);
    json_open_array(json, "choices");
    for (const char *const *word = p->choices; *word; word++)
        json_text(json, NULL, *word);
    json_close_array(json);
    json_close(json);
}

static int keys(cli_call *call)
{
    json_writer json = json_begin(stdout);
    (void)call;
    json_text(&json, "version", OVERROLL_VERSION);
    json_open_array(&json, "sections");
    for (size_t k = 0; ovr_section_name(k); k++) {
        json_open(&json, NULL);
        json_text(&json, "name", ovr_section_name(k));
        json_flag(&json, "named", ovr_section_named(k));
        json_text(&json, "help", ovr_section_help(k));
        json_close(&json);
    }
    json_close_array(&json);
    json_open_array(&json, "keys");
    for (size_t k = 0; k < ovr_parameter_count(); k++) {
        ovr_parameter_info p = ovr_parameter_at(k);
        write_key(&json, &p);
    }
    json_close_array(&json);
    json_end(&json);
    return CLI_DONE;
}

static const cli_verb cli_keys = {
    .name = "keys",
    .arguments = "",
    .summary = "the table of keys",
    .run = keys,
};

/* Prints every key of the sections of a case, given or not, and whether it has
 * an effect. For an invalid case, prints its first error. */
static int entries(cli_call *call)
{
    ovr_error err = {0};
    ovr_case *c = ovr_case_read(call->argument[0], NULL, &err);
    json_writer json;
    if (!c)
        return cli_fail(&err);
    json = json_begin(stdout);
    json_open_array(&json, "entries");
    for (size_t k = 0; k < ovr_case_entries(c); k++) {
        ovr_case_entry e = ovr_case_entry_at(c, k);
        json_open(&json, NULL);
        json_text(&json, "section", e.section);
        json_text(&json, "name", e.name);
        json_text(&json, "key", e.key);
        json_text(&json, "text", e.text);
        json_flag(&json, "given", e.given);
        json_flag(&json, "applies", e.applies);
        json_close(&json);
    }
    json_close_array(&json);
    json_end(&json);
    ovr_case_free(c);
    return CLI_DONE;
}

static const cli_verb cli_entries = {
    .name = "entries",
    .arguments = "CASE",
    .summary = "the keys of a case",
    .minimum = 1,
    .maximum = 1,
    .run = entries,
};

/* -------------------------------------------------------------- entry point */

void *page_alloc(size_t bytes)
{
    return malloc(bytes);
}

void page_free(void *memory)
{
    free(memory);
}

int page_main(int argc, char **argv)
{
    static const cli_verb *const own[] = {&cli_solve, &cli_keys, &cli_entries,
                                          NULL};
    const cli_verb *verb = argc > 1 ? cli_find_verb(own, argv[1]) : NULL;
    cli_call call;
    int code;
    if (!verb)
        return overroll_main(argc, argv);
    code = cli_parse(&call, verb, argc - 2, argv + 2);
    call.verbs = own;
    if (code == CLI_DONE)
        code = verb->run(&call);
    cli_free(&call);
    fflush(stdout);
    return code;
}
