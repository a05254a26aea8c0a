/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/driver.h"

#include <errno.h>

#if defined(__has_include)
#if __has_include(<H5FDdevelop.h>)
#include <H5FDdevelop.h> /* HDF5 1.14 moved the drivers' interface there */
#endif
#endif

#include "results/h5.h"

/* HDF5's part comes first: it sees nothing else. */
typedef struct ovr_driven {
    H5FD_t hdf5;
    ovr_store *store;
    haddr_t allocated;
} ovr_driven;

/* The access properties carry this. */
typedef struct driver_info {
    ovr_store *store;
} driver_info;

static H5FD_t *driver_open(const char *name, unsigned flags, hid_t access,
                           haddr_t largest)
{
    const driver_info *info = H5Pget_driver_info(access);
    ovr_driven *file = info ? ovr_arena_take(info->store->changed.arena, 1,
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

static ovr_driven *driven(H5FD_t *file)
{
    return (ovr_driven *)(void *)file;
}

static const ovr_driven *driven_const(const H5FD_t *file)
{
    return (const ovr_driven *)(const void *)file;
}

/* Its memory is the arena's; its end is a commit after H5Fclose. */
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
    ovr_driven *f = driven(file);
    (void)transfer;
    (void)closing;
    if (f->allocated != f->store->length)
        ovr_store_resize(f->store, f->allocated);
    return 0;
}

static const H5FD_class_t driver_class = {
#ifdef H5FD_CLASS_VERSION
    .version = H5FD_CLASS_VERSION,
    .value = (H5FD_class_value_t)512, /* HDF5 leaves 512 to 1023 to all */
#endif
    .name = "overroll",
    .maxaddr = ((haddr_t)1 << 62) - 1,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(driver_info),
    .open = driver_open,
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

/* Access properties that lead to the store; registering the driver again for
 * each file keeps the library free of globals.  HDF5 uses the driver after
 * dropping its own reference to it, so that ours is held until the end. */
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

void ovr_driver_release(ovr_store *store)
{
    if (store->driver > 0)
        H5FDunregister((hid_t)store->driver);
    store->driver = -1;
}

hid_t ovr_driver_create(ovr_store *store, hid_t creation)
{
    hid_t access = driver_access(store), file = -1;
    if (access >= 0)
        file = H5Fcreate(store->path, H5F_ACC_TRUNC, creation, access);
    ovr_h5_drop(access);
    return file;
}

hid_t ovr_driver_open(ovr_store *store)
{
    hid_t access = driver_access(store), file = -1;
    if (access >= 0)
        file = H5Fopen(store->path, H5F_ACC_RDWR, access);
    ovr_h5_drop(access);
    return file;
}
