/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The file of all passes: a netCDF-4 file of one dimension, `pass`, with a row
 * for each, the names of their files, and the case.  It is small, and written
 * whole each time. */
#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "case/case.h"
#include "overroll/version.h"
#include "results/h5.h"
#include "results/hdf5read/hdf5read.h"
#include "results/header.h"
#include "results/layout.h"
#include "run/passes.h"

static const struct {
    const char *name, *long_name;
    ovr_unit_kind kind;
} columns[OVR_PASS_COLUMNS] = {
    [OVR_PASS_FILM] = {"central_film_thickness",
                       "film thickness at the centre, mean over the pass",
                       OVR_KIND_HEIGHT},
    [OVR_PASS_LEAST_CENTRAL] = {"least_central_film_thickness",
                                "the smallest of it", OVR_KIND_HEIGHT},
    [OVR_PASS_LEAST] = {"min_film_thickness",
                        "smallest film thickness of the pass", OVR_KIND_HEIGHT},
    [OVR_PASS_PRESSURE] = {"max_pressure", "largest pressure of the pass",
                           OVR_KIND_PRESSURE},
    [OVR_PASS_FILM_RATIO] = {"film_ratio",
                             "central film over that of the flooded steady "
                             "contact, mean",
                             OVR_KIND_NUMBER},
    [OVR_PASS_MENISCUS] = {"meniscus",
                           "where the film begins, mean; none: flooded",
                           OVR_KIND_LENGTH},
    [OVR_PASS_SUPPLY] = {"supply", "oil that arrives, rho H, mean",
                         OVR_KIND_HEIGHT},
    [OVR_PASS_SUPPLY_RATIO] = {"supply_ratio",
                               "the same over what the flooded steady contact "
                               "takes",
                               OVR_KIND_NUMBER},
    [OVR_PASS_INFLOW] = {"inflow", "mass flow at the inlet, mean",
                         OVR_KIND_FLOW},
    [OVR_PASS_OUTFLOW] = {"outflow", "mass flow at the outlet, mean",
                          OVR_KIND_FLOW},
    [OVR_PASS_LOST] = {"oil_lost",
                       "of that, what does not come to the next pass",
                       OVR_KIND_FLOW},
    [OVR_PASS_WAITING] = {"oil_waiting", "oil before the inlet at the end",
                          OVR_KIND_AREA},
    [OVR_PASS_STEPS] = {"steps", "time steps", OVR_KIND_COUNT},
    [OVR_PASS_LOAD] = {"load_ratio", "load over the nominal one, mean",
                       OVR_KIND_NUMBER},
    [OVR_PASS_FILM_ERROR] = {"central_film_thickness_error",
                             "its estimated error of discretization",
                             OVR_KIND_HEIGHT},
    [OVR_PASS_LEAST_ERROR] = {"min_film_thickness_error",
                              "its estimated error of discretization",
                              OVR_KIND_HEIGHT},
    [OVR_PASS_PRESSURE_ERROR] = {"max_pressure_error",
                                 "its estimated error of discretization",
                                 OVR_KIND_PRESSURE},
    [OVR_PASS_MENISCUS_ERROR] = {"meniscus_error",
                                 "its estimated error of discretization",
                                 OVR_KIND_LENGTH},
    [OVR_PASS_LENGTH] = {"equivalent_length",
                         "length of smooth raceway with the risk that is added",
                         OVR_KIND_LENGTH},
    [OVR_PASS_RISK] = {"risk_smooth", "risk of a length of smooth raceway",
                       OVR_KIND_NUMBER},
    [OVR_PASS_RATIO] = {"life_ratio",
                        "life over that of the smooth raceway, of passes like "
                        "this one alone",
                        OVR_KIND_NUMBER},
    [OVR_PASS_TOGETHER] = {"life_ratio_together",
                           "the same of all passes up to this one, again and "
                           "again",
                           OVR_KIND_NUMBER}};

typedef struct table {
    const ovr_run *run;
    size_t count;
    double *values;     /* a column */
    const char **texts; /* the same */
    hid_t file, space, properties, text, scale;
} table;

static hid_t create(const table *t, const char *name, hid_t type)
{
    hid_t set = H5Dcreate2(t->file, name, type, t->space, H5P_DEFAULT,
                           t->properties, H5P_DEFAULT);
    if (set >= 0 && t->scale >= 0 && H5DSattach_scale(set, t->scale, 0) < 0) {
        H5Dclose(set);
        return -1;
    }
    return set;
}

static bool put_scale(table *t)
{
    for (size_t i = 0; i < t->count; i++)
        t->values[i] = (double)i + 1;
    t->scale = create(t, "pass", H5T_STD_I32LE);
    return t->scale >= 0 && H5DSset_scale(t->scale, "pass") >= 0 &&
           H5Dwrite(t->scale, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    t->values) >= 0 &&
           ovr_h5_set_chars(t->scale, "long_name", "number of the pass");
}

static bool put_numbers(const table *t, ovr_pass_column k)
{
    const ovr_scales scales = ovr_scales_of(t->run->setup->contact);
    double factor = ovr_factor(&scales, columns[k].kind);
    hid_t set = create(t, columns[k].name, H5T_IEEE_F64LE);
    bool good;
    for (size_t i = 0; i < t->count; i++)
        t->values[i] = t->run->passes->row[i].value[k] * factor;
    good = set >= 0 &&
           H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    t->values) >= 0 &&
           ovr_h5_set_chars(set, "units", ovr_unit(&scales, columns[k].kind)) &&
           ovr_h5_set_chars(set, "long_name", columns[k].long_name);
    return set >= 0 && H5Dclose(set) >= 0 && good;
}

static bool put_texts(const table *t, const char *name, const char *about)
{
    hid_t set = create(t, name, t->text);
    bool good = set >= 0 &&
                H5Dwrite(set, t->text, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                         t->texts) >= 0 &&
                ovr_h5_set_chars(set, "long_name", about);
    return set >= 0 && H5Dclose(set) >= 0 && good;
}

/* Errors and lives are columns where they are known. */
static bool is_wanted(const table *t, ovr_pass_column k)
{
    bool wanted = k < OVR_PASS_FILM_ERROR;
    for (size_t i = 0; i < t->count; i++)
        wanted = wanted || isfinite(t->run->passes->row[i].value[k]);
    return wanted;
}

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static bool put_names(const table *t)
{
    const ovr_passes *p = t->run->passes;
    for (size_t i = 0; i < t->count; i++)
        t->texts[i] = base_name(p->file[i]);
    if (!put_texts(t, "file", "result file of the pass"))
        return false;
    for (size_t i = 0; i < t->count; i++)
        t->texts[i] = p->row[i].status;
    return put_texts(t, "status", "how that file stands");
}

static bool put_case(const table *t)
{
    const char *text = ovr_case_text(t->run->c, NULL);
    const char *folder = ovr_case_directory(t->run->c);
    hid_t group = ovr_header_group(t->file, "case");
    bool good = group >= 0 && text && ovr_h5_set_string(group, "text", text) &&
                ovr_h5_set_string(group, "path", folder ? folder : "");
    ovr_h5_drop(group);
    return good;
}

static bool put_all(table *t, const char *status)
{
    const char *title = t->run->setup->output->title;
    bool good = put_scale(t) && put_names(t) && put_case(t) &&
                ovr_h5_set_chars(t->file, "Conventions", "CF-1.8") &&
                ovr_h5_set_chars(t->file, "title",
                                 title ? title : "passes of a line contact") &&
                ovr_h5_set_chars(t->file, "source",
                                 "overroll " OVERROLL_VERSION) &&
                ovr_h5_set_string(t->file, "status", status);
    for (ovr_pass_column k = 0; good && k < OVR_PASS_COLUMNS; k++)
        good = !is_wanted(t, k) || put_numbers(t, k);
    return good;
}

/* netCDF-4 wants links and attributes in order of creation. */
static void prepare(table *t, const char *path)
{
    const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hsize_t count = t->count;
    hid_t access = ovr_h5_access(), creation = ovr_header_creation();
    t->file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access);
    t->space = H5Screate_simple(1, &count, NULL);
    t->properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_attr_creation_order(t->properties, order);
    t->text = H5Tcopy(H5T_C_S1);
    H5Tset_size(t->text, H5T_VARIABLE);
    H5Tset_cset(t->text, H5T_CSET_UTF8);
    ovr_h5_drop(creation);
    ovr_h5_drop(access);
}

static bool write_part(table *t, const char *part, const char *status)
{
    bool good;
    int fd;
    prepare(t, part);
    good = t->file >= 0 && put_all(t, status);
    ovr_h5_drop(t->scale);
    ovr_h5_drop(t->text);
    ovr_h5_drop(t->properties);
    ovr_h5_drop(t->space);
    good = t->file >= 0 && H5Fclose(t->file) >= 0 && good;
    fd = good ? open(part, O_RDONLY | O_CLOEXEC) : -1;
    good = fd >= 0 && fsync(fd) == 0;
    if (fd >= 0)
        close(fd);
    return good;
}

ovr_status ovr_passes_write(const ovr_run *run, const char *status,
                            ovr_error *err)
{
    const ovr_passes *p = run->passes;
    ovr_arena arena = ovr_arena_make(&run->arena.allocator);
    table t = {.run = run, .count = (size_t)p->rows, .scale = -1};
    ovr_h5_handler before = ovr_h5_quiet();
    char part[4500];
    bool good;
    errno = 0;
    snprintf(part, sizeof part, "%.4400s.part", p->path);
    t.values = ovr_arena_take(&arena, t.count, sizeof *t.values, err);
    t.texts = ovr_arena_take(&arena, t.count, sizeof *t.texts, err);
    good = t.values && t.texts && write_part(&t, part, status) &&
           rename(part, p->path) == 0;
    if (!good)
        unlink(part);
    ovr_h5_restore(before);
    ovr_arena_release(&arena);
    return good ? OVR_OK
                : ovr_fail(err, OVR_IO, "%s: cannot be written%s%s", p->path,
                           errno ? ": " : "", errno ? strerror(errno) : "");
}

/* ----------------------------------------------------------------- reading */

/* What the file says of itself. */
typedef struct told {
    const char *text, *folder, *status; /* of the case; of the passes */
} told;

/* false: no file of passes. */
static bool read_told(const char *path, ovr_arena *arena, told *t)
{
    ovr_container c;
    ovr_dataset pass;
    uint64_t object;
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    bool good = fd >= 0 &&
                ovr_container_open(&c, fd, arena) == OVR_FOUND_CONTAINER &&
                ovr_container_find(&c, c.root, "pass", &object) &&
                ovr_container_dataset(&c, object, &pass) &&
                ovr_container_find(&c, c.root, "case", &object);
    *t = (told){NULL, NULL, NULL};
    if (good)
        *t = (told){ovr_container_text(&c, object, "text"),
                    ovr_container_text(&c, object, "path"),
                    ovr_container_text(&c, c.root, "status")};
    if (fd >= 0)
        close(fd);
    return t->text != NULL;
}

bool ovr_passes_file_is(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    told t;
    bool is = read_told(path, &arena, &t);
    ovr_arena_release(&arena);
    return is;
}

bool ovr_passes_file_complete(const char *path)
{
    ovr_arena arena = ovr_arena_make(NULL);
    told t;
    bool complete = read_told(path, &arena, &t) && t.status &&
                    strcmp(t.status, "complete") == 0;
    ovr_arena_release(&arena);
    return complete;
}

ovr_case *ovr_passes_case(const char *path, const ovr_allocator *allocator,
                          ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    told t;
    ovr_case *c = NULL;
    if (read_told(path, &arena, &t))
        c = ovr_case_read_stored(t.text, path,
                                 t.folder && *t.folder ? t.folder : NULL,
                                 allocator, err);
    else
        ovr_fail(err, OVR_BAD_INPUT, "%s: is no file of passes", path);
    ovr_arena_release(&arena);
    return c;
}
