/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Writes rows of a result file.
 *
 * A snapshot is one chunk of each field, compressed here and passed to HDF5;
 * its time is written last. Readers see the snapshot after the next flush.
 * Every flush is checked, because it fails if the disk is full.
 */
#include "results/file.h"

#include <errno.h>
#include <hdf5.h>
#include <stdio.h>
#include <string.h>

#include "results/h5.h"
#include "results/hdf5read/hdf5read.h"
#include "results/header.h"
#include "results/inputs.h"
#include "results/store.h"

/* ---------------------------------------------------- file driver of HDF5 */

/* An HDF5 file driver that reads and writes the bytes of a store. */

#if defined(__has_include)
#if __has_include(<H5FDdevelop.h>)
#include <H5FDdevelop.h> /* HDF5 1.14 moved the drivers' interface there */
#endif
#endif

/* HDF5's part must be first, because HDF5 uses only that. */
typedef struct driven_file {
    H5FD_t hdf5;
    ovr_store *store;
    haddr_t allocated;
} driven_file;

/* Data of the file access properties. */
typedef struct driver_info {
    ovr_store *store;
} driver_info;

static H5FD_t *open_file(const char *name, unsigned flags, hid_t access,
                         haddr_t largest)
{
    const driver_info *info = H5Pget_driver_info(access);
    driven_file *file = info ? ovr_arena_take(info->store->changed.arena, 1,
                                              sizeof *file, NULL)
                             : NULL;
    (void)name;
    (void)flags;
    (void)largest;
    if (info && !file)
        info->store->failed = ENOMEM;
    if (!file)
        return NULL;
    file->store = info->store;
    return &file->hdf5;
}

static driven_file *driven(H5FD_t *file)
{
    return (driven_file *)(void *)file;
}

static const driven_file *driven_const(const H5FD_t *file)
{
    return (const driven_file *)(const void *)file;
}

/* Closes the file. Its memory belongs to the arena, and the commit follows
 * H5Fclose. */
static herr_t driver_close(H5FD_t *file)
{
    (void)file;
    return 0;
}

static herr_t driver_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
             H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

static haddr_t driver_get_eoa(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return driven_const(file)->allocated;
}

static herr_t driver_set_eoa(H5FD_t *file, H5FD_mem_t type, haddr_t end)
{
    (void)type;
    driven(file)->allocated = end;
    return 0;
}

static haddr_t driver_get_eof(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return driven_const(file)->store->length;
}

static herr_t driver_read(H5FD_t *file, H5FD_mem_t type, hid_t transfer,
                          haddr_t at, size_t bytes, void *to)
{
    (void)type;
    (void)transfer;
    return ovr_store_read(driven(file)->store, at, bytes, to) ? 0 : -1;
}

static herr_t driver_write(H5FD_t *file, H5FD_mem_t type, hid_t transfer,
                           haddr_t at, size_t bytes, const void *from)
{
    (void)type;
    (void)transfer;
    ovr_store_write(driven(file)->store, at, bytes, from);
    return 0;
}

static herr_t driver_truncate(H5FD_t *file, hid_t transfer, hbool_t closing)
{
    driven_file *f = driven(file);
    (void)transfer;
    (void)closing;
    if (f->allocated != f->store->length)
        ovr_store_resize(f->store, f->allocated);
    return 0;
}

static const H5FD_class_t driver_class = {
#ifdef H5FD_CLASS_VERSION
    .version = H5FD_CLASS_VERSION,
    .value = (H5FD_class_value_t)512, /* HDF5 reserves 512 to 1023 for all
                                       * users */
#endif
    .name = "overroll",
    .maxaddr = ((haddr_t)1 << 62) - 1,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(driver_info),
    .open = open_file,
    .close = driver_close,
    .query = driver_query,
    .get_eoa = driver_get_eoa,
    .set_eoa = driver_set_eoa,
    .get_eof = driver_get_eof,
    .read = driver_read,
    .write = driver_write,
    .truncate = driver_truncate,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

/* Returns access properties for the store. The driver is registered for each
 * file, so that the library has no globals. HDF5 uses the driver after dropping
 * its own reference to it, so another one is held until the end. */
static hid_t driver_access(ovr_store *store)
{
    driver_info info = {store};
    hid_t access = ovr_h5_access(), driver = H5FDregister(&driver_class);
    store->driver = driver;
    if (driver < 0 || H5Pset_driver(access, driver, &info) < 0) {
        ovr_h5_drop(access);
        access = -1;
    }
    return access;
}

/* Releases the driver; must be called when the file is closed. */
static void driver_release(ovr_store *store)
{
    if (store->driver > 0)
        H5FDunregister((hid_t)store->driver);
    store->driver = -1;
}

/* Creates or opens the store's file in HDF5; negative on failure.  The store
 * must outlive it. */
static hid_t driver_create(ovr_store *store, hid_t creation)
{
    hid_t access = driver_access(store), file = -1;
    if (access >= 0)
        file = H5Fcreate(store->path, H5F_ACC_TRUNC, creation, access);
    ovr_h5_drop(access);
    return file;
}

static hid_t driver_open(ovr_store *store)
{
    hid_t access = driver_access(store), file = -1;
    if (access >= 0)
        file = H5Fopen(store->path, H5F_ACC_RDWR, access);
    ovr_h5_drop(access);
    return file;
}

static ovr_status write_failed(ovr_file *f, ovr_error *err)
{
    ovr_store_fail(&f->store);
    return ovr_store_failure(&f->store, err);
}

static void forget_ids(ovr_file *f)
{
    f->file = f->time = f->step = f->transfer = -1;
    for (size_t k = 0; k < OVR_FIELDS_MAX; k++)
        f->field[k] = -1;
    for (size_t c = 0; c < f->columns; c++)
        f->column[c] = -1;
}

ovr_status ovr_file_prepare(ovr_file *f, const ovr_file_plan *plan,
                            ovr_arena *arena, ovr_error *err)
{
    f->nodes = plan->nodes;
    f->lines = plan->lines;
    f->values = f->nodes * f->lines;
    f->element = plan->options->single ? sizeof(float) : sizeof(double);
    f->deflate = plan->options->deflate;
    f->fields = ovr_layout_fields(plan->options->fields, f->which);
    unsigned physics = plan->options->physics;
    f->columns = ovr_layout_columns(physics, NULL);
    f->column = ovr_arena_take(arena, f->columns, sizeof *f->column, err);
    f->row = ovr_arena_take(arena, f->columns, sizeof *f->row, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    ovr_layout_columns(physics, f->row);
    forget_ids(f);
    if (ovr_store_prepare(&f->store, plan->options->path, arena, err) != OVR_OK)
        return OVR_NO_MEMORY;
    return ovr_packer_prepare(&f->packer, f->values * f->element, f->deflate,
                              arena, err);
}

/* Sets the date that identifies the store's file. */
static void name_store(ovr_file *f, const char *created)
{
    snprintf(f->store.created, sizeof f->store.created, "%s",
             created ? created : "");
}

/* Limits the buffer of conversions: HDF5 allocates and clears 1 MiB of it for
 * each conversion by default. */
static bool prepare_transfer(ovr_file *f)
{
    f->transfer = H5Pcreate(H5P_DATASET_XFER);
    return f->transfer >= 0 &&
           H5Pset_buffer(f->transfer, OVR_ROW_CHUNK * sizeof(double), NULL,
                         NULL) >= 0;
}

ovr_status ovr_file_create(ovr_file *f, const ovr_file_plan *plan,
                           ovr_error *err)
{
    hid_t creation;
    ovr_status status;
    name_store(f, plan->created);
    status = ovr_store_create(&f->store, plan->options->force, err);
    if (status != OVR_OK)
        return status;
    creation = ovr_header_creation();
    f->file = driver_create(&f->store, creation);
    ovr_h5_drop(creation);
    if (f->file < 0 || !prepare_transfer(f) || !ovr_header_write(f, plan))
        return write_failed(f, err);
    status = ovr_inputs_write(f, plan, err);
    if (status == OVR_IO)
        return write_failed(f, err);
    return status ? status : ovr_file_flush(f, err);
}

/* Extends a dataset to `rows` rows; `nodes` is 0 for a column. */
static bool grow(hid_t set, hsize_t rows, hsize_t nodes)
{
    hsize_t size[2] = {rows, nodes};
    return H5Dset_extent(set, size) >= 0;
}

static bool grow_field(const ovr_file *f, size_t k, hsize_t rows)
{
    hsize_t size[3] = {rows, f->lines, f->nodes};
    return f->lines > 1 ? H5Dset_extent(f->field[k], size) >= 0
                        : grow(f->field[k], rows, f->nodes);
}

static bool add_chunk(ovr_file *f, size_t k, const void *values)
{
    hsize_t at[3] = {f->snapshots, 0, 0};
    size_t element = ovr_file_element(f, f->which[k]), packed = 0;
    if (f->deflate)
        packed = ovr_pack(&f->packer, values, f->values, element);
    if (!grow_field(f, k, f->snapshots + 1))
        return false;
    if (packed)
        return H5Dwrite_chunk(f->field[k], H5P_DEFAULT, 0, at, packed,
                              f->packer.packed) >= 0;
    /* The filter mask skips shuffle and deflate, which are already applied. */
    return H5Dwrite_chunk(f->field[k], H5P_DEFAULT, f->deflate ? 3 : 0, at,
                          f->values * element, values) >= 0;
}

/* Appends `count` values to a column that has `rows`. */
static bool add_values(const ovr_file *f, hid_t set, hsize_t rows,
                       hsize_t count, hid_t type, const void *values)
{
    hid_t memory, space;
    bool ok;
    if (!grow(set, rows + count, 0))
        return false;
    memory = H5Screate_simple(1, &count, NULL);
    space = H5Dget_space(set);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &rows, NULL, &count, NULL);
    ok = H5Dwrite(set, type, memory, space, f->transfer, values) >= 0;
    ovr_h5_drop(space);
    ovr_h5_drop(memory);
    return ok;
}

ovr_status ovr_file_add_snapshot(ovr_file *f, double time, const void *rows,
                                 ovr_error *err)
{
    const unsigned char *row = rows;
    for (size_t k = 0; k < f->fields; k++) {
        if (!add_chunk(f, k, row))
            return write_failed(f, err);
        row += f->values * ovr_file_element(f, f->which[k]);
    }
    if (!add_values(f, f->time, f->snapshots, 1, H5T_NATIVE_DOUBLE, &time) ||
        f->store.failed)
        return write_failed(f, err);
    f->snapshots++;
    return OVR_OK;
}

ovr_status ovr_file_add_steps(ovr_file *f, size_t count, const int *steps,
                              const double *columns, size_t stride,
                              ovr_error *err)
{
    bool ok = count == 0 ||
              add_values(f, f->step, f->steps, count, H5T_NATIVE_INT, steps);
    for (size_t c = 0; ok && count && c < f->columns; c++)
        ok = add_values(f, f->column[c], f->steps, count, H5T_NATIVE_DOUBLE,
                        columns + c * stride);
    if (!ok || f->store.failed)
        return write_failed(f, err);
    f->steps += count;
    return OVR_OK;
}

/* --------------------------------------------------------------- resuming */

static ovr_status refuse(const ovr_file *f, const char *why, ovr_error *err)
{
    return ovr_fail(err, OVR_BAD_INPUT, "%s: %s", f->store.path, why);
}

/* Checks that an axis has these positions to the bit. */
static bool same_axis(ovr_container *c, const char *name, size_t n,
                      const double *values)
{
    double *found = ovr_arena_take(c->source.arena, n, sizeof *found, NULL);
    ovr_dataset x;
    uint64_t object;
    c->source.starved = c->source.starved || !found;
    return found && ovr_container_find(c, c->root, name, &object) &&
           ovr_container_dataset(c, object, &x) && x.rank == 1 &&
           x.shape[0] == n && ovr_container_values(c, &x, 0, n, found) &&
           memcmp(found, values, n * sizeof *found) == 0;
}

/* Checks that domain, level, lines, window and stride are unchanged. */
static bool same_positions(ovr_container *c, const ovr_file_plan *plan)
{
    return same_axis(c, "x", plan->nodes, plan->x) &&
           (!plan->y || same_axis(c, "y", plan->lines, plan->y));
}

/* Checks that precision and filters are unchanged. The first field may be
 * missing in the file. */
static bool same_precision(ovr_file *f, ovr_container *c)
{
    ovr_dataset set;
    uint64_t object;
    if (!ovr_container_find(c, c->root, f->which[0]->name, &object))
        return true;
    if (!ovr_container_dataset(c, object, &set))
        return false;
    if (!set.packed)
        f->deflate = 0;
    return set.element.size == ovr_file_element(f, f->which[0]);
}

static bool has_rows(ovr_container *c, uint64_t group, const char *name,
                     hsize_t rows)
{
    ovr_dataset set;
    uint64_t object;
    return ovr_container_find(c, group, name, &object) &&
           ovr_container_dataset(c, object, &set) && set.rank == 1 &&
           set.shape[0] >= rows;
}

/* Truncates datasets to the counted rows. A field that is new or was not always
 * stored has fewer rows, which are extended with NaN. */
static bool drop_rows(ovr_file *f)
{
    bool ok = grow(f->time, f->snapshots, 0) && grow(f->step, f->steps, 0);
    for (size_t k = 0; ok && k < f->fields; k++)
        ok = grow_field(f, k, f->snapshots);
    for (size_t c = 0; ok && c < f->columns; c++)
        ok = grow(f->column[c], f->steps, 0);
    return ok;
}

/* Checks the identity of the file before HDF5 opens it, because HDF5 may crash
 * with foreign or damaged files. */
static ovr_status check_identity(ovr_file *f, const ovr_file_plan *plan,
                                 ovr_container *c, ovr_error *err)
{
    const char *created;
    uint64_t history;
    ovr_found found = ovr_container_open(c, f->store.fd, c->source.arena);
    if (found != OVR_FOUND_CONTAINER)
        return refuse(f,
                      found == OVR_FOUND_NO_HDF5
                          ? "is not an HDF5 file"
                          : "is not a result file of overroll, or is damaged",
                      err);
    created = ovr_container_text(c, c->root, "date_created");
    if (!created || (plan->created && strcmp(created, plan->created) != 0))
        return refuse(f, "its checkpoint is from another run", err);
    snprintf(f->created, sizeof f->created, "%s", created);
    if (!same_positions(c, plan))
        return refuse(f,
                      "contains other nodes than requested now (domain, "
                      "level, window and stride cannot change)",
                      err);
    if (!same_precision(f, c))
        return refuse(f, "has another precision than requested now", err);
    if (!ovr_container_find(c, c->root, "history", &history) ||
        !has_rows(c, c->root, "time", f->snapshots) ||
        !has_rows(c, history, "step", f->steps))
        return refuse(f, "has fewer rows than its checkpoint states", err);
    return ovr_inputs_check(c, plan->options, err);
}

static ovr_status check_file(ovr_file *f, const ovr_file_plan *plan,
                             ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&f->store.changed.arena->allocator);
    ovr_container c = {.source = {.arena = &arena}};
    ovr_status status = check_identity(f, plan, &c, err);
    if (c.source.starved)
        status = ovr_fail(err, OVR_NO_MEMORY, "%s: out of memory",
                          f->store.path);
    ovr_arena_release(&arena);
    return status;
}

static bool mark_running(ovr_file *f, const ovr_file_plan *plan)
{
    double end = plan->options->end * ovr_factor(plan->scales, OVR_KIND_TIME);
    return ovr_h5_change_string(f->file, "status", "running") &&
           ovr_h5_change_string(f->file, "reason", "") &&
           ovr_h5_change_number(f->file, "time_end", end);
}

ovr_status ovr_file_open(ovr_file *f, const ovr_file_plan *plan,
                         size_t snapshots, size_t steps, ovr_error *err)
{
    ovr_status status;
    name_store(f, plan->created);
    f->store.kept.number = plan->number;
    status = ovr_store_open(&f->store, err);
    if (status != OVR_OK)
        return status;
    f->snapshots = snapshots;
    f->steps = steps;
    status = check_file(f, plan, err);
    if (status == OVR_OK) {
        name_store(f, f->created);
        f->file = driver_open(&f->store);
        if (f->file < 0 && f->store.failed)
            return ovr_store_failure(&f->store, err);
        if (f->file < 0 || !ovr_header_open(f, plan))
            status = refuse(f,
                            "is not a result file of overroll, or is "
                            "damaged",
                            err);
    }
    if (status != OVR_OK) {
        f->store.failed = ECANCELED; /* nothing more is written */
        return status;
    }
    if (!prepare_transfer(f) || !drop_rows(f) || !mark_running(f, plan) ||
        !ovr_header_new_case(f, plan))
        return write_failed(f, err);
    return ovr_file_flush(f, err);
}

/* ----------------------------------------------- flush and end of the run */

ovr_status ovr_file_flush(ovr_file *f, ovr_error *err)
{
    if (H5Fflush(f->file, H5F_SCOPE_GLOBAL) < 0)
        return write_failed(f, err);
    ovr_status status = ovr_store_commit(&f->store, err);
    if (status == OVR_OK)
        f->shown = f->snapshots;
    return status;
}

ovr_status ovr_file_status(ovr_file *f, ovr_run_status status,
                           const char *reason, double seconds, ovr_error *err)
{
    char date[OVR_DATE_SIZE];
    ovr_date_now(date);
    if (!ovr_h5_change_string(f->file, "status", ovr_run_status_name(status)) ||
        !ovr_h5_change_string(f->file, "reason", reason) ||
        !ovr_h5_change_string(f->file, "date_modified", date) ||
        !ovr_h5_change_number(f->file, "date_seconds", seconds))
        return write_failed(f, err);
    return OVR_OK;
}

ovr_status ovr_file_warnings(ovr_file *f, const char *text, ovr_error *err)
{
    return ovr_h5_put_string(f->file, "warnings", text) ? OVR_OK
                                                        : write_failed(f, err);
}

ovr_status ovr_file_extremes(ovr_file *f, const ovr_scales *scales,
                             const ovr_statistics *total, ovr_error *err)
{
    return ovr_header_extremes(f->file, scales, total) ? OVR_OK
                                                       : write_failed(f, err);
}

/* Marks the file as failed; `reason` NULL: status without a reason. */
static bool mark(ovr_store *s, const char *reason)
{
    hid_t file;
    bool ok = false;
    s->failed = 0;
    ovr_pages_clear(&s->changed);
    if (ovr_store_open(s, NULL) == OVR_OK) {
        file = driver_open(s);
        ok = file >= 0 && ovr_h5_change_string(file, "status", "failed") &&
             (!reason || ovr_h5_change_string(file, "reason", reason)) &&
             H5Fflush(file, H5F_SCOPE_GLOBAL) >= 0;
        if (file >= 0)
            ok = H5Fclose(file) >= 0 && ok;
        ok = ok && !s->failed && ovr_store_commit(s, NULL) == OVR_OK;
    }
    driver_release(s);
    ovr_store_close(s);
    return ok;
}

/* After a failed write the file is restored to its last flush. The freed space
 * usually suffices to record the status "failed" and the reason. If not, the
 * status remains "running". */
static void mark_failed(ovr_file *f)
{
    ovr_store *s = &f->store;
    ovr_error why;
    if (!s->published || s->failed == ESTALE || s->failed == ECANCELED)
        return;
    ovr_store_failure(s, &why);
    if (!mark(s, why.message))
        mark(s, NULL);
}

ovr_status ovr_file_close(ovr_file *f, ovr_error *err)
{
    bool open = f->file >= 0, closed;
    ovr_status status = OVR_OK;
    for (size_t c = 0; c < f->columns; c++)
        ovr_h5_drop(f->column[c]);
    for (size_t k = 0; k < f->fields; k++)
        ovr_h5_drop(f->field[k]);
    ovr_h5_drop(f->step);
    ovr_h5_drop(f->time);
    ovr_h5_drop(f->transfer);
    closed = !open || H5Fclose(f->file) >= 0;
    if (!closed || f->store.failed)
        status = write_failed(f, err);
    else if (open) /* closing writes more bytes */
        status = ovr_store_commit(&f->store, err);
    driver_release(&f->store);
    ovr_store_close(&f->store);
    if (status != OVR_OK && open)
        mark_failed(f);
    forget_ids(f);
    ovr_packer_release(&f->packer);
    return status;
}
