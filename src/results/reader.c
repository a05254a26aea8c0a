/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reading a result file, also while it is written.
 *
 * The writer changes the file's metadata only during flushes, which take
 * milliseconds, and a lock prevents reading meanwhile (journal.h). If the lock
 * fails, a read may contain parts of two states. Every read is therefore
 * checked (checksums, or NaN in a complete row) and repeated after reopening
 * the file. Rows are counted by their time: a row whose time is NaN does not
 * exist yet.
 *
 * hdf5read.h checks all sizes and offsets in the file against its length.
 */
#include "results/reader.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "base/given.h"
#include "results/journal.h"
#include "results/results.h"

/* ------------------------------------------------------------------ Opening */

static bool journal_name(const char *path, char *name, size_t size)
{
    int length = snprintf(name, size, "%s.journal", path);
    return length > 0 && (size_t)length < size;
}

int ovr_reader_lock(const ovr_result *r)
{
    char name[4096];
    int journal = -1;
    if (journal_name(r->path, name, sizeof name))
        journal = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (journal >= 0)
        ovr_commit_lock(journal, false);
    return journal;
}

void ovr_reader_unlock(int lock)
{
    if (lock < 0)
        return;
    ovr_commit_unlock(lock);
    close(lock);
}

static ovr_status cut(const ovr_result *r, ovr_error *err)
{
    return ovr_fail(err, OVR_IO,
                    "%s: the last write was interrupted; 'overroll resume' "
                    "restores the file to its last checkpoint",
                    r->path);
}

/* True if the file was cut within a commit. It is then a mixture of two states,
 * only some of which its own checksums reveal. */
static bool is_torn(ovr_result *r, int lock)
{
    if (ovr_commit_is_settled(lock)) {
        r->looked_at = false;
        return false;
    }
    if (r->looked_at) /* no writer, or it could not be determined */
        return false;
    r->looked_at = !ovr_journal_torn(lock, r->fd, &r->arena.allocator);
    return !r->looked_at;
}

ovr_status ovr_reader_file(ovr_result *r, int lock, ovr_error *err)
{
    r->fd = open(r->path, O_RDONLY | O_CLOEXEC);
    if (r->fd < 0)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", r->path, strerror(errno));
    if (lock >= 0 && is_torn(r, lock))
        return cut(r, err);
    switch (ovr_container_open(&r->container, r->fd, &r->work)) {
    case OVR_FOUND_CONTAINER: return OVR_OK;
    case OVR_FOUND_OTHER_HDF5: return ovr_reader_not_ours(r, err);
    case OVR_FOUND_TRUNCATED:
        return ovr_fail(err, OVR_IO, "%s: is a truncated or damaged HDF5 file",
                        r->path);
    case OVR_FOUND_NO_MEMORY:
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    default:
        return ovr_fail(err, OVR_BAD_INPUT, "%s: is not an HDF5 file", r->path);
    }
}

void ovr_reader_close_file(ovr_result *r)
{
    if (r->fd >= 0)
        close(r->fd);
    r->fd = -1;
    r->sets_hold = false;
    ovr_arena_release(&r->work);
}

static ovr_status open_once(ovr_result *r, int lock, ovr_error *err)
{
    ovr_status status = ovr_reader_file(r, lock, err);
    if (status == OVR_OK)
        status = ovr_reader_content(r, err);
    if (r->starved || r->container.source.starved)
        status = ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    ovr_arena_release(&r->work);
    return status;
}

/* True if a failed attempt should be repeated, after a pause, because commits
 * take milliseconds. `attempt`: its number; `locked`: with the lock. False if
 * there is no writer. */
static bool reader_again(const ovr_result *r, int attempt, bool locked)
{
    enum { MAX = 4 };
    struct timespec wait = {0, 1000000L << attempt};
    char journal[4096];
    bool written = locked || (journal_name(r->path, journal, sizeof journal) &&
                              access(journal, F_OK) == 0);
    if (!written || attempt >= MAX)
        return false;
    nanosleep(&wait, NULL);
    return true;
}

static ovr_status open_result(ovr_result *r, ovr_error *err)
{
    ovr_status status;
    int attempt = 0, lock;
    do {
        ovr_reader_close_file(r);
        lock = ovr_reader_lock(r);
        status = open_once(r, lock, err);
        ovr_reader_unlock(lock);
    } while (status == OVR_IO && reader_again(r, attempt++, lock >= 0));
    if (status == OVR_IO && err)
        err->status = OVR_BAD_INPUT;
    return status == OVR_IO ? OVR_BAD_INPUT : status;
}

ovr_result *ovr_result_open(const char *path, const ovr_allocator *allocator,
                            ovr_error *err)
{
    if (!path)
        return ovr_null(err, __func__);
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_result *r = ovr_arena_take(&arena, 1, sizeof *r, err);
    if (!r)
        return NULL;
    r->arena = arena;
    r->work = ovr_arena_make(allocator);
    r->fd = -1;
    r->path = ovr_arena_text(&r->arena, path, err);
    if (!r->path || open_result(r, err) != OVR_OK) {
        ovr_result_close(r);
        r = NULL;
    }
    return r;
}

void ovr_result_close(ovr_result *r)
{
    ovr_arena arena;
    if (!r)
        return;
    ovr_reader_close_file(r);
    arena = r->arena;
    ovr_arena_release(&arena);
}

/* ------------------------------------------------------------------ Reading */

/* ---------------------------------------------------------------- lists */

const ovr_result_info *ovr_result_get_info(const ovr_result *r)
{
    return !r ? NULL : &r->info;
}

size_t ovr_result_fields(const ovr_result *r)
{
    if (!r)
        return 0;
    return r->fields;
}

const ovr_variable *ovr_result_field(const ovr_result *r, size_t k)
{
    if (!r)
        return NULL;
    return k < r->fields ? r->field[k] : NULL;
}

const ovr_variable *ovr_result_column(const ovr_result *r, size_t k)
{
    if (!r)
        return NULL;
    return k < r->columns ? r->column[k] : NULL;
}

/* -------------------------------------------------------------- reading */

static const ovr_variable *find(const ovr_variable *const *list, size_t count,
                                const char *name)
{
    for (size_t k = 0; k < count; k++)
        if (strcmp(list[k]->name, name) == 0)
            return list[k];
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
                        "%s: the contact has no physical scales; '%s' is "
                        "available in Hertzian units only",
                        r->path, v->name);
    for (size_t i = 0; i < count; i++)
        values[i] = stored_si ? values[i] / v->scale : values[i] * v->scale;
    return OVR_OK;
}

/* Part of a dataset to read; whether it may contain NaN. */
typedef struct part {
    const ovr_variable *variable;
    size_t row, count;
    bool may_be_nan;
} part;

static bool any_nan(const double *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (isnan(values[i]))
            return true;
    return false;
}

/* Reads the values. The position of each dataset was read when the file was
 * opened; it is read again if the file has been continued since. */
static bool read_once(ovr_result *r, const part *what, double *values)
{
    ovr_dataset set = r->set[what->variable - r->variable];
    bool held = r->sets_hold;
    bool ok = (held || ovr_reader_dataset(r, what->variable->path, &set)) &&
              ovr_container_values(&r->container, &set, what->row, what->count,
                                   values) &&
              (what->may_be_nan || !any_nan(values, what->count)) &&
              !r->container.source.starved;
    ovr_arena_release(&r->work);
    r->sets_hold = held && ok;
    return ok || (held && read_once(r, what, values));
}

/* Reads with the lock held. While a writer exists, the file is reopened for
 * each read, because it may have grown or been replaced. */
static bool read_locked(ovr_result *r, const part *what, double *values,
                        bool *locked)
{
    int lock = ovr_reader_lock(r);
    bool ok;
    *locked = lock >= 0;
    if (*locked)
        ovr_reader_close_file(r);
    ok = (r->fd >= 0 || ovr_reader_file(r, lock, NULL) == OVR_OK) &&
         read_once(r, what, values);
    ovr_reader_unlock(lock);
    if (!ok)
        ovr_reader_close_file(r);
    return ok;
}

static ovr_status read_values(ovr_result *r, const part *what, ovr_units units,
                              double *values, ovr_error *err)
{
    const bool *starved = &r->container.source.starved;
    bool locked = false;
    bool ok = what->count == 0 || read_locked(r, what, values, &locked);
    for (int k = 0; !ok && !*starved && reader_again(r, k, locked); k++)
        ok = read_locked(r, what, values, &locked);
    if (!ok && *starved)
        return ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory", r->path);
    if (!ok)
        return ovr_fail(err, OVR_IO,
                        "%s: cannot read '%s' (row %zu); the file is damaged",
                        r->path, what->variable->path, what->row);
    return convert(r, what->variable, units, values, what->count, err);
}

ovr_status ovr_result_x(ovr_result *r, ovr_units units, double *x,
                        ovr_error *err)
{
    if (!r || !x)
        return ovr_fail_null(err, __func__);
    part what = {r->x, 0, r->info.nodes, false};
    return read_values(r, &what, units, x, err);
}

ovr_status ovr_result_y(ovr_result *r, ovr_units units, double *y,
                        ovr_error *err)
{
    if (!r || !y)
        return ovr_fail_null(err, __func__);
    part what = {r->y, 0, r->info.lines, false};
    if (!r->y) {
        y[0] = 0;
        return OVR_OK;
    }
    return read_values(r, &what, units, y, err);
}

ovr_status ovr_result_times(ovr_result *r, ovr_units units, double *times,
                            ovr_error *err)
{
    if (!r || !times)
        return ovr_fail_null(err, __func__);
    part what = {r->time, 0, r->info.snapshots, false};
    return read_values(r, &what, units, times, err);
}

/* Sets the extent of the row to be read; fails if there is no such row. */
static ovr_status choose_row(const ovr_result *r, part *what, ovr_error *err)
{
    const ovr_variable *v = what->variable;
    if (v->rank == 1) {
        what->row = 0;
        what->count = v->shape[0];
        return OVR_OK;
    }
    if (what->row >= v->shape[0])
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: has no snapshot %zu; the number of snapshots is "
                        "%zu",
                        r->path, what->row, v->shape[0]);
    what->count = 1;
    for (int k = 1; k < v->rank; k++)
        what->count *= v->shape[k];
    return OVR_OK;
}

ovr_status ovr_result_read(ovr_result *r, const char *path, size_t row,
                           ovr_units units, double *values, ovr_error *err)
{
    if (!r || !path)
        return ovr_fail_null(err, __func__);
    part what = {ovr_result_find(r, path), row, 0, true};
    ovr_status status;
    if (!what.variable)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: has no '%s'", r->path, path);
    status = choose_row(r, &what, err);
    return status ? status : read_values(r, &what, units, values, err);
}

static ovr_status find_field(const ovr_result *r, const char *field, size_t k,
                             part *what, ovr_error *err)
{
    *what = (part){find(r->field, r->fields, field), k, 0, false};
    if (!what->variable)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: has no field '%s'", r->path,
                        field);
    return choose_row(r, what, err);
}

ovr_status ovr_result_areal(ovr_result *r, const char *field, size_t k,
                            ovr_units units, double *values, ovr_error *err)
{
    part what;
    if (!r || !field || !values)
        return ovr_fail_null(err, __func__);
    ovr_status status = find_field(r, field, k, &what, err);
    return status ? status : read_values(r, &what, units, values, err);
}

/* Reads the shown line of a snapshot of a strip. */
static ovr_status read_line(ovr_result *r, const part *what, ovr_units units,
                            double *values, ovr_error *err)
{
    ovr_arena work = ovr_arena_make(&r->arena.allocator);
    double *all = ovr_arena_take(&work, what->count, sizeof *all, err);
    ovr_status status = all ? read_values(r, what, units, all, err)
                            : OVR_NO_MEMORY;
    if (!status)
        memcpy(values, all + r->shown * r->info.nodes,
               r->info.nodes * sizeof *values);
    ovr_arena_release(&work);
    return status;
}

ovr_status ovr_result_snapshot(ovr_result *r, const char *field, size_t k,
                               ovr_units units, double *values, ovr_error *err)
{
    part what;
    if (!r || !field)
        return ovr_fail_null(err, __func__);
    ovr_status status = find_field(r, field, k, &what, err);
    if (status)
        return status;
    return what.variable->rank == 3 ? read_line(r, &what, units, values, err)
                                    : read_values(r, &what, units, values, err);
}

ovr_status ovr_result_across(ovr_result *r, double *Y, ovr_error *err)
{
    if (!r || !Y)
        return ovr_fail_null(err, __func__);
    if (r->info.lines < 2)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "%s: is the result of a line contact and has no lines "
                        "across rolling",
                        r->path);
    ovr_arena work = ovr_arena_make(&r->arena.allocator);
    double *y = ovr_arena_take(&work, r->info.lines, sizeof *y, err);
    ovr_status status = y ? ovr_result_y(r, OVR_HERTZIAN, y, err)
                          : OVR_NO_MEMORY;
    double nearest = INFINITY, W = r->info.width;
    for (size_t j = 0; !status && !isnan(*Y) && j < r->info.lines; j++) {
        double apart = fabs(remainder(y[j] - *Y, W));
        if (apart < nearest - 1e-9) {
            nearest = apart;
            r->shown = j;
        }
    }
    if (!status)
        *Y = y[r->shown];
    ovr_arena_release(&work);
    return status;
}

ovr_status ovr_result_history(ovr_result *r, const char *name, ovr_units units,
                              double *values, ovr_error *err)
{
    if (!r || !name)
        return ovr_fail_null(err, __func__);
    part what = {find(r->column, r->columns, name), 0, r->info.steps, true};
    if (!what.variable)
        return ovr_fail(err, OVR_BAD_INPUT, "%s: has no history '%s'", r->path,
                        name);
    what.may_be_nan = strcmp(name, "time") != 0;
    return read_values(r, &what, units, values, err);
}

ovr_status ovr_result_unresolved(ovr_result *r, ovr_arena *arena,
                                 bool *unresolved, ovr_error *err)
{
    const char *const names[] = {"max_pressure", "max_pressure_resolved"};
    double *column[2];
    size_t steps = r->info.steps, most = 0, count;
    const ovr_group_attribute *number;
    *unresolved = false;
    if (!find(r->column, r->columns, names[1]))
        return OVR_OK;
    number = ovr_result_attributes(r, "summary", &count);
    for (size_t k = 0; k < count; k++)
        if (strcmp(number[k].name, "P_max_resolved") == 0) {
            *unresolved = number[k].number == 0;
            return OVR_OK;
        }
    for (int k = 0; k < 2; k++) {
        column[k] = ovr_arena_take(arena, steps + 1, sizeof(double), err);
        if (!column[k])
            return OVR_NO_MEMORY;
        ovr_status status = ovr_result_history(r, names[k], OVR_HERTZIAN,
                                               column[k], err);
        if (status)
            return status;
    }
    for (size_t k = 1; k < steps; k++)
        if (column[0][k] > column[0][most])
            most = k;
    *unresolved = steps > 0 && column[1][most] == 0;
    return OVR_OK;
}

/* ----------------------------------------------------- Attributes of groups */

/* Copies the result, because the memory of the file is released after each
 * lookup. */
static ovr_group_attribute *copy(ovr_result *r, const ovr_named_number *from,
                                 size_t count)
{
    ovr_group_attribute *to = ovr_arena_take(&r->arena, count, sizeof *to,
                                             NULL);
    for (size_t k = 0; to && k < count; k++) {
        to[k] = (ovr_group_attribute){
            .name = ovr_arena_text(&r->arena, from[k].name, NULL),
            .number = from[k].value};
        if (!to[k].name)
            return NULL;
    }
    return to;
}

static ovr_group_attribute *list(ovr_result *r, const char *path, size_t *count)
{
    ovr_container *c = &r->container;
    uint64_t group;
    const ovr_named_number *found = ovr_reader_object(r, path, &group)
                                        ? ovr_container_numbers(c, group, count)
                                        : NULL;
    ovr_group_attribute *copied = found ? copy(r, found, *count) : NULL;
    ovr_arena_release(&r->work);
    return copied;
}

const ovr_group_attribute *
ovr_result_attributes(ovr_result *r, const char *path, size_t *count)
{
    if (!r || !path || !count)
        return NULL;
    int lock = ovr_reader_lock(r);
    ovr_group_attribute *found = NULL;
    *count = 0;
    if (lock >= 0)
        ovr_reader_close_file(r);
    if (r->fd >= 0 || ovr_reader_file(r, lock, NULL) == OVR_OK)
        found = list(r, path, count);
    ovr_reader_unlock(lock);
    if (!found)
        *count = 0;
    return found;
}
