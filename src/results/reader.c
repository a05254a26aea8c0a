/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading a result file, also while it is written.
 *
 * The writer changes the file's metadata only in short bursts, its flushes; a
 * reader that opens or reads across one may find the halves of two states.
 * So every read is checked (HDF5's own error, or NaN where a complete row has
 * none) and repeated with the file opened anew.  Rows are counted by their
 * time: one that is still NaN does not exist yet.
 *
 * Nothing in the file is trusted: every dataset's rank and length is checked
 * before it is read into memory of the length that the caller was told.
 */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "overroll/results.h"
#include "results/h5.h"
#include "results/layout.h"

enum { ATTEMPTS = 5, MAX_COLUMNS = 256 };

struct ovr_result {
    ovr_arena arena;
    char *path;
    hid_t file;
    ovr_result_info info;
    ovr_variable x, time;
    ovr_variable field[OVR_FIELD_COUNT];
    ovr_variable *column;
    size_t fields, columns;
};

/* ------------------------------------------------------------- datasets */

/* A dataset by its path, or -1: no links out of the file are followed. */
static hid_t open_dataset(hid_t file, const char *path)
{
    H5L_info_t link;
    if (H5Lget_info(file, path, &link, H5P_DEFAULT) < 0 ||
        link.type != H5L_TYPE_HARD)
        return -1;
    return H5Dopen2(file, path, H5P_DEFAULT);
}

/* Rank (0 when it is none) and lengths, 0 in those that are not there. */
static int shape_of(hid_t set, hsize_t shape[2])
{
    hid_t space = set < 0 ? -1 : H5Dget_space(set);
    int rank = space < 0 ? 0 : H5Sget_simple_extent_ndims(space);
    shape[0] = shape[1] = 0;
    if (rank < 1 || rank > 2 ||
        H5Sget_simple_extent_dims(space, shape, NULL) < 0)
        rank = 0;
    ovr_h5_drop(space);
    return rank;
}

/* Reads `count` elements from row `row` on of a one-dimensional dataset, or
 * row `row` of a two-dimensional one that is `count` wide. */
static bool read_part(hid_t set, hsize_t row, hsize_t count, double *values)
{
    hsize_t shape[2], from[2] = {row, 0}, size[2] = {1, count};
    int rank = shape_of(set, shape);
    hid_t space, memory;
    bool ok;
    if (rank == 1)
        size[0] = count;
    if (rank == 0 || from[0] + size[0] > shape[0] ||
        (rank == 2 && count != shape[1]))
        return false;
    space = H5Dget_space(set);
    memory = H5Screate_simple(1, &count, NULL);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, from, NULL, size, NULL);
    ok = H5Dread(set, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, values) >=
         0;
    ovr_h5_drop(memory);
    ovr_h5_drop(space);
    return ok;
}

/* How many values stand before the first NaN, which begins the rows that are
 * not complete yet. */
static hsize_t complete_rows(hid_t set, hsize_t rows)
{
    hsize_t low = 0, high = rows;
    double value;
    if (rows && read_part(set, rows - 1, 1, &value) && !isnan(value))
        return rows;
    while (low < high) {
        hsize_t middle = low + (high - low) / 2;
        if (read_part(set, middle, 1, &value) && !isnan(value))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* -------------------------------------------------------------- opening */

static bool describe(ovr_result *r, hid_t set, const char *name,
                     ovr_variable *variable, ovr_error *err)
{
    const char *unit = ovr_h5_get_text(set, "units", &r->arena, err);
    const char *text = ovr_h5_get_text(set, "long_name", &r->arena, err);
    variable->name = ovr_arena_text(&r->arena, name, err);
    variable->long_name = text ? text : variable->name;
    variable->unit = unit ? unit : "1";
    variable->scale = ovr_h5_get_number(set, "scale");
    return variable->name != NULL;
}

static ovr_status damaged(const ovr_result *r, const char *what, ovr_error *err)
{
    return ovr_fail(err, OVR_IO, "%s: damaged result file: %s", r->path, what);
}

/* x and time, and the number of rows that both have. */
static ovr_status open_axes(ovr_result *r, ovr_error *err)
{
    hid_t x = open_dataset(r->file, "x"), time = open_dataset(r->file, "time");
    hsize_t nodes[2], rows[2];
    bool ok = shape_of(x, nodes) == 1 && shape_of(time, rows) == 1 &&
              nodes[0] > 0 && nodes[0] < SIZE_MAX / 16 &&
              describe(r, x, "x", &r->x, err) &&
              describe(r, time, "time", &r->time, err);
    if (ok) {
        r->info.nodes = (size_t)nodes[0];
        r->info.snapshots = (size_t)complete_rows(time, rows[0]);
    }
    ovr_h5_drop(time);
    ovr_h5_drop(x);
    return ok ? OVR_OK : damaged(r, "no x or no time", err);
}

static ovr_status open_fields(ovr_result *r, ovr_error *err)
{
    for (size_t k = 0; k < OVR_FIELD_COUNT; k++) {
        const char *name = ovr_field_table[k].name;
        hid_t set = open_dataset(r->file, name);
        hsize_t shape[2];
        int rank = shape_of(set, shape);
        if (rank == 2 && shape[1] == r->info.nodes &&
            describe(r, set, name, &r->field[r->fields], err)) {
            r->fields++;
            if (shape[0] < r->info.snapshots)
                r->info.snapshots = (size_t)shape[0];
        }
        ovr_h5_drop(set);
    }
    return r->fields ? OVR_OK : damaged(r, "no field", err);
}

static ovr_status open_column(ovr_result *r, hid_t group, hsize_t k,
                              ovr_error *err)
{
    char name[128] = "";
    hsize_t shape[2];
    hid_t set;
    if (H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name,
                           sizeof name, H5P_DEFAULT) < 0)
        return damaged(r, "its history", err);
    set = open_dataset(group, name);
    if (shape_of(set, shape) == 1) {
        if (r->columns == 0 || shape[0] < r->info.steps)
            r->info.steps = (size_t)shape[0];
        if (describe(r, set, name, &r->column[r->columns], err))
            r->columns++;
    }
    ovr_h5_drop(set);
    return OVR_OK;
}

static ovr_status count_steps(ovr_result *r, hid_t group, ovr_error *err)
{
    hid_t time = open_dataset(group, "time");
    hsize_t shape[2];
    if (shape_of(time, shape) != 1)
        return damaged(r, "no time in its history", err);
    r->info.steps = (size_t)complete_rows(time, r->info.steps);
    ovr_h5_drop(time);
    return OVR_OK;
}

static ovr_status open_history(ovr_result *r, ovr_error *err)
{
    hid_t group = H5Gopen2(r->file, "history", H5P_DEFAULT);
    H5G_info_t info = {H5G_STORAGE_TYPE_UNKNOWN, 0, 0, 0};
    ovr_status status = OVR_OK;
    if (group < 0 || H5Gget_info(group, &info) < 0 || info.nlinks > MAX_COLUMNS)
        status = damaged(r, "no history", err);
    r->column = ovr_arena_take(&r->arena, (size_t)info.nlinks + 1,
                               sizeof *r->column, err);
    if (status == OVR_OK && !r->column)
        status = OVR_NO_MEMORY;
    for (hsize_t k = 0; status == OVR_OK && k < info.nlinks; k++)
        status = open_column(r, group, k, err);
    if (status == OVR_OK)
        status = count_steps(r, group, err);
    ovr_h5_drop(group);
    return status;
}

static const char *text_of(ovr_result *r, hid_t object, const char *name)
{
    const char *text = ovr_h5_get_text(object, name, &r->arena, NULL);
    return text ? text : "";
}

static void read_attributes(ovr_result *r)
{
    ovr_result_info *i = &r->info;
    hid_t f = r->file, group = H5Gopen2(f, "case", H5P_DEFAULT);
    i->title = text_of(r, f, "title");
    i->status = text_of(r, f, "status");
    i->source = text_of(r, f, "source");
    i->created = text_of(r, f, "date_created");
    i->modified = text_of(r, f, "date_modified");
    i->case_text = group < 0 ? "" : text_of(r, group, "text");
    i->physical = strcmp(text_of(r, f, "scaling"), "SI") == 0;
    i->b = ovr_h5_get_number(f, "scale_length");
    i->ph = ovr_h5_get_number(f, "scale_pressure");
    i->height = ovr_h5_get_number(f, "scale_height");
    i->time = ovr_h5_get_number(f, "scale_time");
    i->M = ovr_h5_get_number(f, "M");
    i->L = ovr_h5_get_number(f, "L");
    i->alphabar = ovr_h5_get_number(f, "alphabar");
    i->lambda = ovr_h5_get_number(f, "lambda");
    i->u1_ratio = ovr_h5_get_number(f, "u1_over_um");
    i->u2_ratio = ovr_h5_get_number(f, "u2_over_um");
    i->end = ovr_h5_get_number(f, "time_end") / (i->physical ? i->time : 1);
    i->seconds = ovr_h5_get_number(f, "date_seconds");
    ovr_h5_drop(group);
}

static ovr_status check_format(const ovr_result *r, ovr_error *err)
{
    double version = ovr_h5_get_number(r->file, "format_version");
    if (isnan(version))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: an HDF5 file, but not a result of overroll",
                        r->path);
    if (version != OVR_FORMAT_VERSION)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: written in format version %g; this program reads "
                        "version %d",
                        r->path, version, OVR_FORMAT_VERSION);
    return OVR_OK;
}

static ovr_status open_file(ovr_result *r, ovr_error *err)
{
    hid_t access_list;
    if (access(r->path, R_OK) != 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, strerror(errno));
    access_list = ovr_h5_access();
    r->file = H5Fopen(r->path, H5F_ACC_RDONLY, access_list);
    ovr_h5_drop(access_list);
    if (r->file >= 0)
        return OVR_OK;
    if (H5Fis_hdf5(r->path) > 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: cannot be opened: a truncated "
                        "or damaged HDF5 file",
                        r->path);
    return ovr_fail(err, OVR_BAD_INPUT, "%s: not an HDF5 file", r->path);
}

static void close_file(ovr_result *r)
{
    if (r->file >= 0)
        H5Fclose(r->file);
    r->file = -1;
}

static ovr_status open_once(ovr_result *r, ovr_error *err)
{
    ovr_status status = open_file(r, err);
    r->fields = r->columns = 0;
    if (status == OVR_OK)
        status = check_format(r, err);
    if (status == OVR_OK)
        status = open_axes(r, err);
    if (status == OVR_OK)
        status = open_fields(r, err);
    if (status == OVR_OK)
        status = open_history(r, err);
    if (status == OVR_OK)
        read_attributes(r);
    return status;
}

/* Before the next attempt: the writer's bursts take milliseconds. */
static void pause_a_little(int attempt)
{
    struct timespec wait = {0, 5000000L << attempt};
    nanosleep(&wait, NULL);
}

static ovr_status open_result(ovr_result *r, ovr_error *err)
{
    ovr_status status = OVR_IO;
    for (int attempt = 0; status == OVR_IO && attempt < ATTEMPTS; attempt++) {
        if (attempt > 0)
            pause_a_little(attempt);
        close_file(r);
        status = open_once(r, err);
    }
    return status;
}

ovr_result *ovr_result_open(const char *path, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_result *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    ovr_h5_manners manners;
    if (!r)
        return NULL;
    r->arena = arena;
    r->file = -1;
    manners = ovr_h5_quiet();
    r->path = ovr_arena_text(&r->arena, path, err);
    if (!r->path || open_result(r, err) != OVR_OK) {
        ovr_result_close(r);
        r = NULL;
    }
    ovr_h5_restore(manners);
    return r;
}

void ovr_result_close(ovr_result *r)
{
    ovr_h5_manners manners;
    ovr_arena arena;
    if (!r)
        return;
    manners = ovr_h5_quiet();
    close_file(r);
    ovr_h5_restore(manners);
    arena = r->arena;
    ovr_arena_release(&arena);
}

/* ---------------------------------------------------------------- lists */

const ovr_result_info *ovr_result_about(const ovr_result *r)
{
    return &r->info;
}

size_t ovr_result_fields(const ovr_result *r)
{
    return r->fields;
}

const ovr_variable *ovr_result_field(const ovr_result *r, size_t k)
{
    return k < r->fields ? &r->field[k] : NULL;
}

size_t ovr_result_columns(const ovr_result *r)
{
    return r->columns;
}

const ovr_variable *ovr_result_column(const ovr_result *r, size_t k)
{
    return k < r->columns ? &r->column[k] : NULL;
}

const char *ovr_result_field_name(const ovr_result *r, size_t k)
{
    return k < r->fields ? r->field[k].name : NULL;
}

const char *ovr_result_field_unit(const ovr_result *r, size_t k)
{
    return k < r->fields ? r->field[k].unit : NULL;
}

/* -------------------------------------------------------------- reading */

static const ovr_variable *find(const ovr_variable *list, size_t count,
                                const char *name)
{
    for (size_t k = 0; k < count; k++)
        if (strcmp(list[k].name, name) == 0)
            return &list[k];
    return NULL;
}

static ovr_status convert(const ovr_result *r, const ovr_variable *v,
                          ovr_units units, double *values, size_t count,
                          ovr_error *err)
{
    bool stored_si = strcmp(v->unit, "1") != 0;
    if (units == OVR_AS_STORED || stored_si == (units == OVR_SI))
        return OVR_OK;
    if (isnan(v->scale) && units == OVR_SI)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: the contact was given without "
                        "physical scales; '%s' is known in Hertzian units only",
                        r->path, v->name);
    for (size_t i = 0; i < count; i++)
        values[i] = stored_si ? values[i] / v->scale : values[i] * v->scale;
    return OVR_OK;
}

/* What to read: part of a dataset, NaN allowed in it or not. */
typedef struct part {
    const char *path;
    hsize_t row, count;
    bool may_be_nan;
} part;

static bool any_nan(const double *values, hsize_t count)
{
    for (hsize_t i = 0; i < count; i++)
        if (isnan(values[i]))
            return true;
    return false;
}

static bool read_once(ovr_result *r, const part *what, double *values)
{
    hid_t set = r->file < 0 ? -1 : open_dataset(r->file, what->path);
    bool ok = set >= 0 && read_part(set, what->row, what->count, values) &&
              (what->may_be_nan || !any_nan(values, what->count));
    ovr_h5_drop(set);
    return ok;
}

static ovr_status read_values(ovr_result *r, const part *what,
                              const ovr_variable *variable, ovr_units units,
                              double *values, ovr_error *err)
{
    ovr_h5_manners manners = ovr_h5_quiet();
    bool ok = what->count == 0 || read_once(r, what, values);
    for (int attempt = 1; !ok && attempt < ATTEMPTS; attempt++) {
        pause_a_little(attempt);
        close_file(r);
        ok = open_file(r, NULL) == OVR_OK && read_once(r, what, values);
    }
    ovr_h5_restore(manners);
    if (!ok)
        return ovr_fail(err, OVR_IO,
                        "%s: '%s' cannot be read (row %llu): the "
                        "file is damaged",
                        r->path, what->path, (unsigned long long)what->row);
    return convert(r, variable, units, values, (size_t)what->count, err);
}

ovr_status ovr_result_x(ovr_result *r, ovr_units units, double *x,
                        ovr_error *err)
{
    part what = {"x", 0, r->info.nodes, false};
    return read_values(r, &what, &r->x, units, x, err);
}

ovr_status ovr_result_times(ovr_result *r, ovr_units units, double *times,
                            ovr_error *err)
{
    part what = {"time", 0, r->info.snapshots, false};
    return read_values(r, &what, &r->time, units, times, err);
}

ovr_status ovr_result_snapshot(ovr_result *r, const char *field, size_t k,
                               ovr_units units, double *values, ovr_error *err)
{
    const ovr_variable *variable = find(r->field, r->fields, field);
    part what = {field, k, r->info.nodes, false};
    if (!variable)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: has no field '%s'", r->path,
                        field);
    if (k >= r->info.snapshots)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: has no snapshot %zu; there are %zu", r->path, k,
                        r->info.snapshots);
    return read_values(r, &what, variable, units, values, err);
}

ovr_status ovr_result_history(ovr_result *r, const char *name, ovr_units units,
                              double *values, ovr_error *err)
{
    const ovr_variable *variable = find(r->column, r->columns, name);
    char path[160];
    part what = {path, 0, r->info.steps, true};
    if (!variable)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: has no history '%s'", r->path,
                        name);
    snprintf(path, sizeof path, "history/%s", name);
    if (strcmp(name, "time") == 0)
        what.may_be_nan = false;
    return read_values(r, &what, variable, units, values, err);
}
