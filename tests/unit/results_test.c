/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Result files: data are read as they were written, to the bit if stored in
 * full precision. */
#include "support/test.h"

#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "results/results.h"
#include "support/dent.h"

enum { NODES = 225, STEPS = 40 };

static ovr_write_options options_for(const char *path)
{
    ovr_write_options o = ovr_write_options_default();
    o.path = path;
    o.every_steps = 4;
    o.end = 1;
    o.case_text = "[contact]\nM = 20\n";
    return o;
}

/* Writes steps 0 to `steps` of the dent; leaves it at the last one. */
static void write_run(const ovr_write_options *o, const ovr_contact *contact,
                      test_dent *dent, long steps)
{
    ovr_error err = {0};
    ovr_writer *w = ovr_writer_create(o, contact, dent->n, dent->X, NULL, &err);
    assert_true(w || (print_error("%s\n", err.message), 0));
    for (long k = 0; k <= steps; k++) {
        test_dent_move(dent, k);
        CHECK_OK(ovr_writer_record(w, &dent->frame, &err), &err);
    }
    CHECK_OK(ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err), &err);
}

static ovr_result *open_result(const char *path)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    if (!r)
        fail_msg("%s", err.message);
    return r;
}

static void check_field(ovr_result *r, const char *name, size_t k,
                        ovr_units units, const double *expected, double factor,
                        double tolerance)
{
    double values[NODES];
    ovr_error err = {0};
    CHECK_OK(ovr_result_snapshot(r, name, k, units, values, &err), &err);
    for (size_t i = 0; i < NODES; i++)
        CHECK_NEAR(values[i], expected[i] * factor,
                   tolerance * fabs(expected[i] * factor) +
                       (tolerance > 1e-10 ? 1e-40 : 0));
}

static void every_snapshot(ovr_result *r, test_dent *d, double tolerance)
{
    for (size_t k = 0; k < ovr_result_get_info(r)->snapshots; k++) {
        test_dent_move(d, 4 * (long)k);
        check_field(r, "pressure", k, OVR_AS_STORED, d->P, 1, tolerance);
        check_field(r, "film_thickness", k, OVR_AS_STORED, d->H, 1, tolerance);
        check_field(r, "roughness", k, OVR_AS_STORED, d->S, 1, tolerance);
    }
}

static void check_history(ovr_result *r, test_dent *d)
{
    double T[STEPS + 1], cycles[STEPS + 1], spike[STEPS + 1];
    ovr_error err = {0};
    CHECK_OK(ovr_result_history(r, "time", OVR_HERTZIAN, T, &err), &err);
    CHECK_OK(ovr_result_history(r, "cycles", OVR_HERTZIAN, cycles, &err), &err);
    CHECK_OK(ovr_result_history(r, "spike_pressure", OVR_HERTZIAN, spike, &err),
             &err);
    for (long k = 0; k <= STEPS; k++) {
        test_dent_move(d, k);
        CHECK_NEAR(T[k], d->seen.T, 0);
        assert_int_equal((int)cycles[k], d->seen.cycles);
        assert_int_equal(isnan(spike[k]) != 0,
                         isnan(d->seen.P_spike_located) != 0);
    }
}

TEST_IN_FOLDER(returns_what_was_written)
{
    const char *path = test_path(*state, "a.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    const ovr_result_info *info;
    test_dent d;
    ovr_result *r;
    test_dent_init(&d, NODES, 0);
    for (int variant = 0; variant < 4; variant++) {
        o.single = variant & 1;
        o.no_thread = variant & 2;
        o.force = variant > 0;
        write_run(&o, &contact, &d, STEPS);
        r = open_result(path);
        info = ovr_result_get_info(r);
        assert_string_equal(info->status, "complete");
        assert_string_equal(info->case_text, o.case_text);
        assert_int_equal(info->nodes, NODES);
        assert_int_equal(info->snapshots, STEPS / 4 + 1);
        assert_int_equal(info->steps, STEPS + 1);
        assert_false(info->physical);
        every_snapshot(r, &d, o.single ? 6e-8 : 0);
        check_history(r, &d);
        ovr_result_close(r);
    }
    test_dent_free(&d);
}

TEST_IN_FOLDER(converts_units)
{
    const char *path = test_path(*state, "si.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_physical();
    double x[NODES];
    test_dent d;
    ovr_result *r;
    ovr_error err;
    test_dent_init(&d, NODES, 0);
    write_run(&o, &contact, &d, STEPS);
    r = open_result(path);
    assert_true(ovr_result_get_info(r)->physical);
    assert_string_equal(ovr_result_field(r, 0)->unit, "Pa");
    assert_string_equal(ovr_result_field(r, 1)->unit, "m");
    check_field(r, "pressure", STEPS / 4, OVR_SI, d.P, contact.ph, 1e-15);
    check_field(r, "pressure", STEPS / 4, OVR_AS_STORED, d.P, contact.ph, 0);
    check_field(r, "film_thickness", STEPS / 4, OVR_HERTZIAN, d.H, 1, 1e-15);
    CHECK_OK(ovr_result_x(r, OVR_SI, x, &err), &err);
    CHECK_CLOSE(x[NODES - 1], 1.5 * contact.b, 1e-14);
    CHECK_CLOSE(ovr_result_get_info(r)->end, 1, 1e-14);
    ovr_result_close(r);
    test_dent_free(&d);
}

TEST_IN_FOLDER(refuses_si_without_scales)
{
    const char *path = test_path(*state, "bare.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    double values[NODES];
    test_dent d;
    ovr_result *r;
    ovr_error err;
    test_dent_init(&d, NODES, 0);
    write_run(&o, &contact, &d, 4);
    r = open_result(path);
    assert_int_equal(
        ovr_result_snapshot(r, "pressure", 0, OVR_SI, values, &err),
        OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "pressure");
    assert_int_equal(
        ovr_result_snapshot(r, "temperature", 0, OVR_SI, values, &err),
        OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "temperature");
    assert_int_equal(
        ovr_result_snapshot(r, "pressure", 2, OVR_AS_STORED, values, &err),
        OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "no snapshot 2");
    ovr_result_close(r);
    test_dent_free(&d);
}

/* All fields, a window, every third node. */
TEST_IN_FOLDER(stores_what_is_chosen)
{
    const char *path = test_path(*state, "chosen.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    double x[NODES], flow[NODES], dry[NODES];
    size_t first = 82, nodes; /* X = -1.99 is node 82 of 225 */
    test_dent d;
    ovr_result *r;
    ovr_error err;
    test_dent_init(&d, NODES, 0);
    o.fields = 0x7f;
    o.x_from = -1.99;
    o.x_to = 1.2;
    o.stride = 3;
    write_run(&o, &contact, &d, STEPS);
    r = open_result(path);
    nodes = ovr_result_get_info(r)->nodes;
    assert_int_equal(ovr_result_fields(r), 7);
    CHECK_OK(ovr_result_x(r, OVR_AS_STORED, x, &err), &err);
    CHECK_OK(ovr_result_snapshot(r, "mass_flow", STEPS / 4, OVR_AS_STORED, flow,
                                 &err),
             &err);
    CHECK_OK(
        ovr_result_snapshot(r, "cavitated", STEPS / 4, OVR_HERTZIAN, dry, &err),
        &err);
    assert_true(d.X[first - 1] < -1.99 && d.X[first] >= -1.99);
    assert_true(x[nodes - 1] <= 1.2 && x[nodes - 1] > 1.2 - 3 * d.D);
    for (size_t k = 0; k < nodes; k++) {
        size_t i = first + 3 * k;
        CHECK_NEAR(x[k], d.X[i], 0);
        CHECK_NEAR(flow[k], (d.flow[i - 1] + d.flow[i]) / 2, 0);
        assert_int_equal((int)dry[k], d.P[i] <= 0);
    }
    ovr_result_close(r);
    test_dent_free(&d);
}

/* The kind of a variable that is a field is another than that of the number in
 * the history that has its name. */
TEST_IN_FOLDER(stores_the_kind_of_each_variable)
{
    const char *path = test_path(*state, "kinds.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    test_dent d;
    test_dent_init(&d, NODES, 0);
    o.fields = 0x7f;
    write_run(&o, &contact, &d, 4);
    ovr_result *r = open_result(path);
    assert_int_equal(ovr_result_find(r, "mass_flow")->kind, OVR_KIND_FLOW);
    assert_int_equal(ovr_result_find(r, "history/mass_flow")->kind,
                     OVR_KIND_NUMBER);
    assert_int_equal(ovr_result_find(r, "history/rigid_approach")->kind,
                     OVR_KIND_HEIGHT);
    ovr_result_close(r);
    test_dent_free(&d);
}

/* What a later version may store: three dimensions, in a group in a group. */
static void add_stresses(const char *path, double values[2][3][5])
{
    const hsize_t shape[3] = {2, 3, 5}, chunk[3] = {1, 3, 5};
    hid_t access = H5Pcreate(H5P_FILE_ACCESS);
    herr_t bounds = H5Pset_libver_bounds(access, H5F_LIBVER_V18,
                                         H5F_LIBVER_V18);
    hid_t file = H5Fopen(path, H5F_ACC_RDWR, access);
    hid_t above = H5Gcreate2(file, "stress", H5P_DEFAULT, H5P_DEFAULT,
                             H5P_DEFAULT);
    hid_t group = H5Gcreate2(above, "surface_1", H5P_DEFAULT, H5P_DEFAULT,
                             H5P_DEFAULT);
    hid_t space = H5Screate_simple(3, shape, NULL);
    hid_t creation = H5Pcreate(H5P_DATASET_CREATE), set;
    H5Pset_chunk(creation, 3, chunk);
    H5Pset_shuffle(creation);
    H5Pset_deflate(creation, 1);
    set = H5Dcreate2(group, "sigma_x", H5T_IEEE_F64LE, space, H5P_DEFAULT,
                     creation, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(set);
    set = H5Dcreate2(group, "plain", H5T_IEEE_F64LE, space, H5P_DEFAULT,
                     H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(set);
    assert_true(bounds >= 0);
    H5Pclose(access);
    H5Pclose(creation);
    H5Sclose(space);
    H5Gclose(group);
    H5Gclose(above);
    assert_true(H5Fclose(file) >= 0);
}

TEST_IN_FOLDER(reads_any_rank)
{
    static const char *const names[] = {"stress/surface_1/sigma_x",
                                        "stress/surface_1/plain"};
    const char *path = test_path(*state, "deep.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    double values[2][3][5], found[3][5];
    ovr_error err = {0};
    uint64_t seed = 7;
    test_dent d;
    ovr_result *r;
    test_dent_init(&d, NODES, 0);
    write_run(&o, &contact, &d, 4);
    for (size_t k = 0; k < 30; k++)
        (&values[0][0][0])[k] = test_random(&seed, -1, 1);
    add_stresses(path, values);
    r = open_result(path);
    assert_int_equal(ovr_result_fields(r), 3);
    for (size_t j = 0; j < 2; j++) {
        const ovr_variable *v = ovr_result_find(r, names[j]);
        assert_true(v && v->rank == 3 && v->shape[0] == 2 && v->shape[2] == 5);
        for (size_t k = 0; k < 2; k++) {
            CHECK_OK(
                ovr_result_read(r, names[j], k, OVR_AS_STORED, found[0], &err),
                &err);
            assert_memory_equal(found, values[k], sizeof found);
        }
        assert_int_equal(
            ovr_result_read(r, names[j], 2, OVR_AS_STORED, found[0], &err),
            OVR_BAD_INPUT);
    }
    ovr_result_close(r);
    test_dent_free(&d);
}

TEST_IN_FOLDER(lists_times)
{
    const char *path = test_path(*state, "times.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    const double target[] = {0.21, 0.05, 0.4}, at[] = {0, .05, .25, .4, .5, .5};
    double T[8];
    test_dent d;
    ovr_result *r;
    ovr_error err;
    test_dent_init(&d, NODES, 0.05);
    o.every_steps = 0;
    o.every_time = 0.25;
    o.times = target;
    o.time_count = 3;
    write_run(&o, &contact, &d, 10);
    r = open_result(path);
    assert_int_equal(ovr_result_get_info(r)->snapshots, 5);
    CHECK_OK(ovr_result_times(r, OVR_AS_STORED, T, &err), &err);
    for (int k = 0; k < 5; k++)
        CHECK_NEAR(T[k], at[k], 1e-12);
    ovr_result_close(r);
    test_dent_free(&d);
}

TEST_IN_FOLDER(names_the_next_time)
{
    ovr_write_options o = options_for(test_path(*state, "next.h5"));
    ovr_contact contact = test_contact_bare();
    const double target[] = {0.3, 0.1};
    ovr_error err;
    test_dent d;
    ovr_writer *w;
    test_dent_init(&d, NODES, 0);
    o.every_time = 0.25;
    o.times = target;
    o.time_count = 2;
    w = ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err);
    assert_non_null(w);
    CHECK_NEAR(ovr_writer_next_time(w, 0), 0.1, 0);
    CHECK_NEAR(ovr_writer_next_time(w, 0.1), 0.25, 0);
    CHECK_NEAR(ovr_writer_next_time(w, 0.25), 0.3, 0);
    CHECK_NEAR(ovr_writer_next_time(w, 0.3), 0.5, 0);
    CHECK_OK(ovr_writer_close(w, OVR_RUN_STOPPED, NULL, &err), &err);
    test_dent_free(&d);
}

static void check_refused(const char *path, const char *part)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    assert_null(r);
    CHECK_ERROR(&err, OVR_BAD_INPUT, part);
}

TEST_IN_FOLDER(refuses_other_files)
{
    const char *path = test_path(*state, "other.h5");
    hid_t file;
    check_refused(path, "No such file");
    test_write_text(path, "x,y\n1,2\n");
    check_refused(path, "not an HDF5 file");
    file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    H5Fclose(file);
    check_refused(path, "not a result of overroll");
}

/* Cut anywhere, a file gives a clean error (or, cut behind its last byte in
 * use, its content). */
TEST_IN_FOLDER(survives_truncation)
{
    const char *path = test_path(*state, "whole.h5");
    const char *cut = test_path(*state, "cut.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    size_t bytes;
    char *data;
    test_dent d;
    test_dent_init(&d, NODES, 0);
    write_run(&o, &contact, &d, STEPS);
    data = test_read(path, &bytes);
    for (size_t at = 0; at < bytes; at += 1 + bytes / 80) {
        ovr_error err = {0};
        ovr_result *r;
        test_write(cut, data, at);
        r = ovr_result_open(cut, NULL, &err);
        assert_null(r);
        CHECK_ERROR(&err, OVR_BAD_INPUT, "cut.h5");
    }
    free(data);
    test_dent_free(&d);
}

/* A title from a stranger: nothing in it commands a terminal; the lines of the
 * case stay. */
TEST_IN_FOLDER(shows_no_controls)
{
    const char *path = test_path(*state, "rude.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    test_dent d;
    ovr_result *r;
    o.title = "a\033]0;b\a\xc2\x9b"
              "c\nd\x7f\xc3\xbc";
    o.case_text = "[contact]\n\tM = 20 # \033[2J\n";
    test_dent_init(&d, NODES, 0);
    write_run(&o, &contact, &d, 0);
    r = open_result(path);
    assert_string_equal(ovr_result_get_info(r)->title,
                        "a\\x1b]0;b\\x07\\xc2\\x9bc\\x0ad\\x7f\xc3\xbc");
    assert_string_equal(ovr_result_get_info(r)->case_text,
                        "[contact]\n\tM = 20 # \\x1b[2J\n");
    ovr_result_close(r);
    test_dent_free(&d);
}

/* A link that somebody laid where the file grows leads nowhere. */
TEST_IN_FOLDER(follows_no_link_at_its_part)
{
    const char *path = test_path(*state, "new.h5");
    const char *victim = test_path(*state, "victim");
    const char *const part[] = {"new.h5.part", "new.h5.journal",
                                "new.h5.restart.part"};
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    test_dent d;
    test_dent_init(&d, NODES, 0);
    for (size_t k = 0; k < 3; k++) {
        char link[400];
        char *text;
        ovr_error err = {0};
        snprintf(link, sizeof link, "%s/%s", (char *)*state, part[k]);
        test_write_text(victim, "precious");
        assert_int_equal(symlink(victim, link), 0);
        assert_null(ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err));
        CHECK_ERROR(&err, OVR_BAD_INPUT, "new.h5");
        text = test_read(victim, NULL);
        assert_string_equal(text, "precious");
        free(text);
        unlink(link);
    }
    test_dent_free(&d);
}

TEST_IN_FOLDER(leaves_the_callers_handler)
{
    H5E_auto2_t function, after;
    void *data, *data_after;
    ovr_error err;
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    assert_null(ovr_result_open("/nowhere/at/all.h5", NULL, &err));
    H5Eget_auto2(H5E_DEFAULT, &after, &data_after);
    assert_ptr_equal(function, after);
    assert_ptr_equal(data, data_after);
}

TEST_IN_FOLDER(keeps_existing_files)
{
    const char *path = test_path(*state, "kept.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_bare();
    ovr_error err = {0};
    test_dent d;
    char *text;
    test_dent_init(&d, NODES, 0);
    test_write_text(path, "precious");
    assert_null(ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "exists");
    text = test_read(path, NULL);
    assert_string_equal(text, "precious");
    free(text);
    o.path = test_path(*state, "no/such/folder.h5");
    assert_null(ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "folder.h5");
    test_dent_free(&d);
}
