/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A real run that is stopped and resumed ends with the same file: every dataset
 * and every attribute except dates, to the bit. */
#include "support/contact.h"
#include "support/hot.h"
#include "support/test.h"

#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"
#include "results/results.h"

enum { LEVEL = 4, NEVER = -1 };
static const double END = 3;

static void dent(void *data, double T, size_t n, const double *X, double *S)
{
    (void)data;
    for (size_t i = 0; i < n; i++) {
        double xi = (X[i] + 2 - T) / 0.5;
        S[i] = -0.1 * pow(10, -10 * xi * xi) * cos(2 * acos(-1) * xi);
    }
}

typedef struct bench {
    ovr_contact contact;
    ovr_simulation *sim;
    ovr_writer *writer;
    bool hot;
    double end;
    long stop; /* after this step, or NEVER */
} bench;

static ovr_status watch(void *data, const ovr_simulation *sim, ovr_error *err)
{
    bench *b = data;
    ovr_status status = ovr_writer_observe(b->writer, sim, err);
    if (status == OVR_OK && ovr_simulation_state(sim)->step == b->stop)
        return ovr_fail(err, OVR_STOPPED, "stopped");
    return status;
}

static void make_hot(bench *b)
{
    test_hot hot = test_hot_make(20, 10, 0.4, 5e6, NULL);
    b->contact = hot.contact;
    b->sim = test_hot_simulation(&hot, LEVEL);
}

static void make_isothermal(bench *b)
{
    ovr_error err = {0};
    ovr_conditions given = ovr_conditions_default();
    ovr_options options = test_options();
    ovr_lubricant lubricant;
    given.M = 20;
    given.L = 10;
    given.alpha = 1.7e-8;
    options.level = LEVEL;
    CHECK_OK(ovr_contact_resolve(&given, &b->contact, &err), &err);
    CHECK_OK(ovr_lubricant_make(&b->contact, OVR_ROELANDS, OVR_DOWSON_HIGGINSON,
                                1.98e8, NAN, &lubricant, &err),
             &err);
    b->sim = ovr_simulation_create(&b->contact, &lubricant, &options, NULL,
                                   &err);
    assert_non_null(b->sim);
}

static void make_simulation(bench *b)
{
    (b->hot ? make_hot : make_isothermal)(b);
    ovr_simulation_surface(b->sim, dent, NULL);
}

static ovr_write_options options_for(const char *path, double end)
{
    ovr_write_options o = ovr_write_options_default();
    o.path = path;
    o.every_steps = 3;
    o.fields = 0x7f;
    o.end = end;
    return o;
}

/* Marches until the end or b->stop and closes. */
static void finish(bench *b)
{
    ovr_error err = {0};
    ovr_observer look = {watch, NULL, b};
    ovr_march march = {.end = b->end, .count = 1, .observers = &look};
    bool stops = b->stop != NEVER;
    ovr_status status;
    ovr_writer_checkpoints(b->writer, b->sim);
    status = ovr_simulation_march(b->sim, &march, &err);
    CHECK_STATUS(status, stops ? OVR_STOPPED : OVR_OK, &err);
    CHECK_OK(ovr_writer_close(b->writer,
                              stops ? OVR_RUN_STOPPED : OVR_RUN_COMPLETE, NULL,
                              &err),
             &err);
    ovr_simulation_free(b->sim);
}

static void run(const char *path, bench b)
{
    ovr_error err = {0};
    ovr_write_options o = options_for(path, b.end);
    const ovr_state *state;
    make_simulation(&b);
    CHECK_OK(ovr_simulation_steady(b.sim, &err), &err);
    state = ovr_simulation_state(b.sim);
    b.writer = ovr_writer_create(&o, &b.contact, state->n, state->X, NULL,
                                 &err);
    assert_non_null(b.writer);
    finish(&b);
}

static void resume(const char *path, bench b)
{
    ovr_error err = {0};
    ovr_write_options o = options_for(path, b.end);
    ovr_restart *restart = ovr_restart_open(path, NULL, &err);
    const ovr_state *state;
    make_simulation(&b);
    assert_non_null(restart);
    CHECK_OK(ovr_restart_load(restart, b.sim, &err), &err);
    state = ovr_simulation_state(b.sim);
    b.writer = ovr_writer_resume(&o, &b.contact, state->n, state->X, restart,
                                 NULL, &err);
    if (!b.writer)
        fail_msg("%s", err.message);
    ovr_restart_close(restart);
    finish(&b);
}

/* ------------------------------------------------------ comparing two files */

/* Attributes as "object/name" lines with their bytes, in memory. */
typedef struct digest {
    size_t used;
    char text[400000];
} digest;

static void add_bytes(digest *d, const void *bytes, size_t count)
{
    assert_true(d->used + count < sizeof d->text);
    memcpy(d->text + d->used, bytes, count);
    d->used += count;
}

static herr_t add_attribute(hid_t object, const char *name,
                            const H5A_info_t *info, void *data)
{
    digest *d = data;
    hid_t attribute = H5Aopen(object, name, H5P_DEFAULT);
    hid_t type = H5Aget_type(attribute);
    (void)info;
    if (strncmp(name, "date_", 5) && strcmp(name, "history") &&
        strcmp(name, "DIMENSION_LIST") && strcmp(name, "REFERENCE_LIST")) {
        size_t size = H5Tget_size(type);
        char value[4096] = "", *text = NULL;
        assert_true(size <= sizeof value);
        add_bytes(d, name, strlen(name));
        if (H5Tis_variable_str(type) > 0) {
            H5Aread(attribute, type, &text);
            add_bytes(d, text, strlen(text));
            H5free_memory(text);
        } else {
            H5Aread(attribute, type, value);
            add_bytes(d, value, size);
        }
    }
    H5Tclose(type);
    H5Aclose(attribute);
    return 0;
}

static void add_dataset(digest *d, hid_t set)
{
    hid_t space = H5Dget_space(set), type = H5Dget_type(set);
    size_t bytes = (size_t)H5Sget_simple_extent_npoints(space) *
                   H5Tget_size(type);
    char *values = malloc(bytes + 1);
    assert_non_null(values);
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    add_bytes(d, values, bytes);
    free(values);
    H5Tclose(type);
    H5Sclose(space);
}

static herr_t add_object(hid_t file, const char *name, const H5O_info_t *info,
                         void *data)
{
    digest *d = data;
    hid_t object = H5Oopen(file, name, H5P_DEFAULT);
    add_bytes(d, name, strlen(name));
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, NULL, add_attribute, d);
    if (info->type == H5O_TYPE_DATASET)
        add_dataset(d, object);
    H5Oclose(object);
    return 0;
}

static digest *digest_of(const char *path)
{
    digest *d = calloc(1, sizeof *d);
    hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    assert_true(d && file >= 0);
    H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, add_object, d);
    H5Fclose(file);
    return d;
}

static void check_identical(const char *a, const char *b)
{
    digest *da = digest_of(a), *db = digest_of(b);
    assert_int_equal(da->used, db->used);
    assert_memory_equal(da->text, db->text, da->used);
    assert_true(da->used > 100000);
    free(da);
    free(db);
}

TEST_IN_FOLDER(ends_the_same)
{
    const char *whole = test_path(*state, "whole.h5");
    const char *parts = test_path(*state, "parts.h5");
    run(whole, (bench){.end = END, .stop = NEVER});
    run(parts, (bench){.end = END, .stop = 17});
    resume(parts, (bench){.end = END, .stop = 18});
    resume(parts, (bench){.end = END, .stop = 40});
    resume(parts, (bench){.end = END, .stop = NEVER});
    check_identical(whole, parts);
    resume(parts, (bench){.end = END, .stop = NEVER}); /* nothing left to do */
    check_identical(whole, parts);
}

/* Stopped in the steady start, before the first step is stored. */
TEST_IN_FOLDER(a_hot_start_is_resumed)
{
    const char *whole = test_path(*state, "whole.h5");
    const char *parts = test_path(*state, "parts.h5");
    const double end = 2;
    run(whole, (bench){.hot = true, .end = end, .stop = NEVER});
    run(parts, (bench){.hot = true, .end = end, .stop = 0});
    resume(parts, (bench){.hot = true, .end = end, .stop = 3});
    resume(parts, (bench){.hot = true, .end = end, .stop = NEVER});
    check_identical(whole, parts);
}
