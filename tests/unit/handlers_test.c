/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library is called with inputs for which GSL and HDF5 fail, by a program
 * with the default error handlers of both (one aborts, the other prints), from
 * one and two threads. Nothing aborts, nothing is printed, and both handlers
 * are restored. */
#include "support/test.h"

#include <fcntl.h>
#include <gsl/gsl_errno.h>
#include <hdf5.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "contact/contact.h"
#include "overroll/overroll.h"
#include "results/results.h"
#include "support/dent.h"

enum { ROUNDS = 20, NODES = 225 };

/* Of one thread: its files, and what went wrong. */
typedef struct caller {
    char bad[300], good[300], profile[300], none[300];
    int wrong;
} caller;

static void expect(caller *c, bool good)
{
    c->wrong += !good;
}

static void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    if (file) {
        fputs(text, file);
        fclose(file);
    }
}

static void prepare(caller *c, const char *folder, int number)
{
    snprintf(c->bad, sizeof c->bad, "%s/bad%d.h5", folder, number);
    snprintf(c->good, sizeof c->good, "%s/good%d.h5", folder, number);
    snprintf(c->profile, sizeof c->profile, "%s/p%d.txt", folder, number);
    snprintf(c->none, sizeof c->none, "%s/no/file%d.h5", folder, number);
    write_file(c->bad, "\211HDF\r\n\032\n and nothing of the kind");
    write_file(c->profile, "x [mm];z [um]\n0;1\n0;2\nnan;inf\n");
    c->wrong = 0;
}

/* A file that passes for a result until HDF5 is to open what is not there. */
static void lacks_a_field(caller *c, const test_dent *dent)
{
    ovr_write_options o = ovr_write_options_default();
    ovr_contact contact = test_contact_bare();
    ovr_error err = {0};
    ovr_writer *w;
    hid_t file;
    o.path = c->good;
    o.force = true;
    w = ovr_writer_create(&o, &contact, NODES, dent->X, NULL, &err);
    expect(c, w && !ovr_writer_close(w, OVR_RUN_STOPPED, NULL, &err));
    file = H5Fopen(c->good, H5F_ACC_RDWR, H5P_DEFAULT);
    expect(c, H5Ldelete(file, "history/step", H5P_DEFAULT) >= 0);
    H5Fclose(file);
    expect(c,
           !ovr_writer_resume(&o, &contact, NODES, dent->X, NULL, NULL, &err) &&
               err.message[0]);
}

static void bad_results(caller *c)
{
    ovr_write_options o = ovr_write_options_default();
    ovr_contact contact = test_contact_bare();
    ovr_error err = {0};
    test_dent dent;
    expect(c, !ovr_result_open(c->bad, NULL, &err) && err.message[0]);
    expect(c, !ovr_result_open(c->none, NULL, &err));
    expect(c, !ovr_restart_open(c->bad, NULL, &err));
    test_dent_init(&dent, NODES, 0);
    lacks_a_field(c, &dent);
    o.path = c->bad;
    expect(c,
           !ovr_writer_resume(&o, &contact, NODES, dent.X, NULL, NULL, &err) &&
               err.message[0]);
    o.path = c->none;
    expect(c, !ovr_writer_create(&o, &contact, NODES, dent.X, NULL, &err));
    test_dent_free(&dent);
}

/* Histories and profiles are GSL's to interpolate: times that stand still or
 * are no numbers, points too few. */
static void bad_histories(caller *c)
{
    const double still[] = {0, 1, 1}, back[] = {0, 2, 1}, none[] = {0, NAN, 2};
    const double one[] = {1, 1, 1};
    const double *const times[] = {still, back, none};
    ovr_error err = {0};
    for (size_t k = 0; k < 3; k++) {
        ovr_history_form form = {.kind = OVR_HISTORY_TABLE,
                                 .points = 3,
                                 .T = times[k],
                                 .value = one};
        expect(c, !ovr_history_create(&form, NULL, &err) && err.message[0]);
    }
}

static void bad_profile(caller *c)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err = {0};
    ovr_profile *p;
    source.file = c->profile;
    p = ovr_profile_read(&source, NULL, &err);
    expect(c, !p && err.message[0]);
    ovr_profile_free(p);
}

static void impossible_case(caller *c)
{
    ovr_error err = {0};
    ovr_case *given = ovr_case_read_text(
        "[contact]\nM = 1e9\nL = 0\n[domain]\nlevel = 4\n", "text", NULL, NULL,
        &err);
    ovr_setup *setup = given ? ovr_case_resolve(given, NULL, &err) : NULL;
    ovr_simulation *sim = setup ? ovr_setup_simulation(setup, NULL, &err)
                                : NULL;
    expect(c, (!sim || ovr_simulation_steady(sim, &err)) && err.message[0]);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(given);
}

static void *call_all(void *data)
{
    for (int k = 0; k < ROUNDS; k++) {
        bad_results(data);
        bad_histories(data);
        bad_profile(data);
        impossible_case(data);
    }
    return NULL;
}

/* Calls with standard error in a file; how many bytes came to it. */
static long said(const char *log, caller *c, int callers)
{
    int kept = dup(STDERR_FILENO);
    int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    struct stat about;
    pthread_t thread[2];
    fflush(stderr);
    dup2(file, STDERR_FILENO);
    for (int k = 1; k < callers; k++)
        pthread_create(&thread[k], NULL, call_all, &c[k]);
    call_all(&c[0]);
    for (int k = 1; k < callers; k++)
        pthread_join(thread[k], NULL);
    fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    fstat(file, &about);
    close(file);
    return (long)about.st_size;
}

static void check_callers(const char *folder, int callers)
{
    H5E_auto2_t before, after;
    void *data, *data_after;
    caller c[2];
    long bytes;
    for (int k = 0; k < callers; k++)
        prepare(&c[k], folder, k);
    H5Eget_auto2(H5E_DEFAULT, &before, &data);
    bytes = said(test_path(folder, "stderr"), c, callers);
    H5Eget_auto2(H5E_DEFAULT, &after, &data_after);
    assert_int_equal(bytes, 0);
    for (int k = 0; k < callers; k++)
        assert_int_equal(c[k].wrong, 0);
    assert_non_null(before);
    assert_ptr_equal(before, after);
    assert_ptr_equal(gsl_set_error_handler(NULL), NULL);
}

TEST_IN_FOLDER(one_thread)
{
    check_callers(*state, 1);
}

TEST_IN_FOLDER(two_threads)
{
    hbool_t safe = false;
    H5is_library_threadsafe(&safe);
    if (!safe)
        skip();
    check_callers(*state, 2);
}
