/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file of all passes: a netCDF-4 file of one dimension, `pass`, with a row
 * for each, the names of their files, and the case.  It is small, and written
 * whole each time. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case/case.h"
#include "case/setup.h"
#include "results/flat_table.h"
#include "results/hdf5read/hdf5read.h"
#include "results/header.h"
#include "results/layout.h"
#include "run/pass_series.h"

typedef struct table {
    const ovr_run *run;
    double *values;     /* a column */
    const char **texts; /* the same */
    ovr_flat rows;
} table;

static bool put_numbers(const table *t, size_t k, const ovr_pass_column *c)
{
    const ovr_scales scales = ovr_scales_of(t->run->setup->contact);
    double factor = ovr_factor(&scales, c->kind);
    for (size_t i = 0; i < t->rows.count; i++)
        t->values[i] = t->run->passes->row[i].value[k] * factor;
    return ovr_flat_numbers(&t->rows, c->name, ovr_unit(&scales, c->kind),
                            c->long_name, t->values);
}

/* Quantities whose physics is on; errors and lives where they are known. */
static bool is_asked_for(const table *t, size_t k, const ovr_pass_column *c)
{
    bool known = k < OVR_PASS_FILM_ERROR;
    for (size_t i = 0; i < t->rows.count; i++)
        known = known || isfinite(t->run->passes->row[i].value[k]);
    return c->of ? !(c->of->needs & ~ovr_setup_physics(t->run->setup)) : known;
}

static bool put_columns(const table *t)
{
    ovr_pass_column c;
    bool good = true;
    for (size_t k = 0; good && ovr_pass_column_at(k, &c); k++)
        good = !is_asked_for(t, k, &c) || put_numbers(t, k, &c);
    return good;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static bool put_names(const table *t)
{
    const ovr_passes *p = t->run->passes;
    for (size_t i = 0; i < t->rows.count; i++)
        t->texts[i] = base_name(p->file[i]);
    if (!ovr_flat_texts(&t->rows, "file", "result file of the pass", t->texts))
        return false;
    for (size_t i = 0; i < t->rows.count; i++)
        t->texts[i] = p->row[i].status;
    return ovr_flat_texts(&t->rows, "status", "how that file stands", t->texts);
}

static bool put_case(const table *t)
{
    const char *text = ovr_case_text(t->run->c, NULL);
    const char *folder = ovr_case_directory(t->run->c);
    hid_t group = ovr_header_group(t->rows.file, "case");
    bool good = group >= 0 && text && ovr_h5_set_string(group, "text", text) &&
                ovr_h5_set_string(group, "path", folder ? folder : "");
    ovr_h5_drop(group);
    return good;
}

static bool write_part(table *t, const char *part, const char *status,
                       ovr_arena *arena)
{
    const char *title = t->run->setup->output->title;
    bool good = ovr_flat_begin(&t->rows, part, "pass", "number of the pass",
                               (size_t)t->run->passes->rows, arena) &&
                put_names(t) && put_case(t) &&
                ovr_h5_set_string(t->rows.file, "status", status) &&
                put_columns(t);
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

/* ----------------------------------------------------------------- reading */

/* The file says this of itself. */
typedef struct told {
    const char *text, *folder, *status; /* of the case; of the passes */
} told;

/* false: no file of passes. */
static bool read_told(const char *path, ovr_arena *arena, told *t)
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
    *t = (told){NULL, NULL, NULL};
    if (good)
        *t = (told){ovr_container_text(&c, object, "text"),
                    ovr_container_text(&c, object, "path"),
                    ovr_container_text(&c, c.root, "status")};
    if (fd >= 0)
        close(fd);
    return t->text != NULL;
}

bool ovr_passes_file_is(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    told t;
    bool is = read_told(path, &arena, &t);
    ovr_arena_release(&arena);
    return is;
}

bool ovr_passes_file_complete(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    told t;
    bool complete = read_told(path, &arena, &t) && t.status &&
                    strcmp(t.status, "complete") == 0;
    ovr_arena_release(&arena);
    return complete;
}

ovr_case *ovr_passes_case(const char *path, const ovr_allocator *allocator,
                          ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    told t;
    ovr_case *c = NULL;
    if (read_told(path, &arena, &t))
        c = ovr_case_read_stored(t.text, path,
                                 t.folder && *t.folder ? t.folder : NULL,
                                 allocator, err);
    else
        ovr_fail(err, OVR_BAD_INPUT, "%s: is not a file of several passes",
                 path);
    ovr_arena_release(&arena);
    return c;
}
