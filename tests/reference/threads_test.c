/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Several simultaneous simulations in one process give the same bits as single
 * ones: steady, transient, and with result files. */
#include <hdf5.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/case.h"
#include "results/results.h"
#include "support/test.h"

enum { RUNS = 6, ROUNDS = 2 };

/* A run and what came of it. */
typedef struct one_run {
    int number;
    bool store; /* in a result file */
    ovr_error err;
    size_t n;
    double *P, *H;
    double H_min, T_H_min;
} one_run;

static void make_text(const one_run *r, char *text, size_t capacity)
{
    static const char *const schemes[] = {"upstream1", "upstream2",
                                          "characteristic"};
    snprintf(text, capacity,
             "[contact]\nM = %d\nL = %d\nslide_to_roll = %g\n"
             "[domain]\nlevel = 5\n[time]\nend = 0.5\nscheme = %s\n"
             "[feature ground]\nshape = roughness\nRq = 0.01\nlength = 3\n"
             "shortest = 0.5\nseed = %d\nstart = 0\ngrow = 0.3\n",
             10 + 5 * r->number, 4 + r->number, 0.2 * r->number,
             schemes[r->number % 3], r->number + 1);
}

static void keep(one_run *r, const ovr_simulation *sim)
{
    const ovr_state *state = ovr_simulation_state(sim);
    size_t bytes = state->n * sizeof(double);
    r->n = state->n;
    r->P = malloc(bytes);
    r->H = malloc(bytes);
    memcpy(r->P, state->P, bytes);
    memcpy(r->H, state->H, bytes);
    r->H_min = ovr_simulation_statistics(sim)->extreme.H_min_located;
    r->T_H_min = ovr_simulation_statistics(sim)->when.H_min_located;
}

static ovr_status march(one_run *r, const ovr_setup *setup, ovr_simulation *sim,
                        ovr_writer *writer)
{
    ovr_march how = *setup->march;
    ovr_observer look;
    if (writer) {
        look = ovr_writer_observer(writer);
        how.count = 1;
        how.observers = &look;
    }
    if (ovr_simulation_steady(sim, &r->err))
        return r->err.status;
    return ovr_simulation_march(sim, &how, &r->err);
}

static ovr_writer *open_file(one_run *r, const ovr_setup *setup,
                             const ovr_simulation *sim)
{
    ovr_write_options o = ovr_write_options_default();
    const ovr_state *state = ovr_simulation_state(sim);
    char path[40];
    snprintf(path, sizeof path, "threads_test_%d.h5", r->number);
    o.path = path;
    o.force = true;
    o.every_steps = 2;
    o.flush_interval = 0;
    return ovr_writer_create(&o, setup->contact, state->n, state->X, NULL,
                             &r->err);
}

static void solve(one_run *r, ovr_setup *setup, ovr_simulation *sim)
{
    ovr_writer *writer = r->store ? open_file(r, setup, sim) : NULL;
    if (!march(r, setup, sim, writer))
        keep(r, sim);
    if (writer)
        ovr_writer_close(writer, OVR_RUN_COMPLETE, NULL, &r->err);
}

static void *run(void *data)
{
    one_run *r = data;
    char text[600];
    ovr_case *c;
    ovr_setup *setup = NULL;
    ovr_simulation *sim = NULL;
    make_text(r, text, sizeof text);
    c = ovr_case_read_text(text, "text", NULL, NULL, &r->err);
    if (c)
        setup = ovr_case_resolve(c, NULL, &r->err);
    if (setup)
        sim = ovr_setup_simulation(setup, NULL, &r->err);
    if (sim)
        solve(r, setup, sim);
    ovr_simulation_free(sim);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return NULL;
}

static void forget(one_run *r)
{
    free(r->P);
    free(r->H);
}

static void check_same(const one_run *a, const one_run *b)
{
    CHECK_OK(a->err.status, &a->err);
    CHECK_OK(b->err.status, &b->err);
    assert_true(a->n == b->n && a->n == 225);
    assert_memory_equal(a->P, b->P, a->n * sizeof(double));
    assert_memory_equal(a->H, b->H, a->n * sizeof(double));
    assert_memory_equal(&a->H_min, &b->H_min, sizeof a->H_min);
    assert_memory_equal(&a->T_H_min, &b->T_H_min, sizeof a->T_H_min);
}

static void compare(bool store)
{
    pthread_t thread[RUNS];
    one_run alone[RUNS] = {0}, together[RUNS] = {0};
    for (int i = 0; i < RUNS; i++) {
        alone[i] = together[i] = (one_run){.number = i, .store = store};
        run(&alone[i]);
    }
    for (int i = 0; i < RUNS; i++)
        assert_int_equal(pthread_create(&thread[i], NULL, run, &together[i]),
                         0);
    for (int i = 0; i < RUNS; i++)
        assert_int_equal(pthread_join(thread[i], NULL), 0);
    for (int i = 0; i < RUNS; i++) {
        check_same(&alone[i], &together[i]);
        forget(&alone[i]);
        forget(&together[i]);
    }
}

TEST(threads_compute_what_one_does)
{
    for (int round = 0; round < ROUNDS; round++)
        compare(false);
}

TEST(threads_write_files)
{
    hbool_t safe = false;
    H5is_library_threadsafe(&safe);
    if (!safe)
        skip();
    compare(true);
    for (int i = 0; i < RUNS; i++) {
        char path[40];
        snprintf(path, sizeof path, "threads_test_%d.h5", i);
        ovr_result *result = ovr_result_open(path, NULL, NULL);
        assert_non_null(result);
        assert_true(ovr_result_get_info(result)->snapshots > 5);
        ovr_result_close(result);
        remove(path);
    }
}
