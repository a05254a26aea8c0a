/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/h5.h"

#include <string.h>

ovr_h5_handler ovr_h5_quiet(void)
{
    ovr_h5_handler before = {NULL, NULL};
    H5Eget_auto2(H5E_DEFAULT, &before.function, &before.data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return before;
}

void ovr_h5_restore(ovr_h5_handler before)
{
    H5Eclear2(H5E_DEFAULT);
    H5Eset_auto2(H5E_DEFAULT, before.function, before.data);
}

void ovr_h5_drop(hid_t id)
{
    if (id > 0)
        H5Idec_ref(id);
}

hid_t ovr_h5_access(void)
{
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
#if H5_VERSION_GE(1, 10, 7) &&                                                 \
    !(H5_VERS_MAJOR == 1 && H5_VERS_MINOR == 12 && H5_VERS_RELEASE == 0)
    H5Pset_file_locking(access, 0, 1);
#endif
    return access;
}

/* Returns a type of `length` characters, or of variable-length strings (length
 * 0). */
static hid_t text_type(size_t length)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, length ? length : H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    return type;
}

static bool set(hid_t object, const char *name, hid_t type, hid_t memory_type,
                const void *value)
{
    hid_t space = H5Screate(H5S_SCALAR);
    hid_t attribute = H5Acreate2(object, name, type, space, H5P_DEFAULT,
                                 H5P_DEFAULT);
    bool ok = attribute >= 0 && H5Awrite(attribute, memory_type, value) >= 0;
    ovr_h5_drop(attribute);
    ovr_h5_drop(space);
    return ok;
}

bool ovr_h5_set_chars(hid_t object, const char *name, const char *text)
{
    size_t length = strlen(text);
    hid_t type = text_type(length ? length : 1);
    bool ok = set(object, name, type, type, text);
    ovr_h5_drop(type);
    return ok;
}

bool ovr_h5_set_string(hid_t object, const char *name, const char *text)
{
    hid_t type = text_type(0);
    bool ok = set(object, name, type, type, &text);
    ovr_h5_drop(type);
    return ok;
}

bool ovr_h5_set_number(hid_t object, const char *name, double value)
{
    return set(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

bool ovr_h5_set_integer(hid_t object, const char *name, int value)
{
    return set(object, name, H5T_STD_I32LE, H5T_NATIVE_INT, &value);
}

/* Opens an attribute if it exists; otherwise returns a negative identifier. */
static hid_t open_attribute(hid_t object, const char *name)
{
    if (H5Aexists(object, name) <= 0)
        return -1;
    return H5Aopen(object, name, H5P_DEFAULT);
}

/* Replaces a variable-length text, which is stored in a heap. HDF5 creates a
 * new heap (4 kB) unless one with free space is cached; reading the old text
 * caches its heap. */
bool ovr_h5_change_string(hid_t object, const char *name, const char *text)
{
    hid_t attribute = open_attribute(object, name);
    hid_t type = text_type(0);
    char *old = NULL;
    bool ok = attribute >= 0 && H5Aread(attribute, type, &old) >= 0 &&
              H5free_memory(old) >= 0 && H5Awrite(attribute, type, &text) >= 0;
    ovr_h5_drop(type);
    ovr_h5_drop(attribute);
    return ok;
}

bool ovr_h5_change_number(hid_t object, const char *name, double value)
{
    hid_t attribute = open_attribute(object, name);
    bool ok = attribute >= 0 &&
              H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value) >= 0;
    ovr_h5_drop(attribute);
    return ok;
}

bool ovr_h5_put_string(hid_t object, const char *name, const char *text)
{
    return ovr_h5_change_string(object, name, text) ||
           ovr_h5_set_string(object, name, text);
}

bool ovr_h5_put_number(hid_t object, const char *name, double value)
{
    return ovr_h5_change_number(object, name, value) ||
           ovr_h5_set_number(object, name, value);
}
