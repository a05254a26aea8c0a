/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creates the writer of the result file from [output] of the case. */
#define _XOPEN_SOURCE 700 /* realpath */
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/team.h"
#include "case/inputs.h"
#include "case/resolve.h"
#include "case/setup.h"
#include "results/checkpoint.h"
#include "results/layout.h"
#include "results/results.h"
#include "results/writer.h"
#include "run/cost.h"
#include "run/internal.h"
#include "run/pass_series.h"
#include "run/run.h"
#include "surface/surfaces.h"

enum { NAME_CAPACITY = 128, TIMES_MAX = 100000 };

/* -------------------------------------------------- checks of the output */

static void folder_of(const char *path, char *folder, size_t capacity)
{
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash - path) : 0;
    snprintf(folder, capacity, "%.*s", (int)length, path);
    if (!slash)
        snprintf(folder, capacity, ".");
    else if (slash == path)
        snprintf(folder, capacity, "/");
}

static bool same_file(const char *one, const char *other)
{
    struct stat a, b;
    return stat(one, &a) == 0 && stat(other, &b) == 0 && a.st_ino == b.st_ino &&
           a.st_dev == b.st_dev;
}

/* True if the result or one of its additional files would replace an input file
 * of the case. */
static bool is_input(const char *path, const char *input)
{
    static const char *const endings[] = {"", ".part", ".restart",
                                          ".restart.part", ".journal"};
    char beside[4096];
    for (size_t k = 0; k < sizeof endings / sizeof *endings; k++) {
        int n = snprintf(beside, sizeof beside, "%s%s", path, endings[k]);
        if (n > 0 && n < (int)sizeof beside && same_file(beside, input))
            return true;
    }
    return false;
}

static ovr_status check_inputs(const char *path, const ovr_case *c,
                               ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_inputs inputs;
    ovr_status status = ovr_case_inputs(c, &arena, &inputs, err);
    bool clash = !status && is_input(path, ovr_case_name(c));
    for (size_t k = 0; !status && !clash && k < inputs.count; k++)
        clash = is_input(path, inputs.input[k].path);
    ovr_arena_release(&arena);
    if (status)
        return status;
    return clash ? ovr_fail(err, OVR_BAD_INPUT,
                            "%s: the result would replace a file that the "
                            "case is read from",
                            path)
                 : OVR_OK;
}

/* Returns the suffix of `path` if it denotes a table, picture, text or page;
 * otherwise NULL. */
static const char *foreign_ending(const char *path)
{
    static const char *const endings[] = {".csv",  ".txt", ".json", ".png",
                                          ".svg",  ".pdf", ".html", ".ini",
                                          ".xlsx", ".mp4", ".gif"};
    const char *dot = strrchr(path, '.');
    for (size_t k = 0; dot && k < sizeof endings / sizeof *endings; k++)
        if (!strcmp(dot, endings[k]))
            return endings[k];
    return NULL;
}

/* True for the file of a run that is not finished, or of its passes. */
static bool is_unfinished(const char *path)
{
    if (ovr_passes_file_is(path))
        return !ovr_passes_file_complete(path);
    ovr_result *result = ovr_result_open(path, NULL, NULL);
    const char *status = result ? ovr_result_get_info(result)->status : "";
    bool unfinished = !strcmp(status, "running") || !strcmp(status, "stopped");
    ovr_result_close(result);
    return unfinished;
}

static ovr_status fail_existing(const char *path, ovr_error *err)
{
    if (is_unfinished(path))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: exists already and is not finished; 'overroll "
                        "resume %s' continues it, --force replaces it",
                        path, path);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: exists already; --force replaces it", path);
}

ovr_status ovr_output_check(const char *path, const ovr_case *c, bool force,
                            ovr_error *err)
{
    char folder[4096];
    folder_of(path, folder, sizeof folder);
    if (!*path || path[strlen(path) - 1] == '/')
        return ovr_fail(err, OVR_BAD_INPUT, "'%s' is not a file name", path);
    if (check_inputs(path, c, err))
        return OVR_BAD_INPUT;
    if (foreign_ending(path))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: a result is an HDF5 file, not a %s file; use "
                        "NAME.h5 or NAME.nc",
                        path, foreign_ending(path));
    if (access(path, F_OK) == 0 && !force)
        return fail_existing(path, err);
    if (access(folder, W_OK | X_OK) != 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be written: %s: %s",
                        path, folder, strerror(errno));
    return OVR_OK;
}

/* ------------------------------------------------------------- attributes */

static const char *full_name(const ovr_case_entry *entry, ovr_arena *arena)
{
    char name[NAME_CAPACITY];
    if (entry->name)
        snprintf(name, sizeof name, "%s %s.%s", entry->section, entry->name,
                 entry->key);
    else
        snprintf(name, sizeof name, "%s.%s", entry->section, entry->key);
    return ovr_arena_text(arena, name, NULL);
}

/* Returns the attributes of the group `case`: all parameters with a value. */
ovr_case_value *ovr_run_values(const ovr_case *c, ovr_arena *arena,
                               size_t *count)
{
    size_t all = ovr_case_entries(c), n = 0;
    ovr_case_value *values = ovr_arena_take(arena, all, sizeof *values, NULL);
    for (size_t k = 0; values && k < all; k++) {
        ovr_case_entry entry = ovr_case_entry_at(c, k);
        if (!entry.text)
            continue;
        const ovr_section *section;
        const ovr_parameter *row = ovr_parameter_row(entry.parameter, &section);
        bool number = isfinite(row->minimum) && isfinite(entry.number);
        values[n] = (ovr_case_value){.name = full_name(&entry, arena),
                                     .text = entry.text,
                                     .number = number ? entry.number : NAN,
                                     .unit = entry.unit,
                                     .physics = row->physics};
        if (!values[n++].name)
            return NULL;
    }
    *count = n;
    return values;
}

/* ------------------------------------------------------------------ times */

typedef struct moments {
    size_t count, capacity;
    double *T;
    ovr_arena *arena;
} moments;

static bool reserve_moments(moments *m, size_t capacity)
{
    double *T = ovr_arena_take(m->arena, capacity, sizeof *T, NULL);
    if (T && m->count)
        memcpy(T, m->T, m->count * sizeof *T);
    m->T = T;
    m->capacity = T ? capacity : 0;
    return T;
}

static void add_moment(moments *m, double T)
{
    if (!m->T || m->count == TIMES_MAX || !isfinite(T))
        return;
    if (m->count < m->capacity || reserve_moments(m, 2 * m->capacity))
        m->T[m->count++] = T;
}

/* Adds the times at which features and their copies pass the requested X. */
static void add_arrivals(moments *m, const ovr_setup *setup, double X)
{
    double end = setup->march->end;
    size_t n = setup->surfaces ? ovr_surfaces_count(setup->surfaces) : 0;
    for (size_t k = 0; k < n; k++) {
        double T = -1;
        for (int copy = 0; copy < 1000; copy++) {
            T = ovr_surfaces_arrival(setup->surfaces, k, X, T, end);
            if (!(T <= end))
                break;
            add_moment(m, T);
        }
    }
}

static double *make_times(const ovr_setup *setup, ovr_arena *arena,
                          size_t *count)
{
    const ovr_output *out = setup->output;
    moments m = {.arena = arena};
    reserve_moments(&m, 64);
    for (size_t i = 0; m.T && i < out->at.count; i++)
        add_moment(&m, out->at.values[i]);
    for (size_t i = 0; m.T && i < out->feature_at.count; i++)
        add_arrivals(&m, setup, out->feature_at.values[i]);
    *count = m.count;
    return m.T;
}

/* ----------------------------------------------------------------- writer */

static void choose(ovr_write_options *w, const ovr_setup *setup, bool no_thread)
{
    const ovr_output *out = setup->output;
    double dT = ovr_setup_step(setup);
    w->every_steps = out->every;
    w->every_time = out->interval;
    w->fields = out->fields;
    w->physics = ovr_setup_physics(setup);
    w->single = out->single;
    w->x_from = out->from;
    w->x_to = out->to;
    w->stride = (size_t)out->stride;
    w->deflate = out->compression;
    w->no_thread = no_thread || ovr_processors() < 2;
    w->checkpoint_interval = out->checkpoint;
    w->end = setup->transient ? setup->march->end : NAN;
    w->lines = ovr_setup_lines(setup);
    if (out->title)
        w->title = out->title;
    if (!out->every && !(out->interval > 0) && !w->time_count)
        w->every_steps = setup->transient
                             ? ovr_write_every(w, w->end, dT, setup->nodes)
                             : 1;
}

static double stored_nodes(const ovr_setup *setup)
{
    const ovr_options *o = setup->options;
    double from = fmax(o->inlet, setup->output->from);
    double to = fmin(o->outlet, setup->output->to);
    return floor(fmax(to - from, 0) / setup->mesh / setup->output->stride) + 1;
}

/* Returns the size of the input files that the result file will contain. */
static double input_bytes(const ovr_case *c)
{
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_inputs inputs;
    double bytes = 0;
    if (ovr_case_inputs(c, &arena, &inputs, NULL))
        return 0;
    for (size_t k = 0; k < inputs.count; k++) {
        struct stat about;
        if (inputs.input[k].first == k &&
            stat(inputs.input[k].path, &about) == 0 &&
            about.st_size <= OVR_INPUT_MAX)
            bytes += (double)about.st_size;
    }
    ovr_arena_release(&arena);
    return bytes;
}

/* Bytes of names, attributes and the case in a result file: 0.24 MB measured.
 */
static const double FRAME = 3e5;

ovr_storage ovr_setup_storage(const ovr_setup *setup)
{
    enum {
        EXTREMES = 2
    }; /* snapshots at maximum pressure and minimum film thickness */
    if (!setup)
        return (ovr_storage){0};
    ovr_write_options w = ovr_write_options_default();
    ovr_arena arena = ovr_arena_make(NULL);
    double dT = ovr_setup_step(setup);
    ovr_storage s = {1, FRAME};
    double more = 0;
    make_times(setup, &arena, &w.time_count);
    ovr_arena_release(&arena);
    choose(&w, setup, true);
    if (setup->transient) {
        double steps = ceil(w.end / dT - 1e-6);
        s.snapshots += (double)w.time_count;
        if (w.every_steps > 0)
            s.snapshots += floor(steps / (double)w.every_steps);
        if (w.every_time > 0)
            s.snapshots += floor(w.end / w.every_time);
        s.snapshots = fmin(s.snapshots, steps + 1);
        more = fmin(EXTREMES, steps + 1 - s.snapshots);
        s.bytes += (steps + 1) * 8 *
                   (double)ovr_layout_columns(w.physics, NULL);
    }
    s.bytes += (s.snapshots + more) * stored_nodes(setup) * (double)w.lines *
               (w.single ? 4 : 8) * (double)ovr_layout_fields(w.fields, NULL);
    s.bytes += input_bytes(setup->resolved->c);
    return s;
}

double ovr_setup_output_memory(const ovr_setup *setup)
{
    if (!setup)
        return NAN;
    ovr_write_options w = ovr_write_options_default();
    ovr_arena arena = ovr_arena_make(NULL);
    double bytes = INFINITY;
    double *X = ovr_arena_take(&arena, setup->nodes, sizeof *X, NULL);
    w.Y = ovr_arena_take(&arena, ovr_setup_lines(setup), sizeof *w.Y, NULL);
    for (size_t i = 0; X && i < setup->nodes; i++)
        X[i] = setup->options->inlet + (double)i * setup->mesh;
    w.path = "counted";
    w.times = make_times(setup, &arena, &w.time_count);
    choose(&w, setup, false);
    if (X && w.Y && w.times)
        bytes = ovr_writer_memory(&w, setup->contact, setup->nodes, X);
    ovr_arena_release(&arena);
    return bytes;
}

/* Options of the writer. Texts and lists belong to the case. */
typedef struct target {
    ovr_write_options options;
    ovr_arena arena;
    ovr_case_value *values;
    double *times;
} target;

/* Returns the absolute path of the case's folder, because a resumed run may
 * start in another folder. */
static const char *absolute(const char *folder, ovr_arena *arena)
{
    char path[PATH_MAX];
    const char *found = realpath(folder && *folder ? folder : ".", path);
    return found ? ovr_arena_text(arena, found, NULL) : NULL;
}

/* Returns "roller" for a case "cases/roller.ini"; NULL if the case has no
 * file. */
static const char *title_of(const char *name, ovr_arena *arena)
{
    if (!name)
        return NULL;
    const char *slash = strrchr(name, '/'), *dot = strrchr(name, '.');
    char *title = ovr_arena_text(arena, slash ? slash + 1 : name, NULL);
    if (!dot || (strcmp(dot, ".ini") != 0 && strcmp(dot, ".h5") != 0))
        return NULL;
    if (title)
        title[dot - (slash ? slash + 1 : name)] = '\0';
    return title;
}

static ovr_status list_inputs(target *w, const ovr_run *run, ovr_error *err)
{
    ovr_inputs inputs;
    ovr_status status = ovr_case_inputs(run->c, &w->arena, &inputs, err);
    w->options.inputs = inputs.input;
    w->options.input_count = inputs.count;
    return status;
}

static ovr_status make_options(target *w, ovr_run *run, ovr_error *err)
{
    w->options = ovr_write_options_default();
    w->arena = ovr_arena_make(&run->arena.allocator);
    w->values = ovr_run_values(run->c, &w->arena, &w->options.value_count);
    w->times = make_times(run->setup, &w->arena, &w->options.time_count);
    w->options.path = run->info.output;
    w->options.times = w->times;
    w->options.values = w->values;
    w->options.case_text = ovr_case_text(run->c, err);
    ovr_status status = list_inputs(w, run, err);
    if (status)
        return status;
    w->options.case_path = absolute(ovr_case_directory(run->c), &w->arena);
    w->options.title = run->title ? run->title
                                  : title_of(ovr_case_name(run->c), &w->arena);
    choose(&w->options, run->setup, run->how.no_thread);
    w->options.Y = ovr_simulation_lines(run->sim, &w->options.lines,
                                        &w->options.shown);
    w->options.width = ovr_setup_width(run->setup);
    for (size_t k = 0; w->values && k < w->options.value_count; k++)
        if (strcmp(w->values[k].name, "output.precision") == 0)
            w->values[k].text = w->options.single ? "f32" : "f64";
    if (!w->values || !w->times)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory");
    return w->options.case_text ? OVR_OK : OVR_NO_MEMORY;
}

static void unwant(target *w)
{
    ovr_arena_release(&w->arena);
}

static ovr_status have(ovr_run *run, ovr_writer *writer, ovr_error *err)
{
    run->writer = writer;
    if (!writer)
        return OVR_BAD_INPUT;
    ovr_writer_checkpoints(writer, run->sim);
    if (ovr_writer_unlocked(writer))
        ovr_run_message(
            run, OVR_MESSAGE_WARNING,
            "the result's file system has no locks: nothing keeps a "
            "second run from writing the same file");
    return ovr_companions_open(run, err);
}

/* Reports the inputs that the result file does not hold. */
static void note_inputs(ovr_run *run, const ovr_write_options *o)
{
    for (size_t k = 0; k < o->input_count; k++) {
        const ovr_input *input = &o->inputs[k];
        struct stat about;
        char text[OVR_MESSAGE_SIZE];
        if (input->first != k || stat(input->path, &about) != 0 ||
            (S_ISREG(about.st_mode) && about.st_size <= OVR_INPUT_MAX))
            continue;
        snprintf(text, sizeof text,
                 S_ISREG(about.st_mode)
                     ? "the result file contains only the SHA-256 of %.600s, "
                       "which is larger than 4 MB (%s)"
                     : "the result file does not contain %.600s, which is not "
                       "an ordinary file (%s)",
                 input->path, input->key);
        ovr_run_message(run, OVR_MESSAGE_NOTE, text);
    }
}

ovr_status ovr_output_open(ovr_run *run, ovr_error *err)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    target w;
    ovr_writer *writer = NULL;
    if (make_options(&w, run, err) == OVR_OK) {
        w.options.force = run->how.force;
        writer = ovr_writer_create(&w.options, run->setup->contact, state->n,
                                   state->X, &run->arena.allocator, err);
        if (writer)
            note_inputs(run, &w.options);
    }
    unwant(&w);
    return have(run, writer, err);
}

/* Repeats the reports of the companions of a complete run. They cannot be
 * repeated if, for example, the depths of stresses have changed. */
static ovr_status restore_companions(ovr_run *run, double T, bool write,
                                     ovr_error *err)
{
    ovr_status status = ovr_companions_restore(run, T, err);
    if (!status || write)
        return status;
    ovr_companions_release(run);
    return OVR_OK;
}

ovr_status ovr_output_reopen(ovr_run *run, bool write, ovr_error *err)
{
    const ovr_state *state = ovr_simulation_state(run->sim);
    ovr_restart *restart = run->restart;
    target w;
    ovr_writer *writer = NULL;
    ovr_status status = make_options(&w, run, err);
    if (status == OVR_OK && restart)
        status = ovr_values_same(run->recorded_count, run->recorded,
                                 w.options.value_count, w.values, err);
    if (status == OVR_OK && restart && ovr_restart_get_info(restart)->has_state)
        status = ovr_restart_load(restart, run->sim, err);
    if (status == OVR_OK && restart && ovr_restart_get_info(restart)->has_state)
        status = restore_companions(run, state->T, write, err);
    if (status == OVR_OK && write)
        writer = ovr_writer_resume(&w.options, run->setup->contact, state->n,
                                   state->X, restart, &run->arena.allocator,
                                   err);
    unwant(&w);
    return write || status ? have(run, writer, err) : OVR_OK;
}
