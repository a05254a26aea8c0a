/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a study as a netCDF-4 file: one dimension, `case`, and a
 * variable over it for each value and each number of the summaries. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "results/flat_table.h"
#include "run/sweep_table.h"

/* Unit of a key of the summaries: it is in its name. */
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

/* Tells what a key of the summaries means, as far as the lists say. */
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
            snprintf(text, capacity, "%s%s",
                     run ? "at the end of the run: " : "", o->long_name);
}

static bool put_key(const ovr_table *t, const ovr_flat *rows, size_t k)
{
    const ovr_table_column *c = &t->column[k];
    const char *where = t->key[k]->where;
    bool good = ovr_table_numeric(c)
                    ? ovr_flat_numbers(rows, c->name, *c->unit ? c->unit : "1",
                                       where, c->number)
                    : ovr_flat_texts(rows, c->name, where, c->text);
    return good && (!c->zip || ovr_flat_note(rows, c->name, "zip", c->zip));
}

static bool put_all(const ovr_table *t, const ovr_flat *rows, ovr_arena *arena)
{
    const char **state = ovr_arena_take(arena, t->rows, sizeof *state, NULL);
    bool good = state &&
                ovr_flat_texts(rows, "name", "name of the case's files",
                               (const char *const *)t->study->name);
    for (size_t i = 0; good && i < t->rows; i++)
        state[i] = ovr_sweep_state_name(t->state[i]);
    good = good && ovr_flat_texts(rows, "status", "how the case stands", state);
    for (size_t k = 0; good && k < t->keys; k++)
        good = put_key(t, rows, k);
    for (size_t k = t->keys; good && k < t->columns; k++) {
        const ovr_table_column *c = &t->column[k];
        char about[160];
        explain(t, c->name, about, sizeof about);
        good = ovr_flat_numbers(rows, c->name, unit_of(c->name), about,
                                c->number);
    }
    return good;
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
           put_all(t, &rows, &arena);
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
