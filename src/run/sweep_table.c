/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/sweep_table.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/given.h"
#include "base/text.h"
#include "case/case.h"
#include "results/results.h"
#include "run/csv.h"
#include "run/run.h"
#include "run/trials.h"

enum { PATH_CAPACITY = 4400 };

/* -------------------------------------------------------------- summaries */

static double *new_numbers(ovr_table *t, ovr_error *err)
{
    double *values = ovr_arena_take(&t->arena, t->rows, sizeof *values, err);
    for (size_t i = 0; values && i < t->rows; i++)
        values[i] = NAN;
    return values;
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
static void take_number(ovr_table *t, size_t task, const char *name,
                        double value, ovr_error *err)
{
    const ovr_table_column *c = ovr_table_summary(t, name);
    if (!c && t->columns < OVR_TABLE_COLUMNS) {
        double *number = new_numbers(t, err);
        name = number ? ovr_arena_text(&t->arena, name, err) : NULL;
        if (name)
            c = &t->column[t->columns++];
        if (name)
            t->column[t->columns - 1] = (ovr_table_column){
                .name = name, .unit = "", .number = number};
    }
    if (c)
        ((double *)c->number)[task] = value;
}

/* `  "key": value,` of our own JSON, not of objects inside: the number, NAN for
 * null; false for what is no number. */
static bool read_pair(const char *line, char *key, size_t capacity,
                      double *value)
{
    const char *from = line + 2, *end, *text;
    if (strncmp(line, "  \"", 3) != 0 || !(end = strchr(from + 1, '"')) ||
        strncmp(end, "\": ", 3) != 0)
        return false;
    snprintf(key, capacity, "%.*s", (int)(end - from - 1), from + 1);
    text = end + 3;
    *value = NAN;
    if (!strncmp(text, "null", 4))
        return true;
    *value = strncmp(text, "true", 4) == 0;
    if (!strncmp(text, "true", 4) || !strncmp(text, "false", 5))
        return true;
    return ovr_read_number(&text, value);
}

/* Reads from the result file; false: there is none, or none with a summary. */
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
    line = result ? ovr_result_attributes(result, "summary", &count) : NULL;
    for (size_t k = 0; k < count; k++)
        take_number(t, task, line[k].name, line[k].number, err);
    if (count) {
        const ovr_result_info *about = ovr_result_about(result);
        take_number(t, task, "snapshots", (double)about->snapshots, err);
        take_number(t, task, "seconds", about->seconds, err);
    }
    ovr_result_close(result);
    return count > 0;
}

/* Reads the JSON of a task, which studies without result files have. */
static void read_json(ovr_table *t, size_t task, ovr_error *err)
{
    char path[PATH_CAPACITY], line[512], key[64];
    double value;
    FILE *from;
    ovr_study_file(t->study, task, ".json", path, sizeof path);
    from = fopen(path, "r");
    while (from && fgets(line, sizeof line, from))
        if (read_pair(line, key, sizeof key, &value))
            take_number(t, task, key, value, err);
    if (from)
        fclose(from);
}

/* The summaries repeat some keys of the study (M, L): those give way. */
static bool is_taken(const ovr_table *t, const char *name)
{
    for (size_t k = 0; k < t->keys; k++)
        if (!strcmp(t->column[k].name, name))
            return true;
    return !strcmp(name, "case") || !strcmp(name, "name") ||
           !strcmp(name, "status");
}

/* A key that no case has a number for (a text) makes no column. */
static void drop_columns(ovr_table *t)
{
    size_t kept = t->keys;
    for (size_t k = t->keys; k < t->columns; k++) {
        bool any = false;
        if (is_taken(t, t->column[k].name))
            continue;
        for (size_t i = 0; i < t->rows && !any; i++)
            any = !isnan(t->column[k].number[i]);
        if (any)
            t->column[kept++] = t->column[k];
    }
    t->columns = kept;
}

/* ------------------------------------------------------------------- keys */

static ovr_status add_key(ovr_table *t, const ovr_study_key *key,
                          ovr_error *err)
{
    const char **text = ovr_arena_take(&t->arena, t->rows, sizeof *text, err);
    const ovr_table_column c = {
        .name = ovr_arena_text(&t->arena, key->shown, err),
        .unit = "",
        .varied = true,
        .number = new_numbers(t, err),
        .text = text,
        .zip = key->zip ? ovr_arena_text(&t->arena, key->zip_name, err) : NULL};
    for (size_t i = 0; text && i < t->rows; i++) {
        text[i] = ovr_arena_text(&t->arena, ovr_study_value(t->study, key, i),
                                 err);
        if (!text[i])
            return OVR_NO_MEMORY;
    }
    if (!text || !c.name || !c.number || (key->zip && !c.zip))
        return OVR_NO_MEMORY;
    t->key[t->keys++] = key;
    t->column[t->columns++] = c;
    return OVR_OK;
}

bool ovr_table_numeric(const ovr_table_column *key)
{
    return !isnan(key->number[0]);
}

/* Stores the key's number in a task; returns false if its value is no number.
 */
static bool take_value(ovr_table *t, size_t k, const ovr_case *c, size_t task)
{
    const char *where = t->key[k]->where;
    ovr_case_entry e;
    if (!ovr_case_entry_of(c, where, strlen(where), &e))
        return false;
    ((double *)t->column[k].number)[task] = e.number;
    if (e.unit && strcmp(e.unit, "1") != 0)
        t->column[k].unit = e.unit;
    return isfinite(ovr_parameter_at(e.parameter).minimum) &&
           isfinite(e.number);
}

/* Adds the columns of the keys.  A key whose value is no number in some task
 * has no numbers in any. */
static ovr_status take_keys(ovr_table *t, ovr_error *err)
{
    const ovr_study *s = t->study;
    bool none[OVR_STUDY_MAX_KEYS] = {false};
    for (size_t k = 0; k < s->keys; k++)
        if (!s->key[k].fixed && add_key(t, &s->key[k], err))
            return OVR_NO_MEMORY;
    for (size_t i = 0; i < t->rows; i++) {
        ovr_case *c = ovr_study_case(s, i, err);
        for (size_t k = 0; c && k < t->keys; k++)
            none[k] |= !take_value(t, k, c, i);
        ovr_case_free(c);
    }
    for (size_t k = 0; k < t->keys; k++)
        for (size_t i = 0; none[k] && i < t->rows; i++)
            ((double *)t->column[k].number)[i] = NAN;
    return OVR_OK;
}

/* ------------------------------------------------------------------ table */

static ovr_status gather(ovr_table *t, ovr_error *err)
{
    const ovr_study *s = t->study;
    ovr_sweep_state *state = ovr_arena_take(&t->arena, s->tasks, sizeof *state,
                                            err);
    t->rows = s->tasks;
    t->state = state;
    if (!state || take_keys(t, err))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < s->tasks; i++) {
        state[i] = ovr_sweep_state_of(s, i);
        t->count[state[i]]++;
        if (state[i] == OVR_SWEEP_FINISHED && !read_result(t, i, err))
            read_json(t, i, err);
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

/* -------------------------------------------------------------------- CSV */

/* Takes what was extreme in runs in time, of steady solutions these. */
static bool is_main(const ovr_table *t, const char *name)
{
    static const char *const names[] = {"P_max_overall",   "P_max_overall_Pa",
                                        "T_P_max",         "H_min_overall",
                                        "H_min_overall_m", "T_H_min",
                                        "load_error_max",  "steps_marked",
                                        "seconds",         "H_min",
                                        "min_film_m",      "H_cen",
                                        "central_film_m",  "P_max",
                                        "max_pressure_Pa"};
    size_t maximum = sizeof names / sizeof names[0];
    if (ovr_table_summary(t, "P_max_overall"))
        maximum -= 6;
    for (size_t i = 0; i < maximum; i++)
        if (!strcmp(names[i], name))
            return true;
    return false;
}

/* Puts a key with the unit of its numbers; the manifest's values have their
 * own. */
static void put_key(const ovr_table_column *c, FILE *to, bool manifest)
{
    char head[200];
    bool pure = manifest || !ovr_table_numeric(c) || !*c->unit;
    snprintf(head, sizeof head, "%.140s%s%s%s", c->name, pure ? "" : " [",
             pure ? "" : c->unit, pure ? "" : "]");
    ovr_csv_text(to, head);
}

static void put_heads(const ovr_table *t, FILE *to, bool manifest)
{
    fputs("task,name", to);
    for (size_t k = 0; k < t->keys; k++) {
        fputc(',', to);
        put_key(&t->column[k], to, manifest);
    }
    fputs(manifest ? ",status,output,summary" : ",status", to);
    for (size_t k = t->keys; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name))
            fprintf(to, ",%s", t->column[k].name);
    fputs(manifest ? ",message\n" : "\n", to);
}

/* A file of the task, when it is there. */
static void put_file(const ovr_table *t, size_t task, const char *ending,
                     FILE *to)
{
    char path[PATH_CAPACITY];
    fputc(',', to);
    ovr_study_file(t->study, task, ending, path, sizeof path);
    if (access(path, F_OK) == 0)
        ovr_csv_text(to, strrchr(path, '/') + 1);
}

static void put_row(const ovr_table *t, size_t i, FILE *to, bool manifest)
{
    char message[1100];
    fprintf(to, "%zu,", i + 1);
    ovr_csv_text(to, t->study->name[i]);
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
        put_file(t, i, ".h5", to);
        put_file(t, i, ".json", to);
    }
    for (size_t k = t->keys; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name)) {
            fputc(',', to);
            ovr_csv_number(to, t->column[k].number[i], manifest ? 6 : 17);
        }
    if (manifest) {
        ovr_sweep_message(t->study, i, message, sizeof message);
        fputc(',', to);
        ovr_csv_text(to, message);
    }
    fputc('\n', to);
}

/* Written beside and renamed: whoever reads it finds a whole one. */
ovr_status ovr_sweep_write_csv(const ovr_table *t, const char *path,
                               bool manifest, ovr_error *err)
{
    char part[PATH_CAPACITY + 32];
    snprintf(part, sizeof part, "%s.%ld.part", path, (long)getpid());
    unlink(part);
    FILE *to = fopen(part, "wx"); /* follows no link put there by somebody */
    if (to) {
        put_heads(t, to, manifest);
        for (size_t i = 0; i < t->rows; i++)
            put_row(t, i, to, manifest);
    }
    ovr_status status = ovr_csv_end(to, path, err);
    if (!status && rename(part, path) == 0)
        return OVR_OK;
    unlink(part);
    return status ? status
                  : ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                             strerror(errno));
}
