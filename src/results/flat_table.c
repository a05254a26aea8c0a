/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/flat_table.h"

#include <fcntl.h>
#include <hdf5_hl.h>
#include <unistd.h>

#include "overroll/version.h"
#include "results/header.h"

/* Creates a variable; the first is the dimension scale of the others. */
static hid_t create(const ovr_flat *r, const char *name, hid_t type)
{
    hid_t set = H5Dcreate2(r->file, name, type, r->space, H5P_DEFAULT,
                           r->properties, H5P_DEFAULT);
    if (set >= 0 && r->scale >= 0 && H5DSattach_scale(set, r->scale, 0) < 0) {
        H5Dclose(set);
        return -1;
    }
    return set;
}

static bool write_variable(hid_t set, hid_t type, const void *values,
                           const char *unit, const char *about)
{
    bool good = set >= 0 &&
                H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >=
                    0 &&
                (!unit || ovr_h5_set_chars(set, "units", unit)) &&
                ovr_h5_set_chars(set, "long_name", about);
    return set >= 0 && H5Dclose(set) >= 0 && good;
}

static bool write_scale(ovr_flat *r, const char *name, const char *about,
                        ovr_arena *arena)
{
    int *number = ovr_arena_take(arena, r->count, sizeof *number, NULL);
    for (size_t i = 0; number && i < r->count; i++)
        number[i] = (int)i + 1;
    r->scale = number ? create(r, name, H5T_STD_I32LE) : -1;
    return r->scale >= 0 && H5DSset_scale(r->scale, name) >= 0 &&
           H5Dwrite(r->scale, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    number) >= 0 &&
           ovr_h5_set_chars(r->scale, "long_name", about);
}

bool ovr_flat_begin(ovr_flat *r, const char *path, const char *name,
                    const char *about, size_t count, ovr_arena *arena)
{
    /* netCDF-4 requires links and attributes in order of creation. */
    const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hsize_t length = count;
    hid_t access = ovr_h5_access(), creation = ovr_header_creation();
    *r = (ovr_flat){.count = count, .scale = -1};
    r->file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access);
    r->space = H5Screate_simple(1, &length, NULL);
    r->properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_attr_creation_order(r->properties, order);
    r->text = H5Tcopy(H5T_C_S1);
    H5Tset_size(r->text, H5T_VARIABLE);
    H5Tset_cset(r->text, H5T_CSET_UTF8);
    ovr_h5_drop(creation);
    ovr_h5_drop(access);
    return r->file >= 0 && write_scale(r, name, about, arena);
}

bool ovr_flat_numbers(const ovr_flat *r, const char *name, const char *unit,
                      const char *about, const double *values)
{
    return write_variable(create(r, name, H5T_IEEE_F64LE), H5T_NATIVE_DOUBLE,
                          values, unit, about);
}

bool ovr_flat_texts(const ovr_flat *r, const char *name, const char *about,
                    const char *const *texts)
{
    return write_variable(create(r, name, r->text), r->text, texts, NULL,
                          about);
}

bool ovr_flat_note(const ovr_flat *r, const char *name, const char *key,
                   const char *text)
{
    hid_t set = H5Dopen2(r->file, name, H5P_DEFAULT);
    bool good = set >= 0 && ovr_h5_set_chars(set, key, text);
    return set >= 0 && H5Dclose(set) >= 0 && good;
}

bool ovr_flat_end(ovr_flat *r, const char *path, const char *title, bool good)
{
    int fd;
    good = good && ovr_h5_set_chars(r->file, "Conventions", "CF-1.8") &&
           ovr_h5_set_chars(r->file, "title", title) &&
           ovr_h5_set_chars(r->file, "source", "overroll " OVERROLL_VERSION);
    ovr_h5_drop(r->scale);
    ovr_h5_drop(r->text);
    ovr_h5_drop(r->properties);
    ovr_h5_drop(r->space);
    good = r->file >= 0 && H5Fclose(r->file) >= 0 && good;
    fd = good ? open(path, O_RDONLY | O_CLOEXEC) : -1;
    good = fd >= 0 && fsync(fd) == 0;
    if (fd >= 0)
        close(fd);
    return good;
}
