/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks the specification of a search: a key, its range, a condition on a
 * number of the run, and the folder for the results of only this search. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/disk.h"
#include "base/entries.h"
#include "base/error.h"
#include "base/given.h"
#include "base/lock.h"
#include "base/text.h"
#include "case/parameters.h"
#include "overroll/text.h"
#include "run/csv.h"
#include "run/find.h"
#include "run/find_table.h"
#include "run/internal.h"

/* -------------------------------------------------------- Table of the runs */

static const char heads[] =
    "value,quantity,order,level,converged,marked,seconds,message\n";

/* Reads the number before a comma at *text and moves *text past the comma. The
 * value of an empty cell is NAN. */
static bool read_cell(const char **text, double *value)
{
    *value = NAN;
    if (**text != ',' && !ovr_read_number(text, value))
        return false;
    return *(*text)++ == ',';
}

/* Reads a complete line; the last line of the file may be truncated. */
static bool read_row(char *line, ovr_find_evaluation *e, ovr_arena *arena)
{
    double cell[7] = {0};
    const char *at = line;
    size_t size = strcspn(line, "\n");
    if (!line[size])
        return false;
    line[size] = '\0';
    for (int k = 0; k < 7; k++)
        if (!read_cell(&at, &cell[k]))
            return false;
    *e = (ovr_find_evaluation){cell[0],      cell[1],
                               (int)cell[2], (int)cell[3],
                               cell[4] > 0,  (long)cell[5],
                               cell[6],      ovr_arena_text(arena, at, NULL)};
    return isfinite(e->value) && e->message;
}

static void write_row(FILE *to, const ovr_find_evaluation *e)
{
    ovr_csv_number(to, e->value, 17);
    fputc(',', to);
    ovr_csv_number(to, isfinite(e->quantity) ? e->quantity : NAN, 17);
    fprintf(to, ",%d,%d,%d,%ld,", e->order, e->level, e->converged, e->marked);
    ovr_csv_number(to, e->seconds, 17);
    fputc(',', to);
    for (const char *c = e->message; *c; c++)
        fputc(*c == ',' || *c == '"' || *c == '\n' ? ';' : *c, to);
    fputc('\n', to);
}

static ovr_status cannot(const ovr_find_table *t, ovr_status status,
                         ovr_error *err)
{
    return ovr_fail(err, status, "%s: cannot be written: %s", t->path,
                    strerror(errno));
}

/* Reads the complete rows of a file and truncates the file after them. */
static size_t read_rows(const ovr_find_table *t, ovr_arena *arena)
{
    FILE *from = t->file;
    char line[2048];
    size_t count = 0;
    long end = 0;
    if (fgets(line, sizeof line, from) && !strcmp(line, heads)) {
        end = ftell(from);
        while (count < t->maximum && fgets(line, sizeof line, from) &&
               read_row(line, &t->made[count], arena)) {
            count++;
            end = ftell(from);
        }
    }
    if (ftruncate(fileno(from), end) != 0 || fseek(from, end, SEEK_SET) != 0)
        return 0;
    if (end == 0)
        fputs(heads, from);
    return count;
}

/* Creates the table, or reads an existing table and appends to it. */
static ovr_status find_table_open(ovr_find_table *table, bool go_on, bool force,
                                  ovr_arena *arena, ovr_error *err)
{
    if (!force && ovr_file_ours(table->path, heads, err))
        return OVR_BAD_INPUT;
    table->file = go_on ? fopen(table->path, "r+") : NULL;
    if (table->file) {
        table->count = read_rows(table, arena);
    } else {
        table->file = fopen(table->path, "w");
        if (table->file)
            fputs(heads, table->file);
    }
    if (!table->file)
        return cannot(table, OVR_BAD_INPUT, err);
    return fflush(table->file) == 0 ? OVR_OK : cannot(table, OVR_IO, err);
}

ovr_status ovr_find_table_add(ovr_find_table *table,
                              const ovr_find_evaluation *one, ovr_error *err)
{
    if (!table->file)
        return OVR_OK;
    write_row(table->file, one);
    if (fflush(table->file) == 0 && fsync(fileno(table->file)) == 0)
        return OVR_OK;
    return cannot(table, OVR_IO, err);
}

static void find_table_close(ovr_find_table *table)
{
    if (table->file)
        fclose(table->file);
    table->file = NULL;
}

/* ----------------------------------------------------------------- Question */

enum { QUESTION_MAX = 1 << 20 };

/* --------------------------------------------------------- key and condition
 */

static bool row_of(const char *where, ovr_parameter_info *info)
{
    const char *dot = strrchr(where, '.');
    size_t section = strcspn(where, ". ");
    for (size_t k = 0; dot && k < ovr_parameter_count(); k++) {
        *info = ovr_parameter_at(k);
        if (strlen(info->section) == section &&
            !strncmp(info->section, where, section) &&
            !strcmp(info->key, dot + 1))
            return true;
    }
    return false;
}

/* Checks that the key is a single number and accepts both ends of the search
 * range. */
static ovr_status read_ends(ovr_find *f, ovr_error *err)
{
    const char *unit[2];
    double end[2];
    ovr_parameter_info row = {.bare = ""};
    bool known = row_of(f->info.key, &row);
    if (known && !strcmp(row.type, "whole number"))
        return ovr_fail_about(err, "key",
                              "%s: find cannot vary whole numbers; use a "
                              "study",
                              f->info.key);
    if (known && strcmp(row.type, "number") != 0)
        return ovr_fail_about(err, "key", "%s is a %s, not a number",
                              f->info.key, row.type);
    for (int k = 0; k < 2; k++) {
        const char *text = k ? f->how.high : f->how.low;
        unit[k] = ovr_amount_read(text, &end[k]);
        if (!unit[k] || !isfinite(end[k]))
            return ovr_fail_about(err, "between",
                                  "%s between '%.60s': must be a number",
                                  f->info.key, text);
    }
    if (*unit[0] && strcmp(unit[0], unit[1]) != 0)
        return ovr_fail_about(err, "between",
                              "%s between %s and %s: both ends must have the "
                              "same unit",
                              f->info.key, f->how.low, f->how.high);
    if (!(fabs(end[0] - end[1]) > 0))
        return ovr_fail_about(err, "between",
                              "%s between %s and %s: the ends must differ",
                              f->info.key, f->how.low, f->how.high);
    f->from = fmin(end[0], end[1]);
    f->to = fmax(end[0], end[1]);
    f->info.unit = *unit[1] || !known ? unit[1] : row.bare;
    char *suffix = ovr_arena_take(&f->arena, strlen(unit[1]) + 2, 1, err);
    if (!suffix)
        return OVR_NO_MEMORY;
    if (*unit[1])
        sprintf(suffix, " %s", unit[1]);
    f->suffix = suffix;
    return OVR_OK;
}

ovr_status ovr_find_set(const ovr_find *f, ovr_case *c, double x,
                        ovr_error *err)
{
    char text[120];
    for (int digits = 15; digits <= 17;
         digits++) { /* the fewest that suffice */
        snprintf(text, sizeof text, "%.*g%.60s", digits, x, f->suffix);
        if (strtod(text, NULL) == x)
            break;
    }
    return ovr_case_set(c, f->info.key, text, f->info.key, err);
}

static ovr_status try_ends(ovr_find *f, ovr_error *err)
{
    const double ends[] = {f->from, f->to};
    ovr_case *c = ovr_case_apart(f->base, err);
    ovr_status status = c ? OVR_OK : OVR_BAD_INPUT;
    for (int k = 0; k < 2 && !status; k++)
        status = ovr_find_set(f, c, ends[k], err);
    ovr_case_free(c);
    return status;
}

/* All runs of a search must have the same level. */
static ovr_status check_level(const ovr_find *f, ovr_error *err)
{
    const char *key = "domain.level";
    ovr_case_entry e;
    if (f->info.exact || !ovr_case_entry_of(f->base, key, strlen(key), &e) ||
        !e.applies || !e.text || strcmp(e.text, "auto") != 0)
        return OVR_OK;
    return ovr_fail_about(err, "level",
                          "level = auto may differ from run to run; set "
                          "domain.level");
}

static ovr_status read_condition(ovr_find *f, ovr_error *err)
{
    const char *which = f->how.which;
    ovr_comparison said;
    if (ovr_comparison_read(f->how.condition, &said, &f->arena, err))
        return OVR_BAD_INPUT;
    f->info.quantity = said.quantity;
    f->info.sense = said.sense;
    f->info.target = said.target;
    if (which && strcmp(which, "largest") != 0 &&
        strcmp(which, "smallest") != 0)
        return ovr_fail_about(err, "which",
                              "'%.40s' must be largest or smallest", which);
    if (which && !said.sense)
        return ovr_fail_about(err, "which",
                              "%s %s: the condition '%s' must contain at most "
                              "or at least",
                              which, f->info.key, f->how.condition);
    if (!which && said.sense)
        return ovr_fail_about(err, "which",
                              "largest or smallest is missing before %s: the "
                              "condition '%s' holds in a range",
                              f->info.key, f->how.condition);
    return OVR_OK;
}

/* ---------------------------------------------------------------- creation */

static ovr_status copy_options(ovr_find *f, const ovr_find_options *options,
                               ovr_error *err)
{
    ovr_find_options *o = &f->how;
    const char **const texts[] = {&o->key,       &o->low,   &o->high,
                                  &o->condition, &o->which, &o->table,
                                  &o->results};
    if (OVR_TAKE(ovr_find_options, o, options, err))
        return OVR_BAD_INPUT;
    if (!o->key || !o->low || !o->high || !o->condition)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "find needs a key, both ends of its range and a "
                        "condition");
    if (o->tolerance != 0 && !(o->tolerance >= 1e-9 && o->tolerance <= 0.5))
        return ovr_fail_about(err, "tolerance",
                              "tolerance: must be 1e-9 to 0.5");
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        if (*texts[k] &&
            !(*texts[k] = ovr_arena_text(&f->arena, *texts[k], err)))
            return OVR_NO_MEMORY;
    return OVR_OK;
}

/* Returns the case and the search as text, for comparison with the text stored
 * in the results' folder. */
static char *question_of(ovr_find *f, ovr_error *err)
{
    const ovr_find_options *o = &f->how;
    const char *text = ovr_case_text(f->base, err);
    size_t capacity = (text ? strlen(text) : 0) + 2000;
    char *all = text ? ovr_arena_take(&f->arena, capacity, 1, err) : NULL;
    if (all)
        snprintf(all, capacity,
                 "%s# find %.20s %.300s between %.100s and %.100s so that "
                 "%.400s%s\n",
                 text, o->which ? o->which : "", o->key, o->low, o->high,
                 o->condition, o->steady ? ", steady" : "");
    return all;
}

/* Locks the folder until the search is freed. Otherwise two searches would use
 * each other's runs, and their answers would depend on the order. */
static ovr_status lock_folder(ovr_find *f, const char *folder, ovr_error *err)
{
    size_t capacity = strlen(folder) + 40;
    char *path = ovr_arena_take(&f->arena, capacity, 1, err);
    if (!path)
        return OVR_NO_MEMORY;
    snprintf(path, capacity, "%s/question.lock", folder);
    int fd = open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (fd < 0)
        return ovr_fail_about(err, "results", "%s: cannot be written: %s", path,
                              strerror(errno));
    f->lock = fd + 1;
    if (ovr_lock_file(fd, false) == EWOULDBLOCK)
        return ovr_fail_about(err, "results",
                              "%s: another find uses this folder; wait until "
                              "it ends or set another folder",
                              folder);
    return OVR_OK;
}

/* Opens the folder of results, which holds results of only one search. */
static ovr_status open_results(ovr_find *f, ovr_error *err)
{
    const char *folder = f->how.results;
    size_t capacity = strlen(folder) + 40;
    char *path = ovr_arena_take(&f->arena, capacity, 1, err);
    char *table = ovr_arena_take(&f->arena, capacity, 1, err);
    char *asked = path && table ? question_of(f, err) : NULL;
    const char *found = NULL;
    if (!asked)
        return OVR_NO_MEMORY;
    snprintf(path, capacity, "%s/question.ini", folder);
    snprintf(table, capacity, "%s/find.csv", folder);
    if (mkdir(folder, 0777) != 0 && errno != EEXIST)
        return ovr_fail_about(err, "results", "%s: cannot be created: %s",
                              folder, strerror(errno));
    if (lock_folder(f, folder, err))
        return OVR_BAD_INPUT;
    if (access(path, F_OK) == 0) {
        found = ovr_text_file(path, "question", QUESTION_MAX, &f->arena, err);
        if (!found)
            return OVR_BAD_INPUT;
        if (strcmp(found, asked) != 0)
            return ovr_fail_about(err, "results",
                                  "%s: contains results of another question "
                                  "or case (question.ini); use another folder",
                                  folder);
    } else {
        FILE *to = fopen(path, "w");
        bool good = to && fputs(asked, to) >= 0;
        if (to && fclose(to) != 0)
            good = false;
        if (!good)
            return ovr_fail_about(err, "results", "%s: cannot be written: %s",
                                  path, strerror(errno));
    }
    if (!f->how.table) {
        f->how.table = table;
        f->how.go_on = true;
    }
    return OVR_OK;
}

static ovr_status name_quantity(ovr_find_info *i, ovr_arena *arena,
                                ovr_error *err)
{
    const ovr_quantity_name name = ovr_quantity_named(i->quantity);
    i->name = ovr_arena_text(arena, name.text, err);
    i->quantity_unit = name.unit;
    return i->name ? OVR_OK : OVR_NO_MEMORY;
}

static ovr_status prepare(ovr_find *f, ovr_case *c,
                          const ovr_find_options *options, ovr_error *err)
{
    ovr_find_info *i = &f->info;
    const char *quantity;
    ovr_status status = copy_options(f, options, err);
    *i = (ovr_find_info){.message = f->message};
    i->value = i->at_value = i->low = i->high = NAN;
    i->slope = i->error = i->scatter = NAN;
    i->key = f->how.key;
    i->which = f->how.which;
    if (status)
        return status;
    f->made = ovr_arena_take(&f->arena, OVR_FIND_MAX, sizeof *f->made, err);
    f->base = f->made ? ovr_case_apart(c, err) : NULL;
    if (!f->base)
        return OVR_NO_MEMORY;
    if (read_ends(f, err) || try_ends(f, err))
        return OVR_BAD_INPUT;
    quantity = ovr_comparison_quantity(f->how.condition, &f->arena, err);
    if (!quantity || ovr_find_quantity(f, quantity, err) ||
        read_condition(f, err) || check_level(f, err))
        return OVR_BAD_INPUT;
    if (name_quantity(i, &f->arena, err))
        return OVR_NO_MEMORY;
    if (f->how.results && open_results(f, err))
        return OVR_BAD_INPUT;
    if (!f->how.table)
        return OVR_OK;
    f->table = (ovr_find_table){
        .path = f->how.table, .made = f->made, .maximum = OVR_FIND_MAX};
    status = find_table_open(&f->table, f->how.go_on, f->how.force, &f->arena,
                             err);
    i->evaluations = f->table.count;
    for (size_t k = 0; k < i->evaluations; k++)
        i->marked = i->marked || f->made[k].marked > 0;
    return status;
}

ovr_find *ovr_find_create(ovr_case *c, const ovr_find_options *options,
                          ovr_error *err)
{
    if (!c || !options)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_find *f = ovr_arena_take(&arena, 1, sizeof *f, err);
    if (!f)
        return NULL;
    f->arena = arena;
    f->table.file = NULL;
    if (prepare(f, c, options, err)) {
        ovr_find_free(f);
        return NULL;
    }
    return f;
}

void ovr_find_free(ovr_find *find)
{
    if (!find)
        return;
    find_table_close(&find->table);
    if (find->lock)
        close(find->lock - 1);
    ovr_case_free(find->base);
    ovr_arena arena = find->arena;
    ovr_arena_release(&arena);
}
