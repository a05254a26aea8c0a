/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a study as a netCDF-4 file: one dimension, `case`, and a
 * variable over it for each value and each number of the summaries. */
#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <string.h>
#include <unistd.h>

#include "overroll/version.h"
#include "results/h5.h"
#include "run/sweep_table.h"

typedef struct netcdf {
    const ovr_sweep_table *t;
    hid_t file, space, properties, text, scale;
} netcdf;

static hid_t create(const netcdf *n, const char *name, hid_t type)
{
    hid_t set = H5Dcreate2(n->file, name, type, n->space, H5P_DEFAULT,
                           n->properties, H5P_DEFAULT);
    if (set >= 0 && n->scale >= 0 && H5DSattach_scale(set, n->scale, 0) < 0) {
        H5Dclose(set);
        return -1;
    }
    return set;
}

static bool close_set(hid_t set, bool good)
{
    return set >= 0 && H5Dclose(set) >= 0 && good;
}

static bool put_scale(netcdf *n, ovr_arena *arena)
{
    size_t count = n->t->s->tasks;
    int *number = ovr_arena_take(arena, count, sizeof *number, NULL);
    if (!number)
        return false;
    for (size_t i = 0; i < count; i++)
        number[i] = (int)i + 1;
    n->scale = create(n, "case", H5T_STD_I32LE);
    if (n->scale < 0 || H5DSset_scale(n->scale, "case") < 0 ||
        H5Dwrite(n->scale, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                 number) < 0)
        return false;
    return ovr_h5_set_chars(n->scale, "long_name", "number of the case");
}

static bool put_numbers(const netcdf *n, const char *name, const char *unit,
                        const char *about, const double *values)
{
    hid_t set = create(n, name, H5T_IEEE_F64LE);
    return close_set(set, set >= 0 &&
                              H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                                       H5P_DEFAULT, values) >= 0 &&
                              ovr_h5_set_chars(set, "units", unit) &&
                              ovr_h5_set_chars(set, "long_name", about));
}

static bool put_texts(const netcdf *n, const char *name, const char *about,
                      const char *const *texts)
{
    hid_t set = create(n, name, n->text);
    return close_set(set, set >= 0 &&
                              H5Dwrite(set, n->text, H5S_ALL, H5S_ALL,
                                       H5P_DEFAULT, texts) >= 0 &&
                              ovr_h5_set_chars(set, "long_name", about));
}

/* Unit of a key of the summaries: it is in its name. */
static const char *unit_of(const char *name)
{
    static const char *const units[][2] = {
        {"_N_per_m", "N/m"}, {"_m_per_s", "m/s"}, {"_Pa", "Pa"},
        {"_m", "m"},         {"_s", "s"},         {"seconds", "s"}};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        size_t end = strlen(units[i][0]);
        if (length >= end && !strcmp(name + length - end, units[i][0]))
            return units[i][1];
    }
    return "1";
}

/* What a key of the summaries means, as far as the lists say. */
static void explain(const netcdf *n, const char *key, char *text, size_t room)
{
    const ovr_extreme *e;
    const ovr_observable *o;
    bool run = false;
    for (size_t k = 0; k < n->t->columns; k++)
        run = run || !strcmp(n->t->column[k].name, "T_end");
    snprintf(text, room, "%s", key);
    for (size_t k = 0; (e = ovr_extreme_at(k)); k++)
        if (!strcmp(e->key, key) || (e->key_si && !strcmp(e->key_si, key)))
            snprintf(text, room, "%s", e->long_name);
    for (size_t k = 0; (o = ovr_observable_at(k)); k++)
        if ((o->key && !strcmp(o->key, key)) ||
            (o->key_si && !strcmp(o->key_si, key)))
            snprintf(text, room, "%s%s", run ? "at the end of the run: " : "",
                     o->long_name);
}

static bool put_values(const netcdf *n, const char **texts)
{
    const ovr_sweep_table *t = n->t;
    for (size_t k = 0; k < t->keys; k++) {
        const ovr_sweep_values *v = &t->values[k];
        for (size_t i = 0; i < t->s->tasks; i++)
            texts[i] = ovr_study_value(t->s, v->key, i);
        if (v->numeric ? !put_numbers(n, v->key->shown, v->unit, v->key->where,
                                      v->number)
                       : !put_texts(n, v->key->shown, v->key->where, texts))
            return false;
    }
    return true;
}

static bool put_all(netcdf *n, ovr_arena *arena)
{
    const ovr_sweep_table *t = n->t;
    const char **texts = ovr_arena_take(arena, t->s->tasks, sizeof *texts,
                                        NULL);
    bool good = texts && put_scale(n, arena) &&
                put_texts(n, "name", "name of the case's files",
                          (const char *const *)t->s->name);
    for (size_t i = 0; good && i < t->s->tasks; i++)
        texts[i] = ovr_sweep_state_name(t->state[i]);
    good = good && put_texts(n, "status", "how the case stands", texts) &&
           put_values(n, texts);
    for (size_t k = 0; good && k < t->columns; k++) {
        const ovr_sweep_column *c = &t->column[k];
        char about[160];
        explain(n, c->name, about, sizeof about);
        good = put_numbers(n, c->name, unit_of(c->name), about, c->value);
    }
    return good && ovr_h5_set_chars(n->file, "Conventions", "CF-1.8") &&
           ovr_h5_set_chars(n->file, "title", t->s->path) &&
           ovr_h5_set_chars(n->file, "source", "overroll " OVERROLL_VERSION);
}

/* netCDF-4 wants links and attributes in order of creation. */
static void prepare(netcdf *n, const char *path)
{
    const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hsize_t count = n->t->s->tasks;
    hid_t access = ovr_h5_access(), creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_link_creation_order(creation, order);
    H5Pset_attr_creation_order(creation, order);
    n->file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access);
    n->space = H5Screate_simple(1, &count, NULL);
    n->properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_attr_creation_order(n->properties, order);
    n->text = H5Tcopy(H5T_C_S1);
    H5Tset_size(n->text, H5T_VARIABLE);
    H5Tset_cset(n->text, H5T_CSET_UTF8);
    H5Pclose(creation);
    ovr_h5_drop(access);
}

ovr_status ovr_sweep_write_netcdf(const ovr_sweep_table *t, const char *path,
                                  ovr_error *err)
{
    netcdf n = {.t = t, .scale = -1};
    ovr_arena arena = ovr_arena_make(&t->arena.allocator);
    ovr_h5_handler before = ovr_h5_quiet();
    char part[4500];
    bool good;
    snprintf(part, sizeof part, "%.4400s.%ld.part", path, (long)getpid());
    prepare(&n, part);
    good = n.file >= 0 && put_all(&n, &arena);
    ovr_arena_release(&arena);
    ovr_h5_drop(n.scale);
    ovr_h5_drop(n.text);
    ovr_h5_drop(n.properties);
    ovr_h5_drop(n.space);
    good = n.file >= 0 && H5Fclose(n.file) >= 0 && good;
    ovr_h5_restore(before);
    if (good && rename(part, path) == 0)
        return OVR_OK;
    unlink(part);
    return ovr_fail(err, n.file < 0 ? OVR_BAD_INPUT : OVR_IO,
                    "%s: cannot be written", path);
}
