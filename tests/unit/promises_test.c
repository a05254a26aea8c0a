/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statements of headers and manual about options, surfaces, attributes, threads
 * and processes. */
#include "support/test.h"

#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "results/results.h"
#include "simulation/simulation.h"
#include "support/contact.h"
#include "support/dent.h"

static ovr_simulation *make(const ovr_options *options, ovr_error *err)
{
    test_contact t = test_contact_make(20, 10);
    return ovr_simulation_create(&t.contact, &t.lubricant, options, NULL, err);
}

/* ---------------------------------------------------------------- options */

#define REFUSED(field, wrong, word)                                            \
    do {                                                                       \
        ovr_options o = ovr_options_default();                                 \
        ovr_error err = {0};                                                   \
        o.field = wrong;                                                       \
        assert_null(make(&o, &err));                                           \
        assert_int_equal(err.status, OVR_BAD_INPUT);                           \
        if (!strstr(err.message, word))                                        \
            fail_msg("%s: %s", #field, err.message);                           \
        assert_true(isinf(ovr_simulation_memory(&o)));                         \
    } while (0)

TEST_IN_FOLDER(wrong_options_are_refused)
{
    REFUSED(scheme, (ovr_scheme)9, "scheme 9");
    REFUSED(scheme, (ovr_scheme)-1, "scheme -1");
    REFUSED(smoother, (ovr_smoother)4, "smoother 4");
    REFUSED(stop, (ovr_stop)3, "stop 3");
    REFUSED(level, INT_MAX, "level 2147483647");
    REFUSED(level, INT_MIN, "level -2147483648");
    REFUSED(coarsest_level, INT_MIN, "coarsest level");
    REFUSED(cycle_index, -1, "cycle_index -1");
    REFUSED(cycle_index, INT_MAX, "cycle_index");
    REFUSED(sweeps_before, -1, "sweeps_before -1");
    REFUSED(sweeps_after, INT_MAX, "sweeps_after");
    REFUSED(max_cycles, -5, "max_cycles -5");
    REFUSED(cycles, INT_MIN, "cycles");
    REFUSED(tolerance, INFINITY, "tolerance inf");
    REFUSED(tolerance, NAN, "tolerance");
    REFUSED(tolerance, -1e-9, "tolerance -1e-09");
    REFUSED(switch_value, NAN, "switch_value");
    REFUSED(mlmi_order, INT_MAX, "mlmi_order");
    REFUSED(mlmi_range, -2, "mlmi_range");
    REFUSED(relax_dipole, NAN, "under-relaxation");
    REFUSED(inlet, -INFINITY, "domain");
    REFUSED(order, 3, "order = 3");
}

/* ---------------------------------------------------------------- surfaces */

enum { LEVEL = 5, NODES = 7 * 32 + 1 };

static void a_wave(void *data, double T, size_t n, const double *X, double *S)
{
    const double *height = data;
    for (size_t i = 0; i < n; i++)
        S[i] = *height * cos(4 * (X[i] - T));
}

static ovr_simulation *coarse(void)
{
    ovr_options o = ovr_options_default();
    ovr_error err;
    ovr_simulation *sim;
    o.level = LEVEL;
    sim = make(&o, &err);
    assert_non_null(sim);
    return sim;
}

/* The pressure of a steady solution and five steps. */
static void solve(ovr_simulation *sim, double *P)
{
    ovr_error err;
    const ovr_state *state = ovr_simulation_state(sim);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    for (int k = 0; k < 5; k++)
        CHECK_OK(ovr_simulation_step(sim, state->D, &err), &err);
    memcpy(P, state->P, NODES * sizeof *P);
}

TEST_IN_FOLDER(without_a_surface_it_is_smooth_again)
{
    double never[NODES], again[NODES], height = 0.01;
    ovr_simulation *one = coarse(), *other = coarse();
    solve(one, never);
    ovr_simulation_surface(other, a_wave, &height);
    solve(other, again);
    assert_memory_not_equal(never, again, sizeof never);
    ovr_simulation_surface(other, NULL, NULL);
    solve(other, again);
    for (size_t i = 0; i < NODES; i++)
        CHECK_NEAR(again[i], never[i], 1e-5); /* another first guess */
    ovr_simulation_free(one);
    ovr_simulation_free(other);
}

/* -------------------------------------------------------------- attributes */

TEST_IN_FOLDER(names_of_attributes_are_there_once)
{
    static const char *const names[][2] = {
        {"contact.M", "contact.M"}, {"text", "b"}, {"a", "a.unit"}};
    const char *path = test_path(*state, "a.h5");
    ovr_contact contact = test_contact_bare();
    double X[3] = {-1, 0, 1};
    for (size_t k = 0; k < 3; k++) {
        ovr_case_value values[2] = {{names[k][0], "1", 1, "m", true},
                                    {names[k][1], "2", 2, "m", true}};
        ovr_write_options o = ovr_write_options_default();
        ovr_error err = {0};
        o.path = path;
        o.values = values;
        o.value_count = 2;
        assert_null(ovr_writer_create(&o, &contact, 3, X, NULL, &err));
        assert_int_equal(err.status, OVR_BAD_INPUT);
        assert_non_null(strstr(err.message, "already"));
        assert_int_not_equal(access(path, F_OK), 0);
    }
}

/* ---------------------------------------------------- threads and processes */

typedef struct job {
    double height, P[NODES];
} job;

static void *work(void *data)
{
    job *j = data;
    ovr_simulation *sim = coarse();
    ovr_simulation_surface(sim, a_wave, &j->height);
    solve(sim, j->P);
    ovr_simulation_free(sim);
    return NULL;
}

TEST_IN_FOLDER(simulations_run_in_threads_at_once)
{
    enum { THREADS = 4 };
    static job alone[THREADS], at_once[THREADS];
    pthread_t thread[THREADS];
    for (int k = 0; k < THREADS; k++) {
        alone[k].height = at_once[k].height = 0.002 * k;
        work(&alone[k]);
    }
    for (int k = 0; k < THREADS; k++)
        assert_int_equal(pthread_create(&thread[k], NULL, work, &at_once[k]),
                         0);
    for (int k = 0; k < THREADS; k++)
        pthread_join(thread[k], NULL);
    assert_memory_equal(alone, at_once, sizeof alone);
}

/* Parent and child continue with their copies; a file that the parent is
 * writing belongs to the parent. */
TEST_IN_FOLDER(a_child_goes_on_with_a_copy)
{
    const char *path = test_path(*state, "b.h5");
    ovr_write_options o = ovr_write_options_default();
    ovr_contact contact = test_contact_bare();
    double mine[NODES], theirs[NODES];
    ovr_simulation *sim = coarse();
    ovr_error err;
    ovr_writer *writer;
    test_dent d;
    int ends[2], code;
    pid_t child;
    o.path = path;
    o.every_steps = 1;
    test_dent_init(&d, NODES, 0);
    writer = ovr_writer_create(&o, &contact, NODES, d.X, NULL, &err);
    assert_non_null(writer);
    CHECK_OK(ovr_writer_record(writer, &d.frame, &err), &err);
    assert_int_equal(pipe(ends), 0);
    child = fork();
    if (child == 0) {
        solve(sim, theirs);
        ovr_simulation_free(sim);
        _exit(write(ends[1], theirs, sizeof theirs) == sizeof theirs ? 0 : 1);
    }
    solve(sim, mine);
    assert_int_equal(read(ends[0], theirs, sizeof theirs), sizeof theirs);
    waitpid(child, &code, 0);
    assert_int_equal(code, 0);
    assert_memory_equal(mine, theirs, sizeof mine);
    CHECK_OK(ovr_writer_close(writer, OVR_RUN_COMPLETE, NULL, &err), &err);
    ovr_simulation_free(sim);
    test_dent_free(&d);
    close(ends[0]);
    close(ends[1]);
}
