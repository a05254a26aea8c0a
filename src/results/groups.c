/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Additional groups of a result file: arrays along their own axes, written
 * completely or row by row. They are few, so the solver's thread waits until
 * the queue is empty and writes them itself. An existing group is overwritten
 * value by value, because HDF5 1.10 cannot always close a file after a group
 * was deleted.
 */
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "results/h5.h"
#include "results/results.h"
#include "results/writer.h"

static ovr_status failed(ovr_writer *w, ovr_error *err)
{
    ovr_store_fail(&w->file.store);
    return ovr_store_failure(&w->file.store, err);
}

/* ------------------------------------------------------- a complete group */

/* Returns the bytes of its attributes. */
static size_t group_bytes(const ovr_group *g)
{
    size_t bytes = 0;
    for (size_t k = 0; k < g->attributes; k++)
        bytes += OVR_ATTRIBUTE + strlen(g->attribute[k].name);
    return bytes;
}

/* Opens or creates the group of a path and its parents. */
static hid_t make_path(hid_t file, const char *path, size_t bytes)
{
    char part[256];
    const char *slash = strchr(path, '/');
    if (slash) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - path), path);
        if (H5Lexists(file, part, H5P_DEFAULT) <= 0)
            ovr_h5_drop(ovr_header_group(file, part, 0));
    }
    return ovr_header_group(file, path, bytes);
}

static bool has_path(hid_t file, const char *path)
{
    char part[256];
    const char *slash = strchr(path, '/');
    snprintf(part, sizeof part, "%.*s",
             (int)(slash ? slash - path : (ptrdiff_t)strlen(path)), path);
    return H5Lexists(file, part, H5P_DEFAULT) > 0 &&
           (!slash || H5Lexists(file, path, H5P_DEFAULT) > 0);
}

/* Writes n values multiplied by the scale of their kind in this file, as
 * doubles. */
static bool write_doubles(const ovr_writer *w, hid_t set, ovr_unit_kind kind,
                          size_t n, const double *values, ovr_arena *arena)
{
    double factor = ovr_factor(&w->scales, kind);
    double *scaled = ovr_arena_take(arena, n, sizeof *scaled, NULL);
    for (size_t k = 0; scaled && k < n; k++)
        scaled[k] = factor * values[k];
    return scaled && H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                              H5P_DEFAULT, scaled) >= 0;
}

static bool write_singles(const ovr_writer *w, hid_t set, ovr_unit_kind kind,
                          size_t n, const float *values, ovr_arena *arena)
{
    double factor = ovr_factor(&w->scales, kind);
    float *scaled = ovr_arena_take(arena, n, sizeof *scaled, NULL);
    for (size_t k = 0; scaled && k < n; k++)
        scaled[k] = (float)(factor * (double)values[k]);
    return scaled && H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL,
                              H5P_DEFAULT, scaled) >= 0;
}

/* Opens the dataset of an earlier run, or creates it with the plan's shape. */
static hid_t made_or_open(const ovr_writer *w, hid_t group,
                          const ovr_new_dataset *plan)
{
    hsize_t shape[H5S_MAX_RANK];
    hid_t set, space;
    bool same;
    if (H5Lexists(group, plan->name, H5P_DEFAULT) <= 0)
        return ovr_header_dataset(group, plan, &w->scales);
    set = H5Dopen2(group, plan->name, H5P_DEFAULT);
    space = set >= 0 ? H5Dget_space(set) : -1;
    same = space >= 0 && H5Sget_simple_extent_ndims(space) == plan->rank &&
           H5Sget_simple_extent_dims(space, shape, NULL) >= 0;
    for (int k = plan->rows ? 1 : 0; same && k < plan->rank; k++)
        same = shape[k] == plan->shape[k];
    if (space >= 0)
        ovr_h5_drop(space);
    if (same)
        return set;
    if (set >= 0)
        ovr_h5_drop(set);
    return -1;
}

static hid_t make_axis(const ovr_writer *w, hid_t group,
                       const ovr_group_axis *axis, ovr_arena *arena)
{
    ovr_new_dataset plan = {.name = axis->name,
                            .long_name = axis->long_name,
                            .kind = axis->kind,
                            .type = H5T_IEEE_F64LE,
                            .rows = axis->values ? 0 : OVR_ROW_CHUNK,
                            .rank = 1,
                            .shape = {axis->values ? axis->count : 0}};
    hid_t set = made_or_open(w, group, &plan);
    if (set >= 0 && axis->values &&
        !write_doubles(w, set, axis->kind, axis->count, axis->values, arena)) {
        ovr_h5_drop(set);
        set = -1;
    }
    return set;
}

static bool write_values(const ovr_writer *w, hid_t set,
                         const ovr_group_array *array, size_t n,
                         ovr_arena *arena)
{
    if (array->flags)
        return H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                        array->flags) >= 0;
    if (array->singles)
        return write_singles(w, set, array->kind, n, array->singles, arena);
    if (array->doubles)
        return write_doubles(w, set, array->kind, n, array->doubles, arena);
    return true;
}

static bool make_array(const ovr_writer *w, hid_t group, const ovr_group *g,
                       const ovr_group_array *array, const hid_t *axis,
                       ovr_arena *arena)
{
    bool rows = !array->flags && !array->singles && !array->doubles;
    size_t n = 1;
    ovr_new_dataset plan = {.name = array->name,
                            .long_name = array->long_name,
                            .kind = array->kind,
                            .type = array->flags     ? H5T_STD_I8LE
                                    : array->doubles ? H5T_IEEE_F64LE
                                                     : H5T_IEEE_F32LE,
                            .rows = rows ? 1 : 0,
                            .rank = array->rank,
                            .deflate = rows ? w->file.deflate : 0};
    for (int k = 0; k < array->rank; k++) {
        const ovr_group_axis *along = &g->axis[array->along[k]];
        plan.shape[k] = along->values ? along->count : 0;
        plan.along[k] = axis[array->along[k]];
        n *= along->values ? along->count : 1;
    }
    hid_t set = made_or_open(w, group, &plan);
    bool ok = set >= 0 && write_values(w, set, array, n, arena);
    ovr_h5_drop(set);
    return ok;
}

/* Writes an attribute; `there`: it may exist already. */
static bool set_attribute(hid_t group, const ovr_group_attribute *a, bool there)
{
    if (a->text)
        return there ? ovr_h5_put_string(group, a->name, a->text)
                     : ovr_h5_set_string(group, a->name, a->text);
    return there ? ovr_h5_put_number(group, a->name, a->number)
                 : ovr_h5_set_number(group, a->name, a->number);
}

static bool fill_group(const ovr_writer *w, hid_t group, const ovr_group *g,
                       bool there, ovr_arena *arena)
{
    hid_t axis[OVR_MAX_RANK] = {-1, -1, -1, -1};
    bool ok = group >= 0 && g->axes <= OVR_MAX_RANK;
    for (size_t k = 0; ok && k < g->axes; k++)
        ok = (axis[k] = make_axis(w, group, &g->axis[k], arena)) >= 0;
    for (size_t k = 0; ok && k < g->arrays; k++)
        ok = make_array(w, group, g, &g->array[k], axis, arena);
    for (size_t k = 0; ok && k < g->attributes; k++)
        ok = set_attribute(group, &g->attribute[k], there);
    for (size_t k = 0; k < OVR_MAX_RANK; k++)
        if (axis[k] >= 0)
            ovr_h5_drop(axis[k]);
    return ok;
}

static bool make_group(ovr_writer *w, const ovr_group *g, bool keep)
{
    hid_t file = w->file.file, group;
    bool there = has_path(file, g->path), ok;
    ovr_arena arena = ovr_arena_make(&w->arena.allocator);
    if (there && keep)
        return true;
    group = there ? H5Gopen2(file, g->path, H5P_DEFAULT)
                  : make_path(file, g->path, group_bytes(g));
    ok = fill_group(w, group, g, there, &arena);
    if (group >= 0)
        ovr_h5_drop(group);
    ovr_arena_release(&arena);
    return ok;
}

/* Copies the caller's group and waits until the queue is empty. */
static ovr_status begin(ovr_writer *w, const ovr_group *given, ovr_group *g,
                        ovr_error *err)
{
    ovr_status status = OVR_TAKE(ovr_group, g, given, err);
    return status ? status : ovr_queue_wait(&w->queue, err);
}

ovr_status ovr_writer_group(ovr_writer *w, const ovr_group *given, bool keep,
                            ovr_error *err)
{
    if (!w)
        return ovr_fail_null(err, __func__);
    ovr_group g;
    ovr_status status = begin(w, given, &g, err);
    if (status)
        return status;
    ovr_h5_handler handler = ovr_h5_quiet();
    bool ok = make_group(w, &g, keep);
    ovr_h5_restore(handler);
    return ok ? OVR_OK : failed(w, err);
}

/* ------------------------------------------------------------------- rows */

/* Writes row k of a time-dependent dataset, which becomes the last row. */
static bool write_row(hid_t group, const char *name, hsize_t k, hid_t type,
                      const void *values)
{
    hid_t set = H5Dopen2(group, name, H5P_DEFAULT), space = -1, memory = -1;
    hsize_t shape[OVR_MAX_RANK], at[OVR_MAX_RANK] = {k};
    bool ok = set >= 0;
    if (ok) {
        space = H5Dget_space(set);
        int rank = H5Sget_simple_extent_dims(space, shape, NULL);
        ovr_h5_drop(space);
        shape[0] = k + 1;
        ok = H5Dset_extent(set, shape) >= 0;
        space = H5Dget_space(set);
        shape[0] = 1;
        ok = ok && H5Sselect_hyperslab(space, H5S_SELECT_SET, at, NULL, shape,
                                       NULL) >= 0;
        memory = H5Screate_simple(rank, shape, NULL);
        ok = ok && H5Dwrite(set, type, memory, space, H5P_DEFAULT, values) >= 0;
        ovr_h5_drop(memory);
        ovr_h5_drop(space);
        ovr_h5_drop(set);
    }
    return ok;
}

static bool append(ovr_writer *w, const ovr_group *g, size_t k, double T,
                   const float *values, size_t count)
{
    double time = T * ovr_factor(&w->scales, OVR_KIND_TIME);
    hid_t group = H5Gopen2(w->file.file, g->path, H5P_DEFAULT);
    ovr_arena arena = ovr_arena_make(&w->arena.allocator);
    float *scaled = ovr_arena_take(&arena, count, sizeof *scaled, NULL);
    bool ok = group >= 0 && scaled;
    for (size_t a = 0; ok && a < g->arrays; a++) {
        double factor = ovr_factor(&w->scales, g->array[a].kind);
        for (size_t i = 0; i < count; i++)
            scaled[i] = (float)(factor * (double)values[a * count + i]);
        ok = write_row(group, g->array[a].name, k, H5T_NATIVE_FLOAT, scaled);
    }
    ok = ok && write_row(group, "time", k, H5T_NATIVE_DOUBLE, &time);
    if (group >= 0)
        ovr_h5_drop(group);
    ovr_arena_release(&arena);
    return ok;
}

ovr_status ovr_writer_append(ovr_writer *w, const ovr_group *given, size_t k,
                             double T, const float *values, size_t count,
                             ovr_error *err)
{
    if (!w)
        return ovr_fail_null(err, __func__);
    ovr_group g;
    ovr_status status = begin(w, given, &g, err);
    if (status)
        return status;
    ovr_h5_handler handler = ovr_h5_quiet();
    bool ok = append(w, &g, k, T, values, count);
    ovr_h5_restore(handler);
    return ok ? OVR_OK : failed(w, err);
}
