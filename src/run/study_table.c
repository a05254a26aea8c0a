/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a study for whoever draws or reckons with it, read again from
 * what `sweep --collect` wrote; and that of several passes, from their file. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/entries.h"
#include "base/given.h"
#include "base/text.h"
#include "results/hdf5read/hdf5read.h"
#include "run/csv.h"
#include "run/sweep_table.h"

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

/* ---------------------------------------------------------------- from CSV */

static size_t count_lines(const char *text)
{
    size_t n = 0;
    for (; *text; text++)
        n += *text == '\n';
    return n;
}

/* Names; the columns between `name` and `status` are the study's keys. */
static ovr_status read_heads(ovr_table *t, char **at, const char *path,
                             ovr_error *err)
{
    bool last = false, varied = false;
    while (!last && t->columns < OVR_TABLE_COLUMNS) {
        ovr_table_column *c = &t->column[t->columns++];
        double *number = ovr_arena_take(&t->arena, t->rows, sizeof *number,
                                        err);
        const char **text = ovr_arena_take(&t->arena, t->rows, sizeof *text,
                                           err);
        if (!number || !text)
            return OVR_NO_MEMORY;
        char *head = ovr_csv_cell(at, &last);
        const char *unit = ovr_csv_unit(head);
        *c = (ovr_table_column){head, unit, false, number, text, NULL};
        varied = varied && strcmp(c->name, "status") != 0;
        c->varied = varied;
        varied = varied || !strcmp(c->name, "name");
    }
    if (!last || t->columns < 3 || strcmp(t->column[0].name, "task") != 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is no table of a study, as 'overroll sweep "
                        "STUDY.ini --collect TABLE.csv' writes it",
                        path);
    return OVR_OK;
}

static void read_rows(ovr_table *t, char *at)
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
            ((double *)t->column[k].number)[i] = value;
            ((const char **)t->column[k].text)[i] = cell;
        }
    }
    t->rows = i;
}

static ovr_table *read_csv(const char *path, ovr_error *err)
{
    ovr_table *t = ovr_table_make(NULL, err);
    const char *text =
        t ? ovr_text_file(path, "table", MAX_BYTES, &t->arena, err) : NULL;
    char *at;
    ovr_status status = text ? OVR_OK : OVR_BAD_INPUT;
    if (!status) {
        at = ovr_arena_text(&t->arena, text, err);
        t->rows = count_lines(text);
        status = at ? read_heads(t, &at, path, err) : OVR_NO_MEMORY;
        if (!status)
            read_rows(t, at);
    }
    if (!status)
        return t;
    ovr_table_free(t);
    return NULL;
}

/* ------------------------------------------------------------- from netCDF */

/* True of a key that varied and is explained by its place in the case,
 * section.key. */
static bool is_place(const char *about)
{
    return about && strchr(about, '.') && !strchr(about, ' ');
}

/* A stranger's text reaches terminals: no control does. */
static const char *plain(ovr_table *t, const char *text)
{
    char *copy = ovr_arena_text(&t->arena, text, NULL);
    for (char *c = copy; c && *c; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f)
            *c = ' ';
    return copy;
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
                             unit && strcmp(unit, "1") != 0 ? plain(t, unit)
                                                            : "",
                             is_place(about),
                             number,
                             text,
                             zip ? plain(t, zip) : NULL};
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

/* All over one dimension: `case`, whose numbers say nothing, or `pass`. */
static bool take_variables(ovr_table *t, ovr_container *c)
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
               add_variable(t, c, &links[k]);
    if (passes && good && t->columns)
        t->column[0].varied = true;
    return good;
}

/* Texts stay where they were read. */
static ovr_table *read_netcdf(const char *path, ovr_error *err)
{
    ovr_table *t = ovr_table_make(NULL, err);
    ovr_container c;
    int fd = t ? open(path, O_RDONLY | O_CLOEXEC) : -1;
    bool good = fd >= 0 &&
                ovr_container_open(&c, fd, &t->arena) == OVR_FOUND_CONTAINER &&
                take_variables(t, &c);
    if (t && fd < 0)
        ovr_fail(err, OVR_BAD_INPUT, "%s: %s", path, strerror(errno));
    else if (!good && t)
        ovr_fail(err, OVR_BAD_INPUT,
                 "%s: is no table of passes or of a study, as 'overroll sweep "
                 "STUDY.ini --collect TABLE.nc' writes it",
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
