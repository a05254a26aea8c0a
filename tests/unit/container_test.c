/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reader of the HDF5 format compared with files written by the HDF5 library. */
#include "support/test.h"

#include <fcntl.h>
#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "results/hdf5read/hdf5read.h"
#include "results/hdf5read/heap.h"
#include "results/results.h"
#include "support/dent.h"

enum { NODES = 37 };

/* ------------------------------------------------------- made by the library
 */

static hid_t make_file(const char *path)
{
    unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hid_t access = H5Pcreate(H5P_FILE_ACCESS), file;
    hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);
    H5Pset_link_creation_order(creation, order);
    H5Pset_attr_creation_order(creation, order);
    file = H5Fcreate(path, H5F_ACC_TRUNC, creation, access);
    H5Pclose(creation);
    H5Pclose(access);
    assert_true(file >= 0);
    return file;
}

static double value_at(size_t row, size_t node)
{
    return (double)(row % 97) - 1.5 * (double)node;
}

/* rows x NODES (1 for a column), a row or `chunk` rows in a chunk. */
static void make_rows(hid_t file, const char *name, size_t rows, bool column,
                      hid_t type, hsize_t chunk, bool packed)
{
    size_t width = column ? 1 : NODES;
    hsize_t now[2] = {rows, width}, maximum[2] = {H5S_UNLIMITED, width};
    hsize_t part[2] = {chunk, width};
    double *values = calloc(rows * width + 1, sizeof *values);
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    hid_t space = H5Screate_simple(column ? 1 : 2, now, maximum), set;
    H5Pset_chunk(how, column ? 1 : 2, part);
    if (packed) {
        H5Pset_shuffle(how);
        H5Pset_deflate(how, 6);
    }
    for (size_t k = 0; k < rows * width; k++)
        values[k] = value_at(k / width, k % width);
    set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, how, H5P_DEFAULT);
    assert_true(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                         values) >= 0);
    H5Dclose(set);
    H5Sclose(space);
    H5Pclose(how);
    free(values);
}

static void set_attribute(hid_t object, const char *name, hid_t type,
                          const void *value)
{
    hid_t space = H5Screate(H5S_SCALAR);
    hid_t a = H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    assert_true(H5Awrite(a, type, value) >= 0);
    H5Aclose(a);
    H5Sclose(space);
}

/* ------------------------------------------------------------ read by us */

typedef struct look {
    ovr_container c;
    ovr_arena arena;
    int fd;
} look;

static ovr_found open_file(look *l, const char *path)
{
    l->arena = ovr_arena_make(NULL);
    l->fd = open(path, O_RDONLY);
    return ovr_container_open(&l->c, l->fd, &l->arena);
}

static void close_file(look *l)
{
    close(l->fd);
    ovr_arena_release(&l->arena);
}

static void check_rows(look *l, const char *name, size_t rows, bool column,
                       double rounding)
{
    double values[NODES];
    size_t width = column ? 1 : NODES;
    ovr_dataset set;
    uint64_t object;
    assert_true(ovr_container_find(&l->c, l->c.root, name, &object));
    assert_true(ovr_container_dataset(&l->c, object, &set));
    assert_int_equal(set.rank, column ? 1 : 2);
    assert_int_equal(set.shape[0], rows);
    for (size_t k = 0; k < rows; k++) {
        assert_true(ovr_container_values(&l->c, &set, k, width, values));
        for (size_t i = 0; i < width; i++)
            CHECK_NEAR(values[i], value_at(k, i), rounding);
        ovr_arena_release(&l->arena);
    }
    assert_false(ovr_container_values(&l->c, &set, rows, width, values));
}

/* Trees of one, two and three levels; every type, with filters and without. */
TEST_IN_FOLDER(reads_datasets)
{
    const char *path = test_path(*state, "sets.h5");
    const size_t rows[] = {1, 64, 65, 300, 5000};
    hid_t file = make_file(path);
    char name[32];
    look l;
    for (size_t k = 0; k < 5; k++) {
        snprintf(name, sizeof name, "packed%zu", k);
        make_rows(file, name, rows[k], false, H5T_IEEE_F64LE, 1, true);
        snprintf(name, sizeof name, "single%zu", k);
        make_rows(file, name, rows[k], false, H5T_IEEE_F32LE, 1, false);
        snprintf(name, sizeof name, "column%zu", k);
        make_rows(file, name, rows[k], true, H5T_STD_I32LE, 7, false);
    }
    H5Fclose(file);
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    for (size_t k = 0; k < 5; k++) {
        snprintf(name, sizeof name, "packed%zu", k);
        check_rows(&l, name, rows[k], false, 0);
        snprintf(name, sizeof name, "single%zu", k);
        check_rows(&l, name, rows[k], false, 0);
        snprintf(name, sizeof name, "column%zu", k);
        check_rows(&l, name, rows[k], true, 0);
    }
    close_file(&l);
}

static void make_attributes(hid_t file, int count)
{
    hid_t chars = H5Tcopy(H5T_C_S1), text = H5Tcopy(H5T_C_S1);
    H5Tset_size(chars, 5);
    H5Tset_size(text, H5T_VARIABLE);
    for (int k = 0; k < count; k++) {
        char name[16], value[16], *pointer = value;
        double number = k + 0.5;
        snprintf(name, sizeof name, "d%d", k);
        set_attribute(file, name, H5T_NATIVE_DOUBLE, &number);
        snprintf(name, sizeof name, "i%d", k);
        set_attribute(file, name, H5T_NATIVE_INT, &k);
        snprintf(value, sizeof value, "%05d", k);
        snprintf(name, sizeof name, "c%d", k);
        set_attribute(file, name, chars, value);
        snprintf(name, sizeof name, "t%d", k);
        set_attribute(file, name, text, &pointer);
    }
    H5Tclose(text);
    H5Tclose(chars);
}

static void check_attributes(look *l, int count)
{
    for (int k = 0; k<count; k += count> 50 ? 41 : 1) {
        char name[16], value[16];
        const char *found;
        snprintf(value, sizeof value, "%05d", k);
        snprintf(name, sizeof name, "d%d", k);
        CHECK_NEAR(ovr_container_number(&l->c, l->c.root, name), k + 0.5, 0);
        snprintf(name, sizeof name, "i%d", k);
        CHECK_NEAR(ovr_container_number(&l->c, l->c.root, name), k, 0);
        snprintf(name, sizeof name, "c%d", k);
        found = ovr_container_text(&l->c, l->c.root, name);
        assert_true(found && strcmp(found, value) == 0);
        snprintf(name, sizeof name, "t%d", k);
        found = ovr_container_text(&l->c, l->c.root, name);
        assert_true(found && strcmp(found, value) == 0);
        assert_true(isnan(ovr_container_number(&l->c, l->c.root, name)));
        ovr_arena_release(&l->arena);
    }
    assert_null(ovr_container_text(&l->c, l->c.root, "none"));
}

/* In the header itself, in one block of a heap, in a table of blocks. */
TEST_IN_FOLDER(reads_attributes)
{
    const char *path = test_path(*state, "attributes.h5");
    const int count[] = {0, 1, 2, 3, 40, 200};
    for (size_t k = 0; k < 6; k++) {
        look l;
        hid_t file = make_file(path);
        make_attributes(file, count[k]);
        H5Fclose(file);
        assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
        check_attributes(&l, count[k]);
        close_file(&l);
    }
}

TEST_IN_FOLDER(lists_links_in_order)
{
    const char *path = test_path(*state, "links.h5");
    const size_t count[] = {1, 8, 9, 200};
    for (size_t k = 0; k < 4; k++) {
        hid_t file = make_file(path);
        char name[16];
        ovr_link *links;
        size_t found;
        look l;
        for (size_t n = 0; n < count[k]; n++) {
            snprintf(name, sizeof name, "z%zu", (n * 7919) % 1000);
            make_rows(file, name, 1, true, H5T_IEEE_F64LE, 1, false);
        }
        H5Fclose(file);
        assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
        links = ovr_container_links(&l.c, l.c.root, &found);
        assert_int_equal(found, count[k]);
        for (size_t n = 0; n < found; n++) {
            snprintf(name, sizeof name, "z%zu", (n * 7919) % 1000);
            assert_string_equal(links[n].name, name);
        }
        close_file(&l);
    }
}

/* -------------------------------------------------------------- not followed
 */

static void make_elsewhere(hid_t file, const char *name, const char *path)
{
    hsize_t size = 4;
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    hid_t space = H5Screate_simple(1, &size, NULL);
    H5Pset_external(how, path, 0, H5F_UNLIMITED);
    H5Dclose(H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, how,
                        H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(how);
}

static void make_virtual(hid_t file, const char *name, const char *path)
{
    hsize_t size = 4;
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    hid_t space = H5Screate_simple(1, &size, NULL);
    H5Pset_virtual(how, space, path, "x", space);
    H5Dclose(H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, how,
                        H5P_DEFAULT));
    H5Sclose(space);
    H5Pclose(how);
}

static void make_filtered(hid_t file, const char *name)
{
    hsize_t size = 4;
    double values[4] = {1, 2, 3, 4};
    hid_t how = H5Pcreate(H5P_DATASET_CREATE);
    hid_t space = H5Screate_simple(1, &size, NULL), set;
    H5Pset_chunk(how, 1, &size);
    H5Pset_fletcher32(how);
    set = H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, how,
                     H5P_DEFAULT);
    H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(set);
    H5Sclose(space);
    H5Pclose(how);
}

/* An object header that cannot grow in place is continued in another block,
 * and HDF5 moves a message there to make space. Attributes are listed in the
 * order of creation. */
TEST_IN_FOLDER(lists_attributes_in_order)
{
    const char *path = test_path(*state, "order.h5");
    enum { COUNT = 100 };
    hid_t file = make_file(path), how = H5Pcreate(H5P_GROUP_CREATE), group;
    look l;
    uint64_t object;
    size_t count;
    H5Pset_attr_creation_order(how, H5P_CRT_ORDER_TRACKED);
    H5Pset_attr_phase_change(how, 512, 256);
    group = H5Gcreate2(file, "many", H5P_DEFAULT, how, H5P_DEFAULT);
    for (int k = 0; k < COUNT; k++) {
        double value = k;
        char name[64];
        snprintf(name, sizeof name, "n%0*d", 3 + 7 * k % 40, k);
        set_attribute(group, name, H5T_NATIVE_DOUBLE, &value);
        snprintf(name, sizeof name, "beside%d", k);
        if (k % 10 == 0)
            make_rows(file, name, 1, true, H5T_IEEE_F64LE, 7, false);
    }
    H5Gclose(group);
    H5Pclose(how);
    H5Fclose(file);
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    assert_true(ovr_container_find(&l.c, l.c.root, "many", &object));
    const ovr_named_number *found = ovr_container_numbers(&l.c, object, &count);
    assert_non_null(found);
    assert_int_equal(count, COUNT);
    for (size_t k = 0; k < count; k++)
        CHECK_NEAR(found[k].value, (double)k, 0);
    close_file(&l);
}

/* Nothing of another file is read, whatever way the library HDF5 knows to name
 * one; and nothing that this program would not write. */
TEST_IN_FOLDER(stays_in_the_file)
{
    const char *path = test_path(*state, "led.h5");
    const char *secret = test_path(*state, "secret.h5");
    const char *const bad[] = {"outer", "soft",   "elsewhere", "virtual",
                               "other", "summed", "big"};
    hid_t file = make_file(secret);
    ovr_dataset set;
    uint64_t object;
    look l;
    make_rows(file, "x", 4, true, H5T_IEEE_F64LE, 4, false);
    H5Fclose(file);
    file = make_file(path);
    make_rows(file, "good", 4, true, H5T_IEEE_F64LE, 4, false);
    make_rows(file, "big", 4, true, H5T_IEEE_F64BE, 4, false);
    H5Lcreate_external(secret, "x", file, "outer", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("good", file, "soft", H5P_DEFAULT, H5P_DEFAULT);
    make_elsewhere(file, "elsewhere", secret);
    make_virtual(file, "virtual", secret);
    make_filtered(file, "summed");
    H5Gclose(H5Gcreate2(file, "other", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Fclose(file);
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    check_rows(&l, "good", 4, true, 0);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        if (ovr_container_find(&l.c, l.c.root, bad[k], &object) &&
            ovr_container_dataset(&l.c, object, &set))
            fail_msg("'%s' was taken for a dataset", bad[k]);
    close_file(&l);
}

/* A claim of 2^40 rows and nodes, of which none is there. */
TEST_IN_FOLDER(believes_no_size)
{
    const char *path = test_path(*state, "claims.h5");
    const hsize_t shape[2] = {(hsize_t)1 << 40, (hsize_t)1 << 40};
    const hsize_t chunk[2] = {1, 1 << 20};
    hid_t file = make_file(path), how = H5Pcreate(H5P_DATASET_CREATE);
    ovr_dataset set;
    uint64_t object;
    look l;
    H5Pset_chunk(how, 2, chunk);
    for (int rank = 1; rank <= 2; rank++) {
        hid_t space = H5Screate_simple(rank, shape, NULL);
        H5Pset_chunk(how, rank, rank == 1 ? chunk + 1 : chunk);
        H5Dclose(H5Dcreate2(file, rank == 1 ? "one" : "two", H5T_NATIVE_DOUBLE,
                            space, H5P_DEFAULT, how, H5P_DEFAULT));
        H5Sclose(space);
    }
    H5Pclose(how);
    H5Fclose(file);
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    assert_true(ovr_container_find(&l.c, l.c.root, "one", &object));
    assert_false(ovr_container_dataset(&l.c, object, &set));
    assert_true(ovr_container_find(&l.c, l.c.root, "two", &object));
    assert_false(ovr_container_dataset(&l.c, object, &set));
    close_file(&l);
}

/* A block at address 0 without bytes is rejected, before and after other blocks
 * were read. A block that was read is found again by its address, but not with
 * another length or other letters. */
TEST_IN_FOLDER(rejects_empty_blocks)
{
    const char *path = test_path(*state, "blocks.h5");
    enum { SIZE = 48 };
    ovr_piece first, again;
    look l;
    H5Fclose(make_file(path));
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    for (int k = 0; k < 2; k++) {
        assert_false(ovr_load_block(&l.c.source, 0, 0, "OHDR", &again));
        assert_false(ovr_load_block(&l.c.source, 0, 4, "\211HDF", &again));
        assert_true(ovr_load_block(&l.c.source, 0, SIZE, "\211HDF", &first));
        assert_true(ovr_load_block(&l.c.source, 0, SIZE, "\211HDF", &again));
        assert_ptr_equal(first.at, again.at);
        assert_false(
            ovr_load_block(&l.c.source, 0, SIZE - 1, "\211HDF", &again));
        assert_false(ovr_load_block(&l.c.source, 0, SIZE, "OHDR", &again));
    }
    close_file(&l);
}

/* The same bytes, asked for again and again as a made-up file might: refused
 * once they are many times those of the file, long before memory is out. */
TEST_IN_FOLDER(bounds_a_look)
{
    const char *path = test_path(*state, "again.h5");
    const size_t enough = (size_t)1 << 27;
    hid_t file = make_file(path);
    size_t count;
    look l;
    make_rows(file, "x", 4, true, H5T_IEEE_F64LE, 4, false);
    H5Fclose(file);
    assert_int_equal(open_file(&l, path), OVR_FOUND_CONTAINER);
    while (l.arena.bytes < enough &&
           ovr_container_links(&l.c, l.c.root, &count))
        assert_int_equal(count, 1);
    assert_true(l.arena.bytes < enough);
    close_file(&l);
}

/* ------------------------------------------------------------------- damage */

static void write_result(const char *path)
{
    ovr_error err = {0};
    ovr_write_options o = ovr_write_options_default();
    ovr_contact contact = test_contact_bare();
    test_dent d;
    ovr_writer *w;
    o.path = path;
    o.every_steps = 1;
    o.x_from = -0.2;
    o.x_to = 0.2;
    o.fields = 0x7f;
    o.case_text = "[contact]\nM = 20\n";
    test_dent_init(&d, 225, 0);
    w = ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err);
    assert_non_null(w);
    for (long k = 0; k <= 3; k++) {
        test_dent_move(&d, k);
        CHECK_OK(ovr_writer_record(w, &d.frame, &err), &err);
    }
    CHECK_OK(ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err), &err);
    test_dent_free(&d);
}

/* Reads all there is; whether all of it could be read. */
static bool read_all(const char *path)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    const ovr_result_info *about = r ? ovr_result_get_info(r) : NULL;
    const ovr_variable *column;
    size_t maximum;
    double *values;
    bool good = r != NULL;
    if (!r) {
        CHECK_ERROR(&err, OVR_BAD_INPUT, "bad.h5");
        return false;
    }
    maximum = about->nodes + about->steps + about->snapshots;
    values = malloc(maximum * sizeof *values);
    for (size_t k = 0; k < about->snapshots; k++)
        for (size_t f = 0; f < ovr_result_fields(r); f++)
            good = !ovr_result_snapshot(r, ovr_result_field(r, f)->name, k,
                                        OVR_AS_STORED, values, &err) &&
                   good;
    for (size_t k = 0; (column = ovr_result_column(r, k)); k++)
        good = !ovr_result_history(r, column->name, OVR_AS_STORED, values,
                                   &err) &&
               good;
    good = !ovr_result_x(r, OVR_AS_STORED, values, &err) && good;
    free(values);
    ovr_result_close(r);
    return good;
}

/* Bytes changed all over a file, those of its structure most of all: a clean
 * error or other numbers, never a crash. */
TEST_IN_FOLDER(survives_changed_bytes)
{
    const char *whole = test_path(*state, "whole.h5");
    const char *path = test_path(*state, "bad.h5");
    size_t bytes, refused = 0, tried = 0;
    char *data;
    write_result(whole);
    data = test_read(whole, &bytes);
    test_write(path, data, bytes);
    assert_true(read_all(path));
    for (size_t at = 0; at < bytes; at += data[at] ? 61 : 509, tried++) {
        data[at] = (char)~data[at];
        test_write(path, data, bytes);
        refused += !read_all(path);
        data[at] = (char)~data[at];
    }
    print_message("%zu of %zu changed bytes noticed\n", refused, tried);
    assert_true(refused > 0);
    free(data);
}
