/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "run/sweep_table.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "case/case.h"
#include "results/results.h"
#include "run/run.h"
#include "run/trials.h"

enum { PATH_CAPACITY = 4400 };

/* -------------------------------------------------------------- summaries */

static double *new_numbers(ovr_sweep_table *t, ovr_error *err)
{
    double *values = ovr_arena_take(&t->arena, t->s->tasks, sizeof *values,
                                    err);
    for (size_t i = 0; values && i < t->s->tasks; i++)
        values[i] = NAN;
    return values;
}

/* The column of this name, made when it is new; NULL: no space. */
static ovr_sweep_column *column_of(ovr_sweep_table *t, const char *name,
                                   ovr_error *err)
{
    ovr_sweep_column *c;
    for (size_t i = 0; i < t->columns; i++)
        if (!strcmp(t->column[i].name, name))
            return &t->column[i];
    if (t->columns == OVR_SWEEP_MAX_NUMBERS)
        return NULL;
    c = &t->column[t->columns];
    snprintf(c->name, sizeof c->name, "%.47s", name);
    c->value = new_numbers(t, err);
    t->columns += c->value != NULL;
    return c->value ? c : NULL;
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

static void take_number(ovr_sweep_table *t, size_t task, const char *name,
                        double value, ovr_error *err)
{
    ovr_sweep_column *c = column_of(t, name, err);
    if (c)
        c->value[task] = value;
}

/* Reads from the result file; false: there is none, or none with a summary. */
static bool read_result(ovr_sweep_table *t, size_t task, ovr_error *err)
{
    char path[PATH_CAPACITY];
    ovr_result *result;
    const ovr_group_attribute *line;
    size_t count = 0;
    ovr_study_file(t->s, task, ".h5", path, sizeof path);
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

/* Reads from the JSON beside it, for studies without result files, and those
 * that older versions ran. */
static void read_json(ovr_sweep_table *t, size_t task, ovr_error *err)
{
    char path[PATH_CAPACITY], line[512], key[64];
    double value;
    FILE *from;
    ovr_study_file(t->s, task, ".json", path, sizeof path);
    from = fopen(path, "r");
    while (from && fgets(line, sizeof line, from))
        if (read_pair(line, key, sizeof key, &value))
            take_number(t, task, key, value, err);
    if (from)
        fclose(from);
}

/* The summaries repeat some keys of the study (M, L): those give way. */
static bool is_taken(const ovr_sweep_table *t, const char *name)
{
    for (size_t k = 0; k < t->keys; k++)
        if (!strcmp(t->values[k].key->shown, name))
            return true;
    return !strcmp(name, "case") || !strcmp(name, "name") ||
           !strcmp(name, "status");
}

/* A key that no case has a number for (a text) makes no column. */
static void drop_columns(ovr_sweep_table *t)
{
    size_t kept = 0;
    for (size_t k = 0; k < t->columns; k++) {
        bool any = false;
        if (is_taken(t, t->column[k].name))
            continue;
        for (size_t i = 0; i < t->s->tasks && !any; i++)
            any = !isnan(t->column[k].value[i]);
        if (any)
            t->column[kept++] = t->column[k];
    }
    t->columns = kept;
}

/* ----------------------------------------------------------------- values */

static void take_value(ovr_sweep_values *v, const ovr_case *c, size_t task)
{
    ovr_case_entry e;
    if (!ovr_case_entry_of(c, v->key->where, strlen(v->key->where), &e)) {
        v->numeric = false;
        return;
    }
    v->number[task] = e.number;
    v->numeric = v->numeric &&
                 isfinite(ovr_parameter_at(e.parameter).minimum) &&
                 isfinite(e.number);
    if (e.unit)
        v->unit = e.unit;
}

static ovr_status take_values(ovr_sweep_table *t, ovr_error *err)
{
    const ovr_study *s = t->s;
    for (size_t k = 0; k < s->keys; k++) {
        ovr_sweep_values *v = &t->values[t->keys];
        if (s->key[k].fixed)
            continue;
        *v = (ovr_sweep_values){&s->key[k], true, "1", new_numbers(t, err)};
        if (!v->number)
            return OVR_NO_MEMORY;
        t->keys++;
    }
    for (size_t i = 0; i < s->tasks; i++) {
        ovr_case *c = ovr_study_case(s, i, err);
        for (size_t k = 0; c && k < t->keys; k++)
            take_value(&t->values[k], c, i);
        ovr_case_free(c);
    }
    return OVR_OK;
}

/* ------------------------------------------------------------------ table */

ovr_status ovr_sweep_gather(const ovr_study *s, ovr_sweep_table *t,
                            ovr_error *err)
{
    memset(t, 0, sizeof *t);
    t->s = s;
    t->arena = ovr_arena_make(&s->arena.allocator);
    t->state = ovr_arena_take(&t->arena, s->tasks, sizeof *t->state, err);
    if (!t->state || take_values(t, err))
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < s->tasks; i++) {
        t->state[i] = ovr_sweep_state_of(s, i);
        t->count[t->state[i]]++;
        if (t->state[i] == OVR_SWEEP_FINISHED && !read_result(t, i, err))
            read_json(t, i, err);
    }
    drop_columns(t);
    return OVR_OK;
}

void ovr_sweep_table_free(ovr_sweep_table *table)
{
    ovr_arena_release(&table->arena);
}

/* -------------------------------------------------------------------- CSV */

/* RFC 4180: in quotes what holds a comma or a quote. */
static void put_text(FILE *to, const char *text)
{
    if (!text[strcspn(text, ",\"\n")]) {
        fputs(text, to);
        return;
    }
    fputc('"', to);
    for (; *text; text++) {
        if (*text == '"')
            fputc('"', to);
        fputc(*text, to);
    }
    fputc('"', to);
}

static void put_number(FILE *to, double value, int digits)
{
    if (!isnan(value))
        fprintf(to, "%.*g", digits, value);
}

/* Takes what was extreme in runs in time, of steady solutions these. */
static bool is_main(const ovr_sweep_table *t, const char *name)
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
    for (size_t i = 0; i < t->columns; i++)
        if (!strcmp(t->column[i].name, "P_max_overall"))
            maximum -= 6;
    for (size_t i = 0; i < maximum; i++)
        if (!strcmp(names[i], name))
            return true;
    return false;
}

/* Puts a key with the unit of its numbers; the manifest's values have their
 * own. */
static void put_key(const ovr_sweep_values *v, FILE *to, bool manifest)
{
    char head[200];
    bool pure = manifest || !v->numeric || !strcmp(v->unit, "1");
    snprintf(head, sizeof head, "%.140s%s%s%s", v->key->shown, pure ? "" : " [",
             pure ? "" : v->unit, pure ? "" : "]");
    put_text(to, head);
}

static void put_heads(const ovr_sweep_table *t, FILE *to, bool manifest)
{
    fputs("task,name", to);
    for (size_t k = 0; k < t->keys; k++) {
        fputc(',', to);
        put_key(&t->values[k], to, manifest);
    }
    fputs(manifest ? ",status,output,summary" : ",status", to);
    for (size_t k = 0; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name))
            fprintf(to, ",%s", t->column[k].name);
    fputs(manifest ? ",message\n" : "\n", to);
}

/* A file of the task, when it is there. */
static void put_file(const ovr_sweep_table *t, size_t task, const char *ending,
                     FILE *to)
{
    char path[PATH_CAPACITY];
    fputc(',', to);
    ovr_study_file(t->s, task, ending, path, sizeof path);
    if (access(path, F_OK) == 0)
        put_text(to, strrchr(path, '/') + 1);
}

static void put_row(const ovr_sweep_table *t, size_t i, FILE *to, bool manifest)
{
    char message[1100];
    fprintf(to, "%zu,", i + 1);
    put_text(to, t->s->name[i]);
    for (size_t k = 0; k < t->keys; k++) {
        fputc(',', to);
        if (manifest || !t->values[k].numeric)
            put_text(to, ovr_study_value(t->s, t->values[k].key, i));
        else
            put_number(to, t->values[k].number[i], 17);
    }
    fprintf(to, ",%s", ovr_sweep_state_name(t->state[i]));
    if (manifest) {
        put_file(t, i, ".h5", to);
        put_file(t, i, ".json", to);
    }
    for (size_t k = 0; k < t->columns; k++)
        if (!manifest || is_main(t, t->column[k].name)) {
            fputc(',', to);
            put_number(to, t->column[k].value[i], manifest ? 6 : 17);
        }
    if (manifest) {
        ovr_sweep_message(t->s, i, message, sizeof message);
        fputc(',', to);
        put_text(to, message);
    }
    fputc('\n', to);
}

/* Written beside and renamed: whoever reads it finds a whole one. */
ovr_status ovr_sweep_write_csv(const ovr_sweep_table *t, const char *path,
                               bool manifest, ovr_error *err)
{
    char part[PATH_CAPACITY + 32];
    FILE *to;
    bool good;
    snprintf(part, sizeof part, "%s.%ld.part", path, (long)getpid());
    unlink(part);
    to = fopen(part, "wx"); /* follows no link that somebody has put there */
    if (!to)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: cannot be written: %s", path,
                        strerror(errno));
    put_heads(t, to, manifest);
    for (size_t i = 0; i < t->s->tasks; i++)
        put_row(t, i, to, manifest);
    good = !ferror(to);
    good = fclose(to) == 0 && good;
    if (good && rename(part, path) == 0)
        return OVR_OK;
    unlink(part);
    return ovr_fail(err, OVR_IO, "%s: cannot be written: %s", path,
                    strerror(errno));
}
