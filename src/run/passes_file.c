/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The file of all passes: a netCDF-4 file with one dimension, `pass`, a row for
 * each pass, the names of their files, and the case. It is small and is always
 * rewritten completely. Its columns are the quantities with a PASS in their row
 * and those of pass_columns. The printed table has the columns with a
 * PASS_HEAD, from left to right.
 */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case/case.h"
#include "case/setup.h"
#include "overroll/run.h"
#include "results/flat_table.h"
#include "results/hdf5read/hdf5read.h"
#include "results/header.h"
#include "results/layout.h"
#include "run/pass_series.h"

/* ------------------------------------------------------------------ Columns */

static const ovr_pass_column beside[OVR_PASS_BESIDE] = {
    [OVR_PASS_LOST] = {.name = "oil_lost",
                       .long_name = "lubricant loss between passes",
                       .kind = OVR_KIND_FLOW,
                       .place = 5,
                       .head = "lost"},
    [OVR_PASS_STEPS] = {.name = "steps",
                        .long_name = "time steps",
                        .kind = OVR_KIND_COUNT},
    [OVR_PASS_FILM_ERROR] = {.name = "central_film_thickness_error",
                             .long_name = "estimated discretization error of "
                                          "the mean central film thickness",
                             .kind = OVR_KIND_HEIGHT},
    [OVR_PASS_MIN_ERROR] =
        {.name = "min_film_thickness_error",
         .long_name =
             "estimated discretization error of the minimum film thickness",
         .kind = OVR_KIND_HEIGHT},
    [OVR_PASS_PRESSURE_ERROR] =
        {.name = "max_pressure_error",
         .long_name = "estimated discretization error of the maximum pressure",
         .kind = OVR_KIND_PRESSURE},
    [OVR_PASS_MENISCUS_ERROR] =
        {.name = "meniscus_error",
         .long_name =
             "estimated discretization error of the inlet meniscus position",
         .kind = OVR_KIND_LENGTH},
    [OVR_PASS_LENGTH] = {.name = "equivalent_length",
                         .long_name = "equivalent raceway length",
                         .kind = OVR_KIND_LENGTH,
                         .place = 11,
                         .head = "length",
                         .with = OVR_PHYSICS_PLASTIC},
    [OVR_PASS_RISK] = {.name = "risk_smooth",
                       .long_name = "fatigue risk per length of smooth raceway",
                       .kind = OVR_KIND_NUMBER},
    [OVR_PASS_RATIO] = {.name = "life_ratio",
                        .long_name = "life ratio, passes like this one only",
                        .kind = OVR_KIND_NUMBER},
    [OVR_PASS_TOGETHER] = {
        .name = "life_ratio_together",
        .long_name = "life ratio, for repetitions of all passes up to this "
                     "one",
        .kind = OVR_KIND_NUMBER}};

/* Names a column. A mean, a final value, or the only statistic of a quantity
 * has the quantity's name and heading. */
static void name(const ovr_observable *row, unsigned how, ovr_pass_column *to)
{
    bool second = row->pass & OVR_PASS_MEAN;
    const char *before = "", *behind = "mean over the pass";
    to->place = row->pass_place;
    to->head = row->pass_head;
    to->with = row->pass_with;
    if (how == OVR_PASS_SMALLEST) {
        before = second ? "least_" : "";
        to->head = second ? "h_cen, min" : to->head;
        behind = "minimum over the pass";
    } else if (how == OVR_PASS_LARGEST) {
        before = second ? "largest_" : "";
        to->head = second ? "largest" : to->head;
        behind = "maximum over the pass";
    } else if (how == OVR_PASS_END)
        behind = "at the end of the pass";
    snprintf(to->name, sizeof to->name, "%s%s", before, row->name);
    snprintf(to->long_name, sizeof to->long_name, "%s, %s", row->long_name,
             behind);
}

bool ovr_pass_column_at(size_t k, ovr_pass_column *to)
{
    const ovr_observable *row;
    if (k < OVR_PASS_BESIDE) {
        *to = beside[k];
        return true;
    }
    k -= OVR_PASS_BESIDE;
    for (size_t r = 0; (row = ovr_observable_at(r)); r++)
        for (unsigned how = OVR_PASS_MEAN; how <= OVR_PASS_END; how *= 2)
            if (row->pass & how && k-- == 0) {
                *to = (ovr_pass_column){
                    .kind = row->kind, .of = row, .how = how};
                name(row, how, to);
                return true;
            }
    return false;
}

size_t ovr_pass_column_named(const char *name)
{
    ovr_pass_column c;
    size_t k = 0;
    while (ovr_pass_column_at(k, &c) && strcmp(c.name, name) != 0)
        k++;
    return k;
}

/* --------------------------------------------------------- Table for people */

static const ovr_table_column *named(const ovr_table *t, const char *name)
{
    const ovr_table_column *c;
    for (size_t k = 0; (c = ovr_table_at(t, k)); k++)
        if (strcmp(c->name, name) == 0)
            break;
    return c;
}

/* True if the table has columns that need this physical model (0: none
 * needed). */
static bool is_in(const ovr_table *t, unsigned physics)
{
    ovr_pass_column c;
    bool in = !physics;
    for (size_t k = 0; !in && ovr_pass_column_at(k, &c); k++)
        in = c.of && c.of->needs & physics && named(t, c.name);
    return in;
}

bool ovr_table_pass_head(const ovr_table *table, size_t k, ovr_pass_head *to)
{
    ovr_pass_column c;
    int last = 1;
    if (!table || !to)
        return false;
    for (int place = 1; place <= last; place++)
        for (size_t i = 0; ovr_pass_column_at(i, &c); i++) {
            if (c.place > last)
                last = c.place;
            if (c.place != place || !is_in(table, c.with) || k-- > 0)
                continue;
            *to = (ovr_pass_head){.text = c.head, .of = named(table, c.name)};
            snprintf(to->name, sizeof to->name, "%s", c.long_name);
            return true;
        }
    return false;
}

/* --------------------------------------------------------------------- File */

typedef struct table {
    const ovr_run *run;
    double *values;     /* values of a column */
    const char **texts; /* texts of a column */
    ovr_flat rows;
} table;

static bool write_numbers(const table *t, size_t k, const ovr_pass_column *c)
{
    const ovr_scales scales = ovr_scales_of(t->run->setup->contact);
    double factor = ovr_factor(&scales, c->kind);
    for (size_t i = 0; i < t->rows.count; i++)
        t->values[i] = t->run->passes->row[i].value[k] * factor;
    return ovr_flat_numbers(&t->rows, c->name, ovr_unit(&scales, c->kind),
                            c->long_name, t->values);
}

/* True if the column is written: the quantity's physical model is active;
 * errors and lives are known. */
static bool is_asked_for(const table *t, size_t k, const ovr_pass_column *c)
{
    bool known = k < OVR_PASS_FILM_ERROR;
    for (size_t i = 0; i < t->rows.count; i++)
        known = known || isfinite(t->run->passes->row[i].value[k]);
    return c->of ? !(c->of->needs & ~ovr_setup_physics(t->run->setup)) : known;
}

static bool write_columns(const table *t)
{
    ovr_pass_column c;
    bool good = true;
    for (size_t k = 0; good && ovr_pass_column_at(k, &c); k++)
        good = !is_asked_for(t, k, &c) || write_numbers(t, k, &c);
    return good;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static bool write_names(const table *t)
{
    const ovr_passes *p = t->run->passes;
    for (size_t i = 0; i < t->rows.count; i++)
        t->texts[i] = base_name(p->file[i]);
    if (!ovr_flat_texts(&t->rows, "file", "result file of the pass", t->texts))
        return false;
    for (size_t i = 0; i < t->rows.count; i++)
        t->texts[i] = p->row[i].status;
    return ovr_flat_texts(&t->rows, "status", "status of the result file",
                          t->texts);
}

static bool write_case(const table *t)
{
    const char *text = ovr_case_text(t->run->c, NULL);
    const char *folder = ovr_case_directory(t->run->c);
    hid_t group = ovr_header_group(t->rows.file, "case", 0);
    bool good = group >= 0 && text && ovr_h5_set_string(group, "text", text) &&
                ovr_h5_set_string(group, "path", folder ? folder : "");
    ovr_h5_drop(group);
    return good;
}

/* Numbers of the summary of all passes, in the same order whether the program
 * was killed or not. If the passes ended before it was killed, they are those
 * of the last pass. Result files contain the number of snapshots and the
 * computing time elsewhere. */
static const ovr_group_attribute *summary_of(const ovr_run *run,
                                             ovr_arena *arena, size_t *count)
{
    const ovr_passes *p = run->passes;
    ovr_result *last = NULL;
    const ovr_group_attribute *from;
    double snapshots = (double)run->info.snapshots, seconds = run->info.seconds;
    if (run->info.sim) {
        from = ovr_run_numbers(run, arena, count, NULL);
    } else {
        last = ovr_result_open(p->file[p->rows - 1], &run->arena.allocator,
                               NULL);
        from = last ? ovr_result_attributes(last, "summary", count) : NULL;
    }
    if (last) {
        const ovr_result_info *about = ovr_result_get_info(last);
        snapshots = (double)about->snapshots;
        seconds = about->seconds;
    }
    *count = from ? *count : 0;
    ovr_group_attribute *to = ovr_arena_take(arena, *count + 2, sizeof *to,
                                             NULL);
    for (size_t k = 0; to && k < *count; k++)
        to[k] = (ovr_group_attribute){ovr_arena_text(arena, from[k].name, NULL),
                                      NULL, from[k].number};
    if (to && from) {
        to[(*count)++] = (ovr_group_attribute){"snapshots", NULL, snapshots};
        to[(*count)++] = (ovr_group_attribute){"seconds", NULL, seconds};
    }
    ovr_result_close(last);
    return to;
}

static bool write_summary(const table *t, ovr_arena *arena)
{
    size_t count = 0;
    const ovr_group_attribute *line = summary_of(t->run, arena, &count);
    hid_t group = ovr_header_group(t->rows.file, "summary",
                                   count * (size_t)OVR_ATTRIBUTE);
    bool good = group >= 0 && line && !ovr_arena_status(arena);
    for (size_t k = 0; good && k < count; k++)
        good = ovr_h5_set_number(group, line[k].name, line[k].number);
    ovr_h5_drop(group);
    return good;
}

static bool write_part(table *t, const char *part, const char *status,
                       ovr_arena *arena)
{
    const char *title = t->run->setup->output->title;
    bool good = ovr_flat_begin(&t->rows, part, "pass", "number of the pass",
                               (size_t)t->run->passes->rows, arena) &&
                write_names(t) && write_case(t) &&
                ovr_h5_set_string(t->rows.file, "status", status) &&
                write_columns(t) &&
                (strcmp(status, "complete") != 0 || write_summary(t, arena));
    return ovr_flat_end(&t->rows, part,
                        title ? title : "passes of a line contact", good);
}

ovr_status ovr_passes_write(const ovr_run *run, const char *status,
                            ovr_error *err)
{
    const ovr_passes *p = run->passes;
    ovr_arena arena = ovr_arena_make(&run->arena.allocator);
    size_t count = (size_t)p->rows;
    table t = {.run = run};
    ovr_h5_handler before = ovr_h5_quiet();
    char part[4500];
    bool good;
    errno = 0;
    snprintf(part, sizeof part, "%.4400s.part", p->path);
    t.values = ovr_arena_take(&arena, count, sizeof *t.values, err);
    t.texts = ovr_arena_take(&arena, count, sizeof *t.texts, err);
    good = t.values && t.texts && write_part(&t, part, status, &arena) &&
           rename(part, p->path) == 0;
    if (!good)
        unlink(part);
    ovr_h5_restore(before);
    ovr_arena_release(&arena);
    return good ? OVR_OK
                : ovr_fail(err, OVR_IO, "%s: cannot be written%s%s", p->path,
                           errno ? ": " : "", errno ? strerror(errno) : "");
}

/* ----------------------------------------------------------------- Reading */

/* Attributes of a file of passes. */
typedef struct pass_attributes {
    const char *text, *folder, *status; /* of the case; status of the passes */
} pass_attributes;

/* Returns false if the file is no file of passes. */
static bool read_attributes(const char *path, ovr_arena *arena,
                            pass_attributes *t)
{
    ovr_container c;
    ovr_dataset pass;
    uint64_t object;
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    bool good = fd >= 0 &&
                ovr_container_open(&c, fd, arena) == OVR_FOUND_CONTAINER &&
                ovr_container_find(&c, c.root, "pass", &object) &&
                ovr_container_dataset(&c, object, &pass) &&
                ovr_container_find(&c, c.root, "case", &object);
    *t = (pass_attributes){NULL, NULL, NULL};
    if (good)
        *t = (pass_attributes){ovr_container_text(&c, object, "text"),
                               ovr_container_text(&c, object, "path"),
                               ovr_container_text(&c, c.root, "status")};
    if (fd >= 0)
        close(fd);
    return t->text != NULL;
}

bool ovr_passes_file_is(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    pass_attributes t;
    bool is = read_attributes(path, &arena, &t);
    ovr_arena_release(&arena);
    return is;
}

bool ovr_passes_file_complete(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    pass_attributes t;
    bool complete = read_attributes(path, &arena, &t) && t.status &&
                    strcmp(t.status, "complete") == 0;
    ovr_arena_release(&arena);
    return complete;
}

const ovr_named_number *ovr_passes_numbers(const char *path, ovr_arena *arena,
                                           size_t *count)
{
    ovr_container c;
    uint64_t object;
    const ovr_named_number *found = NULL;
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    *count = 0;
    if (fd >= 0 && ovr_container_open(&c, fd, arena) == OVR_FOUND_CONTAINER &&
        ovr_container_find(&c, c.root, "pass", &object) &&
        ovr_container_find(&c, c.root, "summary", &object))
        found = ovr_container_numbers(&c, object, count);
    if (fd >= 0)
        close(fd);
    return found;
}

ovr_case *ovr_passes_case(const char *path, const ovr_allocator *allocator,
                          ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    pass_attributes t;
    ovr_case *c = NULL;
    if (read_attributes(path, &arena, &t))
        c = ovr_case_read_stored(t.text, path,
                                 t.folder && *t.folder ? t.folder : NULL,
                                 allocator, err);
    else
        ovr_fail(err, OVR_BAD_INPUT, "%s: is not a file of several passes",
                 path);
    ovr_arena_release(&arena);
    return c;
}
