/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A reader that polls a file as fast as possible while another process writes
 * it: no wrong value, and never fewer rows than before. */
#include "support/test.h"

#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "results/results.h"
#include "support/dent.h"

enum { NODES = 225, STEPS = 1500, EVERY = 2 };

/* Every snapshot is a flush: the worst that can be asked of a reader. */
static void write_slowly(const char *path)
{
    ovr_error err = {0};
    ovr_write_options o = ovr_write_options_default();
    ovr_contact contact = test_contact_bare();
    struct timespec wait = {0, 300000};
    ovr_status status = OVR_OK;
    test_dent d;
    ovr_writer *w;
    o.path = path;
    o.every_steps = EVERY;
    o.flush_interval = 0;
    test_dent_init(&d, NODES, 0);
    w = ovr_writer_create(&o, &contact, NODES, d.X, NULL, &err);
    for (long k = 0; w && k <= STEPS && status == OVR_OK; k++) {
        test_dent_move(&d, k);
        status = ovr_writer_record(w, &d.frame, &err);
        nanosleep(&wait, NULL);
    }
    if (w && status == OVR_OK)
        status = ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err);
    _exit(w && status == OVR_OK ? 0 : 1);
}

static void check_row(ovr_result *r, test_dent *d, size_t row)
{
    double P[NODES], H[NODES];
    ovr_error err = {0};
    test_dent_move(d, EVERY * (long)row);
    CHECK_OK(ovr_result_snapshot(r, "pressure", row, OVR_AS_STORED, P, &err),
             &err);
    CHECK_OK(
        ovr_result_snapshot(r, "film_thickness", row, OVR_AS_STORED, H, &err),
        &err);
    assert_memory_equal(P, d->P, sizeof P);
    assert_memory_equal(H, d->H, sizeof H);
}

static void check_history(ovr_result *r, test_dent *d, size_t steps)
{
    double T[STEPS + 1];
    ovr_error err = {0};
    CHECK_OK(ovr_result_history(r, "time", OVR_AS_STORED, T, &err), &err);
    for (size_t k = 0; k < steps; k++)
        CHECK_NEAR(T[k], d->dT * (double)k, 0);
}

/* One look: the newest rows and some of the old ones; how many there are. */
static size_t look(const char *path, test_dent *d, uint64_t *seed, bool *ended)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    const ovr_result_info *about;
    size_t rows;
    if (!r)
        fail_msg("%s", err.message);
    about = ovr_result_get_info(r);
    rows = about->snapshots;
    *ended = strcmp(about->status, "complete") == 0;
    for (int k = 0; k < 5 && rows > 0; k++) {
        double back = k < 2 ? k : test_random(seed, 0, (double)rows);
        check_row(r, d, rows - 1 - (size_t)back % rows);
    }
    check_history(r, d, about->steps);
    ovr_result_close(r);
    return rows;
}

TEST_IN_FOLDER(never_sees_a_wrong_value)
{
    const char *path = test_path(*state, "live.h5");
    size_t rows = 0, looks = 0, grown = 0;
    bool ended = false;
    uint64_t seed = 17;
    int code;
    test_dent d;
    pid_t child = fork();
    if (child == 0)
        write_slowly(path);
    test_dent_init(&d, NODES, 0);
    while (access(path, F_OK) != 0 && waitpid(child, &code, WNOHANG) == 0)
        ;
    while (!ended) {
        size_t now = look(path, &d, &seed, &ended);
        assert_true(now >= rows);
        grown += now > rows;
        rows = now;
        looks++;
    }
    waitpid(child, &code, 0);
    assert_int_equal(code, 0);
    assert_int_equal(rows, STEPS / EVERY + 1);
    assert_true(grown > 5);
    print_message("%zu looks, %zu of them at a longer file\n", looks, grown);
    test_dent_free(&d);
}
