/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The table of a study: a row for each task, columns for its varied keys and
 * for the numbers of the summaries.  It is gathered from the result files,
 * written as CSV and netCDF-4, and read from either; a file of several passes
 * is read into the same type.
 */
#include "run/study_table.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/entries.h"
#include "base/given.h"
#include "base/text.h"
#include "case/case.h"
#include "results/flat_table.h"
#include "results/hdf5read/hdf5read.h"
#include "results/results.h"
#include "run/csv.h"
#include "run/pass_series.h"
#include "run/run.h"
#include "run/task.h"
#include "run/trials.h"

enum { PATH_CAPACITY = 4400 };

/* -------------------------------------------------------------- Summaries */

static double *new_numbers(ovr_table *t, ovr_error *err)
{
    double *values = ovr_arena_take(&t->arena, t->rows, sizeof *values, err);
    for (size_t i = 0; values && i < t->rows; i++)
        values[i] = NAN;
    return values;
}

/* Returns a column of the summaries by its key, trying `hint` first. */
static const ovr_table_column *find_summary(const ovr_table *t,
                                            const char *name, size_t hint)
{
    if (hint >= t->keys && hint < t->columns &&
        !strcmp(t->column[hint].name, name))
        return &t->column[hint];
    return ovr_table_summary(t, name);
}

const ovr_table_column *ovr_table_summary(const ovr_table *t, const char *name)
{
    for (size_t k = t->keys; k < t->columns; k++)
        if (!strcmp(t->column[k].name, name))
            return &t->column[k];
    return NULL;
}

/* Stores a number of a task in the column `name`.  A new name adds a column, up
 * to OVR_TABLE_COLUMNS. */
static const ovr_table_column *store_number(ovr_table *t, size_t task,
                                            const char *name, double value,
                                            size_t hint, ovr_error *err)
{
    const ovr_table_column *c = find_summary(t, name, hint);
    if (!c && t->columns < OVR_TABLE_COLUMNS) {
        double *number = new_numbers(t, err);
        name = number ? ovr_arena_text(&t->arena, name, err) : NULL;
        if (name) {
            t->number[t->columns] = number;
            t->column[t->columns] = (ovr_table_column){
                .name = name, .unit = "", .number = number};
            c = &t->column[t->columns++];
        }
    }
    if (c)
        t->number[c - t->column][task] = value;
    return c;
}

/* Reads the numbers of a task of several passes; false if there is no summary.
 */
static bool read_passes(ovr_table *t, size_t task, const char *path,
                        ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&t->arena.allocator);
    size_t count;
    const ovr_named_number *line = ovr_passes_numbers(path, &arena, &count);
    for (size_t k = 0; line && k < count; k++)
        store_number(t, task, line[k].name, line[k].value, 0, err);
    ovr_arena_release(&arena);
    return line != NULL;
}

/* Reads the numbers of a task from its result file; false if there is no file
 * or no summary. */
static bool read_result(ovr_table *t, size_t task, ovr_error *err)
{
    char path[PATH_CAPACITY];
    ovr_result *result;
    const ovr_group_attribute *line;
    size_t count = 0;
    ovr_study_file(t->study, task, ".h5", path, sizeof path);
    result = access(path, F_OK) == 0
                 ? ovr_result_open(path, &t->arena.allocator, NULL)
                 : NULL;
    if (!result)
        return read_passes(t, task, path, err);
    line = ovr_result_attributes(result, "summary", &count);
    for (size_t k = 0; k < count; k++)
        store_number(t, task, line[k].name, line[k].number, 0, err);
    if (count) {
        const ovr_result_info *about = ovr_result_get_info(result);
        store_number(t, task, "snapshots", (double)about->snapshots, 0, err);
        store_number(t, task, "seconds", about->seconds, 0, err);
    }
    ovr_result_close(result);
    return count > 0;
}

/* State of reading a row. Its numbers are usually in the order of the
 * columns. */
typedef struct row_reader {
    ovr_table *t;
    size_t task, next;
    ovr_error *err;
} row_reader;

static void store_cell(void *data, const char *name, double value)
{
    row_reader *r = data;
    const ovr_table_column *c = store_number(r->t, r->task, name, value,
                                             r->next, r->err);
    if (c)
        r->next = (size_t)(c - r->t->column) + 1;
}

static bool read_row(ovr_table *t, size_t task, ovr_error *err)
{
    row_reader r = {t, task, t->keys, err};
    return t->results && !ovr_rows_elsewhere(t->results, task) &&
           ovr_rows_read(t->results, task, store_cell, &r);
}

/* True if the summaries repeat a key of the study (M, L); it is then
 * omitted. */
static bool is_taken(const ovr_table *t, const char *name)
{
    for (size_t k = 0; k < t->keys; k++)
        if (!strcmp(t->column[k].name, name))
            return true;
    return !strcmp(name, "case") || !strcmp(name, "name") ||
           !strcmp(name, "status");
}

/* Removes columns of keys that have no number in any case (texts). */
static void drop_columns(ovr_table *t)
{
    size_t kept = t->keys;
    for (size_t k = t->keys; k < t->columns; k++) {
        bool any = false;
        if (is_taken(t, t->column[k].name))
            continue;
        for (size_t i = 0; i < t->rows && !any; i++)
            any = !isnan(t->column[k].number[i]);
        if (!any)
            continue;
        t->number[kept] = t->number[k];
        t->column[kept++] = t->column[k];
    }
    t->columns = kept;
}

/* ------------------------------------------------------------------- Keys */

static ovr_status add_key(ovr_table *t, const ovr_study_key *key,
                          ovr_error *err)
{
    const char **text = ovr_arena_take(&t->arena, t->rows, sizeof *text, err);
    double *number = new_numbers(t, err);
    const ovr_table_column c = {
        .name = ovr_arena_text(&t->arena, key->shown, err),
        .unit = "",
        .varied = true,
        .number = number,
        .text = text,
        .zip = key->zip ? ovr_arena_text(&t->arena, key->zip_name, err) : NULL};
    for (size_t i = 0; text && i < t->rows; i++) {
        char value[OVR_STUDY_VALUE];
        text[i] = ovr_arena_text(&t->arena,
                                 ovr_study_value(t->study, key, i, value), err);
        if (!text[i])
            return OVR_NO_MEMORY;
    }
    if (!text || !c.name || !c.number || (key->zip && !c.zip))
        return OVR_NO_MEMORY;
    t->key[t->keys++] = key;
    t->number[t->columns] = number;
    t->column[t->columns++] = c;
    return OVR_OK;
}

bool ovr_table_numeric(const ovr_table_column *key)
{
    return !isnan(key->number[0]);
}

/* Stores the key's number in a task; returns false if its value is no number.
 */
static bool store_value(ovr_table *t, size_t k, const ovr_case *c, size_t task)
{
    const char *where = t->key[k]->where;
    ovr_case_entry e;
    if (!ovr_case_entry_of(c, where, strlen(where), &e))
        return false;
    t->number[k][task] = e.number;
    if (e.unit && strcmp(e.unit, "1") != 0)
        t->column[k].unit = e.unit;
    return isfinite(ovr_parameter_at(e.parameter).minimum) &&
           isfinite(e.number);
}

/* Adds the columns of the keys.  A key whose value is no number in some task
 * has no numbers in any. */
static ovr_status add_keys(ovr_table *t, ovr_error *err)
{
    const ovr_study *s = t->study;
    bool none[OVR_STUDY_MAX_KEYS] = {false};
    for (size_t k = 0; k < s->keys; k++)
        if (!s->key[k].fixed && add_key(t, &s->key[k], err))
            return OVR_NO_MEMORY;
    ovr_case *c = t->keys ? ovr_study_case(s, 0, err) : NULL;
    for (size_t i = 0; c && i < t->rows; i++)
        for (size_t k = 0; k < t->keys; k++)
            none[k] |= ovr_study_put(s, t->key[k], i, c, NULL) ||
                       !store_value(t, k, c, i);
    ovr_case_free(c);
    if (t->keys && !c)
        return OVR_BAD_INPUT;
    for (size_t k = 0; k < t->keys; k++)
        for (size_t i = 0; none[k] && i < t->rows; i++)
            t->number[k][i] = NAN;
    return OVR_OK;
}

/* ------------------------------------------------------------------ Table */

static ovr_status gather(ovr_table *t, ovr_error *err)
{
    const ovr_study *s = t->study;
    ovr_sweep_state *state = ovr_arena_take(&t->arena, s->tasks, sizeof *state,
                                            err);
    t->rows = s->tasks;
    t->state = state;
    if (!state || add_keys(t, err))
        return OVR_NO_MEMORY;
    if (ovr_study_in_rows(s) && !(t->results = ovr_rows_open(s, true, err)))
        return OVR_IO;
    for (size_t i = 0; i < s->tasks; i++) {
        state[i] = ovr_task_state(s, t->results, i);
        if (state[i] == OVR_SWEEP_FINISHED && !read_row(t, i, err)) {
            if (t->results && !ovr_rows_elsewhere(t->results, i))
                state[i] = OVR_SWEEP_WAITING; /* the row was destroyed */
            else if (!read_result(t, i, err))
                state[i] = OVR_SWEEP_CHANGED; /* by an earlier version */
        }
        t->count[state[i]]++;
    }
    drop_columns(t);
    return OVR_OK;
}

ovr_table *ovr_study_table(const ovr_study *study, ovr_error *err)
{
    if (!study)
        return ovr_null(err, __func__);
    ovr_table *t = ovr_table_make(&study->arena.allocator, err);
    if (t)
        t->study = study;
    if (!t || !gather(t, err))
        return t;
    ovr_table_free(t);
    return NULL;
}

ovr_status ovr_table_fail_empty(const ovr_table *t, ovr_error *err)
{
    if (t->count[OVR_SWEEP_CHANGED])
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the study was changed after its cases were run (%zu "
                        "of %zu); 'overroll sweep --redo' runs them again",
                        t->count[OVR_SWEEP_CHANGED], t->rows);
    if (t->count[OVR_SWEEP_FAILED])
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no case has finished, %zu failed; 'overroll sweep' "
                        "prints the reasons",
                        t->count[OVR_SWEEP_FAILED]);
    return ovr_fail(err, OVR_BAD_INPUT,
                    "no case has finished yet; 'overroll sweep' runs them");
}

/* -------------------------------------------------------------------- CSV */

/* True for the main numbers: extremes of transient runs, or values of steady
 * solutions. */
static bool is_main(const ovr_table *t, const char *name)
{
    static const char *const names[] = {"P_max_overall",
                                        "P_max_overall_Pa",
                                        "T_P_max",
                                        "H_min_overall",
                                        "H_min_overall_m",
                                        "T_H_min",
                                        "load_error_max",
                                        "steps_marked",
                                        "seconds",
                                        "H_min",
                                        "min_film_m",
                                        "H_min_located",
                                        "min_film_located_m",
                                        "H_cen",
                                        "central_film_m",
                                        "P_max",
                                        "max_pressure_Pa"};
    size_t maximum = sizeof names / sizeof names[0];
    if (ovr_table_summary(t, "P_max_overall"))
        maximum -= 8;
    for (size_t i = 0; i < maximum; i++)
        if (!strcmp(names[i], name))
            return true;
    return false;
}

/* Writes a key and, unless the manifest is written, the unit of its numbers;
 * values of the manifest contain their units. */
static void write_key(const ovr_table_column *c, FILE *to, bool manifest)
{
    char head[200];
    bool pure = manifest || !ovr_table_numeric(c) || !*c->unit;
    snprintf(head, sizeof head, "%.140s%s%s%s", c->name, pure ? "" : " [",
             pure ? "" : c->unit, pure ? "" : "]");
    ovr_csv_text(to, head);
}

static void write_heads(const ovr_table *t, FILE *to, bool manifest)
{
    fputs("task,name", to);
    for (size_t k = 0; k < t->keys; k++) {
        fputc(',', to);
        write_key(&t->column[k], to, manifest);
    }
    fputs(manifest ? ",status,output,summary" : ",status", to);
    for (size_t k = t->keys; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name))
            fprintf(to, ",%s", t->column[k].name);
    fputs(manifest ? ",message\n" : "\n", to);
}

/* Writes the name of a task's file if the file exists. */
static void write_file(const ovr_table *t, size_t task, const char *ending,
                       FILE *to)
{
    char path[PATH_CAPACITY];
    fputc(',', to);
    if (t->results && !ovr_rows_elsewhere(t->results, task)) {
        ovr_rows_table(t->results, task, path, sizeof path);
        ovr_csv_text(to, strcmp(ending, ".json") ? "" : path);
        return;
    }
    ovr_study_file(t->study, task, ending, path, sizeof path);
    if (access(path, F_OK) == 0)
        ovr_csv_text(to, strrchr(path, '/') + 1);
}

static void write_row(const ovr_table *t, size_t i, FILE *to, bool manifest)
{
    char message[1100], name[OVR_STUDY_NAME];
    fprintf(to, "%zu,", i + 1);
    ovr_study_name(t->study, i, name, sizeof name);
    ovr_csv_text(to, name);
    for (size_t k = 0; k < t->keys; k++) {
        const ovr_table_column *c = &t->column[k];
        fputc(',', to);
        if (manifest || !ovr_table_numeric(c))
            ovr_csv_text(to, c->text[i]);
        else
            ovr_csv_number(to, c->number[i], 17);
    }
    fprintf(to, ",%s", ovr_sweep_state_name(t->state[i]));
    if (manifest) {
        write_file(t, i, ".h5", to);
        write_file(t, i, ".json", to);
    }
    for (size_t k = t->keys; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name)) {
            fputc(',', to);
            ovr_csv_number(to, t->column[k].number[i], manifest ? 6 : 17);
        }
    if (manifest) {
        message[0] = '\0';
        if (t->state[i] == OVR_SWEEP_FAILED)
            ovr_sweep_message(t->study, i, message, sizeof message);
        fputc(',', to);
        ovr_csv_text(to, message);
    }
    fputc('\n', to);
}

/* Written to a temporary file and renamed, so that readers find a complete
 * table. */
ovr_status ovr_sweep_write_csv(const ovr_table *t, const char *path,
                               bool manifest, ovr_error *err)
{
    char part[PATH_CAPACITY + 32];
    snprintf(part, sizeof part, "%s.%ld.part", path, (long)getpid());
    unlink(part);
    FILE *to = fopen(part, "wx"); /* does not follow an existing link */
    if (to) {
        write_heads(t, to, manifest);
        for (size_t i = 0; i < t->rows; i++)
            write_row(t, i, to, manifest);
    }
    ovr_status status = ovr_csv_end(to, path, err);
    if (!status && rename(part, path) == 0)
        return OVR_OK;
    unlink(part);
    return status ? status
                  : ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                             strerror(errno));
}

/* ------------------------------------------------------------------- NetCDF */

/* Structure: one dimension, `case`, and a variable with that dimension for each
 * key and number. */

/* Returns the unit of a summary's key, which is part of its name. */
static const char *unit_of(const char *name)
{
    static const char *const units[][2] = {
        {"_N_per_m", "N/m"}, {"_m_per_s", "m/s"}, {"_Pa", "Pa"},
        {"_m", "m"},         {"_s", "s"},         {"seconds", "s"}};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        size_t end = strlen(units[i][0]);
        if (length >= end && !strcmp(name + length - end, units[i][0]))
            return units[i][1];
    }
    return "1";
}

/* Writes the meaning of a summary's key, if it is in the lists. */
static void explain(const ovr_table *t, const char *key, char *text,
                    size_t capacity)
{
    ovr_extreme e;
    const ovr_observable *o;
    bool run = ovr_table_summary(t, "T_end") != NULL;
    snprintf(text, capacity, "%s", key);
    for (size_t k = 0; ovr_extreme_at(k, &e); k++)
        if (!strcmp(e.key, key) || !strcmp(e.key_si, key))
            snprintf(text, capacity, "%s", e.long_name);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if ((o->key && !strcmp(o->key, key)) ||
            (o->key_si && !strcmp(o->key_si, key)))
            snprintf(text, capacity, "%s%s", o->long_name,
                     run ? " at the end of the run" : "");
}

static bool write_key_variable(const ovr_table *t, const ovr_flat *rows,
                               size_t k)
{
    const ovr_table_column *c = &t->column[k];
    const char *where = t->key[k]->where;
    bool good = ovr_table_numeric(c)
                    ? ovr_flat_numbers(rows, c->name, *c->unit ? c->unit : "1",
                                       where, c->number)
                    : ovr_flat_texts(rows, c->name, where, c->text);
    return good && (!c->zip || ovr_flat_note(rows, c->name, "zip", c->zip));
}

static bool write_all(const ovr_table *t, const ovr_flat *rows,
                      ovr_arena *arena)
{
    const char **state = ovr_arena_take(arena, t->rows, sizeof *state, NULL);
    const char **name = ovr_arena_take(arena, t->rows, sizeof *name, NULL);
    bool good = state && name;
    for (size_t i = 0; good && i < t->rows; i++) {
        char text[OVR_STUDY_NAME];
        ovr_study_name(t->study, i, text, sizeof text);
        good = (name[i] = ovr_arena_text(arena, text, NULL)) != NULL;
    }
    good = good &&
           ovr_flat_texts(rows, "name", "name of the files of the case", name);
    for (size_t i = 0; good && i < t->rows; i++)
        state[i] = ovr_sweep_state_name(t->state[i]);
    good = good && ovr_flat_texts(rows, "status", "status of the case", state);
    for (size_t k = 0; good && k < t->keys; k++)
        good = write_key_variable(t, rows, k);
    for (size_t k = t->keys; good && k < t->columns; k++) {
        const ovr_table_column *c = &t->column[k];
        char about[160];
        explain(t, c->name, about, sizeof about);
        good = ovr_flat_numbers(rows, c->name, unit_of(c->name), about,
                                c->number);
    }
    return good;
}

/* True for a table of cases: it has the variables `case` and `status`, which a
 * result has not. */
ovr_status ovr_sweep_netcdf_ours(const char *path, ovr_error *err)
{
    ovr_h5_handler before = ovr_h5_quiet();
    bool exists = access(path, F_OK) == 0;
    hid_t access_list = ovr_h5_access();
    hid_t file = exists ? H5Fopen(path, H5F_ACC_RDONLY, access_list) : -1;
    bool ours = file >= 0 && H5Lexists(file, "case", H5P_DEFAULT) > 0 &&
                H5Lexists(file, "status", H5P_DEFAULT) > 0;
    if (file >= 0)
        H5Fclose(file);
    ovr_h5_drop(access_list);
    ovr_h5_restore(before);
    return ours || !exists ? OVR_OK
                           : ovr_fail(err, OVR_BAD_INPUT,
                                      "%s: exists and is not a table of "
                                      "cases; --force replaces it",
                                      path);
}

ovr_status ovr_sweep_write_netcdf(const ovr_table *t, const char *path,
                                  ovr_error *err)
{
    ovr_flat rows;
    ovr_arena arena = ovr_arena_make(&t->arena.allocator);
    ovr_h5_handler before = ovr_h5_quiet();
    char part[4500];
    bool good, made;
    snprintf(part, sizeof part, "%.4400s.%ld.part", path, (long)getpid());
    good = ovr_flat_begin(&rows, part, "case", "number of the case", t->rows,
                          &arena) &&
           write_all(t, &rows, &arena);
    made = rows.file >= 0;
    good = ovr_flat_end(&rows, part, t->study->path, good);
    ovr_arena_release(&arena);
    ovr_h5_restore(before);
    if (good && rename(part, path) == 0)
        return OVR_OK;
    unlink(part);
    return ovr_fail(err, made ? OVR_IO : OVR_BAD_INPUT, "%s: cannot be written",
                    path);
}

/* ------------------------------------------------------------------ Reading */

enum { MAX_BYTES = 1 << 26 };

ovr_table *ovr_table_make(const ovr_allocator *allocator, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_table *t = ovr_arena_take(&arena, 1, sizeof *t, err);
    if (t)
        t->arena = arena;
    return t;
}

void ovr_table_free(ovr_table *table)
{
    if (table) {
        ovr_rows_close(table->results);
        ovr_arena arena = table->arena;
        ovr_arena_release(&arena);
    }
}

size_t ovr_table_rows(const ovr_table *table)
{
    return table ? table->rows : 0;
}

const ovr_table_column *ovr_table_at(const ovr_table *table, size_t k)
{
    if (!table)
        return NULL;
    return k < table->columns ? &table->column[k] : NULL;
}

/* ---------------------------------------------------------------- From CSV */

static size_t count_lines(const char *text)
{
    size_t n = 0;
    for (; *text; text++)
        n += *text == '\n';
    return n;
}

/* Reads the header. The columns between `name` and `status` are the study's
 * keys. */
static ovr_status read_heads(ovr_table *t, char **at, const char **text[],
                             const char *path, ovr_error *err)
{
    bool last = false, varied = false;
    while (!last && t->columns < OVR_TABLE_COLUMNS) {
        size_t k = t->columns++;
        ovr_table_column *c = &t->column[k];
        t->number[k] = ovr_arena_take(&t->arena, t->rows, sizeof(double), err);
        text[k] = ovr_arena_take(&t->arena, t->rows, sizeof **text, err);
        if (!t->number[k] || !text[k])
            return OVR_NO_MEMORY;
        char *head = ovr_csv_cell(at, &last);
        const char *unit = ovr_csv_unit(head);
        *c = (ovr_table_column){head, unit, false, t->number[k], text[k], NULL};
        varied = varied && strcmp(c->name, "status") != 0;
        c->varied = varied;
        varied = varied || !strcmp(c->name, "name");
    }
    if (!last || t->columns < 3 || strcmp(t->column[0].name, "task") != 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is not the table of a study; 'overroll sweep "
                        "STUDY.ini --collect TABLE.csv' writes one",
                        path);
    return OVR_OK;
}

static void read_rows(ovr_table *t, char *at, const char **text[])
{
    size_t i = 0;
    for (; i < t->rows && *at; i++) {
        bool last = false;
        for (size_t k = 0; !last; k++) {
            char *cell = ovr_csv_cell(&at, &last);
            double value;
            if (k >= t->columns)
                continue;
            if (!ovr_number((ovr_line){cell, strlen(cell), 0}, false, &value))
                value = NAN;
            t->number[k][i] = value;
            text[k][i] = cell;
        }
    }
    t->rows = i;
}

static ovr_table *read_csv(const char *path, ovr_error *err)
{
    ovr_table *t = ovr_table_make(NULL, err);
    const char **cells[OVR_TABLE_COLUMNS] = {NULL};
    const char *text =
        t ? ovr_text_file(path, "table", MAX_BYTES, &t->arena, err) : NULL;
    char *at;
    ovr_status status = text ? OVR_OK : OVR_BAD_INPUT;
    if (!status) {
        at = ovr_arena_text(&t->arena, text, err);
        t->rows = count_lines(text);
        status = at ? read_heads(t, &at, cells, path, err) : OVR_NO_MEMORY;
        if (!status)
            read_rows(t, at, cells);
    }
    if (!status)
        return t;
    ovr_table_free(t);
    return NULL;
}

/* ------------------------------------------------------------- From netCDF */

/* True if `about` is a varied key, section.key. */
static bool is_place(const char *about)
{
    return about && strchr(about, '.') && !strchr(about, ' ');
}

static bool add_variable(ovr_table *t, ovr_container *c, const ovr_link *link)
{
    ovr_table_column *to = &t->column[t->columns];
    const char *about = ovr_container_text(c, link->object, "long_name");
    const char *unit = ovr_container_text(c, link->object, "units");
    const char *zip = ovr_container_text(c, link->object, "zip");
    double *number = ovr_arena_take(&t->arena, t->rows, sizeof *number, NULL);
    const char **text = NULL;
    ovr_dataset set;
    size_t rows = 0;
    bool good = number != NULL;
    if (ovr_container_dataset(c, link->object, &set)) {
        good = good && set.rank == 1 && set.shape[0] == t->rows &&
               ovr_container_values(c, &set, 0, t->rows, number);
    } else {
        text = ovr_container_texts(c, link->object, &rows);
        good = good && text && rows == t->rows;
        for (size_t i = 0; good && i < rows; i++)
            number[i] = NAN;
    }
    *to = (ovr_table_column){ovr_arena_text(&t->arena, link->name, NULL),
                             unit && strcmp(unit, "1") != 0
                                 ? ovr_escaped(unit, false, &t->arena)
                                 : "",
                             is_place(about),
                             number,
                             text,
                             zip ? ovr_escaped(zip, false, &t->arena) : NULL};
    t->columns++;
    return good && to->name && to->unit;
}

static bool find_axis(ovr_container *c, const char *name, ovr_dataset *axis)
{
    uint64_t object;
    return ovr_container_find(c, c->root, name, &object) &&
           ovr_container_dataset(c, object, axis) && axis->rank == 1 &&
           axis->shape[0] <= c->source.bytes;
}

/* Reads all variables. Their dimension is `case`, whose numbers are not read,
 * or `pass`. Groups of a file of passes are `case` and `summary`. */
static bool read_variables(ovr_table *t, ovr_container *c)
{
    ovr_dataset axis;
    size_t count;
    bool passes = find_axis(c, "pass", &axis);
    bool good = passes || find_axis(c, "case", &axis);
    ovr_link *links = good ? ovr_container_links(c, c->root, &count) : NULL;
    if (!links || count > OVR_TABLE_COLUMNS)
        return false;
    t->rows = (size_t)axis.shape[0];
    for (size_t k = 0; good && k < count; k++)
        good = strcmp(links[k].name, "case") == 0 ||
               (passes && strcmp(links[k].name, "summary") == 0) ||
               add_variable(t, c, &links[k]);
    if (passes && good && t->columns)
        t->column[0].varied = true;
    return good;
}

/* Reads a netCDF table; its texts remain in the container's memory. */
static ovr_table *read_netcdf(const char *path, ovr_error *err)
{
    ovr_table *t = ovr_table_make(NULL, err);
    ovr_container c;
    int fd = t ? open(path, O_RDONLY | O_CLOEXEC) : -1;
    bool good = fd >= 0 &&
                ovr_container_open(&c, fd, &t->arena) == OVR_FOUND_CONTAINER &&
                read_variables(t, &c);
    if (t && fd < 0)
        ovr_fail(err, OVR_BAD_INPUT, "%s: %s", path, strerror(errno));
    else if (!good && t)
        ovr_fail(err, OVR_BAD_INPUT,
                 "%s: is not a table of passes or of a study; 'overroll "
                 "sweep STUDY.ini --collect TABLE.nc' writes one",
                 path);
    if (fd >= 0)
        close(fd);
    if (good)
        return t;
    ovr_table_free(t);
    return NULL;
}

static bool is_hdf5(const char *path)
{
    static const char begins[] = "\211HDF";
    char found[4];
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    bool is = fd >= 0 && read(fd, found, sizeof found) == sizeof found &&
              !memcmp(found, begins, sizeof found);
    if (fd >= 0)
        close(fd);
    return is;
}

ovr_table *ovr_table_read(const char *path, ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    size_t length = strlen(path);
    const char *end = path + (length > 3 ? length - 3 : 0);
    bool netcdf = strcmp(end, ".nc") == 0 || is_hdf5(path);
    return netcdf ? read_netcdf(path, err) : read_csv(path, err);
}
