/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening a result file: what is in it, and how much of it is complete. */
#include "results/reader.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "results/h5.h"
#include "results/turns.h"

enum { MAX_COLUMNS = 256 };

/* ------------------------------------------------------------- datasets */

hid_t ovr_reader_dataset(hid_t file, const char *path)
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

bool ovr_reader_part(hid_t set, hsize_t row, hsize_t count, double *values)
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
    if (rows && ovr_reader_part(set, rows - 1, 1, &value) && !isnan(value))
        return rows;
    while (low < high) {
        hsize_t middle = low + (high - low) / 2;
        if (ovr_reader_part(set, middle, 1, &value) && !isnan(value))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* -------------------------------------------------------------- opening */

/* A text attribute, NULL when there is none; notes when memory is out. */
static const char *text_of(ovr_result *r, hid_t object, const char *name)
{
    ovr_error err = {OVR_OK, ""};
    const char *text = ovr_h5_get_text(object, name, &r->arena, &err);
    r->starved = r->starved || err.status == OVR_NO_MEMORY;
    return text;
}

static const char *or_else(const char *text, const char *other)
{
    return text ? text : other;
}

static bool describe(ovr_result *r, hid_t set, const char *name,
                     ovr_variable *variable, ovr_error *err)
{
    variable->name = ovr_arena_text(&r->arena, name, err);
    r->starved = r->starved || !variable->name;
    variable->long_name = or_else(text_of(r, set, "long_name"), variable->name);
    variable->unit = or_else(text_of(r, set, "units"), "1");
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
    hid_t x = ovr_reader_dataset(r->file, "x"),
          time = ovr_reader_dataset(r->file, "time");
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
        hid_t set = ovr_reader_dataset(r->file, name);
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

/* In the order of their making where the file kept that. */
static bool name_of(hid_t group, hsize_t k, char *name, size_t size)
{
    const H5_index_t order[] = {H5_INDEX_CRT_ORDER, H5_INDEX_NAME};
    for (int o = 0; o < 2; o++)
        if (H5Lget_name_by_idx(group, ".", order[o], H5_ITER_INC, k, name, size,
                               H5P_DEFAULT) >= 0)
            return true;
    return false;
}

static ovr_status open_column(ovr_result *r, hid_t group, hsize_t k,
                              ovr_error *err)
{
    char name[128] = "";
    hsize_t shape[2];
    hid_t set;
    if (!name_of(group, k, name, sizeof name))
        return damaged(r, "its history", err);
    set = ovr_reader_dataset(group, name);
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
    hid_t time = ovr_reader_dataset(group, "time");
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

static void read_attributes(ovr_result *r)
{
    ovr_result_info *i = &r->info;
    hid_t f = r->file, group = H5Gopen2(f, "case", H5P_DEFAULT);
    i->title = or_else(text_of(r, f, "title"), "");
    i->status = or_else(text_of(r, f, "status"), "");
    i->source = or_else(text_of(r, f, "source"), "");
    i->created = or_else(text_of(r, f, "date_created"), "");
    i->modified = or_else(text_of(r, f, "date_modified"), "");
    i->case_text = group < 0 ? "" : or_else(text_of(r, group, "text"), "");
    i->physical = strcmp(or_else(text_of(r, f, "scaling"), ""), "SI") == 0;
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

static bool journal_name(const char *path, char *name, size_t size)
{
    int length = snprintf(name, size, "%s.journal", path);
    return length > 0 && (size_t)length < size;
}

/* A journal with something in it lies beside the file. */
static bool was_cut(const char *path)
{
    char journal[4096];
    struct stat about;
    return journal_name(path, journal, sizeof journal) &&
           stat(journal, &about) == 0 && about.st_size > 0;
}

int ovr_reader_enter(const ovr_result *r)
{
    char name[4096];
    int journal = -1;
    if (journal_name(r->path, name, sizeof name))
        journal = open(name, O_RDONLY | O_CLOEXEC);
    if (journal >= 0)
        ovr_turn_take(journal, false);
    return journal;
}

void ovr_reader_leave(int turn)
{
    if (turn < 0)
        return;
    ovr_turn_give(turn);
    close(turn);
}

/* OVR_IO: trying again may help, when the file is being written. */
ovr_status ovr_reader_file(ovr_result *r, ovr_error *err)
{
    hid_t access_list;
    if (access(r->path, R_OK) != 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, strerror(errno));
    access_list = ovr_h5_access();
    r->file = H5Fopen(r->path, H5F_ACC_RDONLY, access_list);
    ovr_h5_drop(access_list);
    if (r->file >= 0)
        return OVR_OK;
    if (H5Fis_hdf5(r->path) <= 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: not an HDF5 file", r->path);
    if (was_cut(r->path))
        return ovr_fail(err, OVR_IO,
                        "%s: its last write was cut; 'overroll "
                        "resume' repairs it",
                        r->path);
    return ovr_fail(err, OVR_IO, "%s: a truncated or damaged HDF5 file",
                    r->path);
}

void ovr_reader_close_file(ovr_result *r)
{
    if (r->file >= 0)
        H5Fclose(r->file);
    r->file = -1;
}

static ovr_status open_once(ovr_result *r, ovr_error *err)
{
    ovr_status status = ovr_reader_file(r, err);
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
    if (r->starved)
        status = ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    return status;
}

void ovr_reader_pause(int attempt)
{
    struct timespec wait = {0, 500000L << attempt};
    nanosleep(&wait, NULL);
}

static ovr_status open_result(ovr_result *r, ovr_error *err)
{
    ovr_status status = OVR_IO;
    int journal;
    for (int attempt = 0; status == OVR_IO && attempt < OVR_READ_ATTEMPTS;
         attempt++) {
        if (attempt > 0)
            ovr_reader_pause(attempt);
        ovr_reader_close_file(r);
        journal = ovr_reader_enter(r);
        status = open_once(r, err);
        ovr_reader_leave(journal);
    }
    if (status == OVR_IO && err)
        err->status = OVR_BAD_INPUT;
    return status == OVR_IO ? OVR_BAD_INPUT : status;
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
    ovr_reader_close_file(r);
    ovr_h5_restore(manners);
    arena = r->arena;
    ovr_arena_release(&arena);
}
