/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Interrupted runs: an artificial run that is killed at any time and resumed
 * ends with the same file. */
#include "support/test.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <zlib.h>

#include "overroll/version.h"
#include "results/results.h"
#include "results/writer.h"
#include "support/dent.h"

enum { NODES = 113, STEPS = 300 };

/* The state of the run that never was: a step and numbers that depend on all
 * steps before. */
typedef struct fake {
    long step;
    double chaos[50];
    test_dent *dent;
} fake;

static ovr_status visit_fake(void *object, ovr_visit *visit, void *context,
                             ovr_error *err)
{
    fake *f = object;
    ovr_status status = visit(context, "step", &f->step, sizeof f->step, err);
    if (status == OVR_OK)
        status = visit(context, "chaos", f->chaos, sizeof f->chaos, err);
    return status;
}

static void start(fake *f, test_dent *dent)
{
    f->step = 0;
    f->dent = dent;
    for (int k = 0; k < 50; k++)
        f->chaos[k] = 0.1 + 0.01 * k;
}

static void advance(fake *f)
{
    f->step++;
    for (int k = 0; k < 50; k++)
        f->chaos[k] = 3.9 * f->chaos[k] * (1 - f->chaos[k]);
}

static ovr_status record(ovr_writer *w, fake *f, ovr_error *err)
{
    test_dent_move(f->dent, f->step);
    for (int k = 0; k < 50; k++)
        f->dent->P[k] = f->chaos[k];
    f->dent->seen.H_cen = f->chaos[0];
    return ovr_writer_record(w, &f->dent->frame, err);
}

static const ovr_case_value values[] = {
    {"contact.M", "20", 20, NULL, true},
    {"time.end", "6", 6, NULL, false},
    {"lubricant.alpha", "22 1/GPa", 22e-9, "1/Pa", true},
};

static ovr_write_options options_for(const char *path)
{
    ovr_write_options o = ovr_write_options_default();
    o.path = path;
    o.every_steps = 7;
    o.flush_interval = 0;
    o.checkpoint_interval = 1e-9;
    o.case_text = "[contact]\nM = 20\n";
    o.case_path = "/some/where";
    o.values = values;
    o.value_count = 3;
    return o;
}

/* Runs to the end, or until the parent kills it; pauses keep it in reach. */
static void run(ovr_writer *w, fake *f, long last, bool slowly)
{
    ovr_error err = {0};
    ovr_state_source source = {visit_fake, f};
    ovr_writer_source(w, source);
    if (f->step == 0)
        CHECK_OK(record(w, f, &err), &err);
    while (f->step < last) {
        struct timespec wait = {0, 20000};
        if (slowly)
            nanosleep(&wait, NULL);
        advance(f);
        CHECK_OK(record(w, f, &err), &err);
    }
}

static void run_whole(const char *path, long last)
{
    ovr_error err = {0};
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_physical();
    test_dent dent;
    fake f;
    ovr_writer *w;
    test_dent_init(&dent, NODES, 0);
    start(&f, &dent);
    w = ovr_writer_create(&o, &contact, NODES, dent.X, NULL, &err);
    assert_non_null(w);
    run(w, &f, last, false);
    CHECK_OK(ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err), &err);
    test_dent_free(&dent);
}

/* However slow the machine is: until it has its name, or gives up. */
static void await_file(const char *path)
{
    const struct timespec moment = {0, 1000000};
    for (int k = 0; k < 60000 && access(path, F_OK) != 0; k++)
        nanosleep(&moment, NULL);
}

/* A child that runs until it is killed, so long after it began or its file did.
 */
static void run_and_kill(const char *path, double seconds, bool of_file)
{
    struct timespec wait = {0, (long)(1e9 * seconds)};
    pid_t child = fork();
    int status;
    if (child == 0) {
        ovr_error err = {0};
        ovr_write_options o = options_for(path);
        ovr_contact contact = test_contact_physical();
        test_dent dent;
        fake f;
        ovr_writer *w;
        test_dent_init(&dent, NODES, 0);
        start(&f, &dent);
        w = ovr_writer_create(&o, &contact, NODES, dent.X, NULL, &err);
        if (w)
            run(w, &f, STEPS, true);
        pause();
        _exit(0);
    }
    if (of_file)
        await_file(path);
    nanosleep(&wait, NULL);
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
}

static ovr_result *open_result(const char *path)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    if (!r)
        fail_msg("%s", err.message);
    return r;
}

/* Every value of `part` is the one of `whole`. */
static void check_prefix(const char *part, const char *whole, bool all)
{
    ovr_result *a = open_result(part), *b = open_result(whole);
    const ovr_result_info *ia = ovr_result_get_info(a),
                          *ib = ovr_result_get_info(b);
    double x[STEPS + 1], y[STEPS + 1];
    ovr_error err = {0};
    assert_true(ia->snapshots <= ib->snapshots && ia->steps <= ib->steps);
    if (all)
        assert_true(ia->snapshots == ib->snapshots && ia->steps == ib->steps);
    for (size_t k = 0; k < ia->snapshots; k++)
        for (size_t f = 0; f < ovr_result_fields(a); f++) {
            const char *name = ovr_result_field(a, f)->name;
            CHECK_OK(ovr_result_snapshot(a, name, k, OVR_AS_STORED, x, &err),
                     &err);
            CHECK_OK(ovr_result_snapshot(b, name, k, OVR_AS_STORED, y, &err),
                     &err);
            assert_memory_equal(x, y, NODES * sizeof *x);
        }
    for (size_t c = 0; ovr_result_column(a, c); c++) {
        const char *name = ovr_result_column(a, c)->name;
        CHECK_OK(ovr_result_history(a, name, OVR_AS_STORED, x, &err), &err);
        CHECK_OK(ovr_result_history(b, name, OVR_AS_STORED, y, &err), &err);
        assert_memory_equal(x, y, ia->steps * sizeof *x);
    }
    ovr_result_close(b);
    ovr_result_close(a);
}

/* Are these the values of the checkpoint's run? */
static ovr_status check(const ovr_restart *restart, size_t count,
                        const ovr_case_value *now, ovr_error *err)
{
    const ovr_restart_info *info = ovr_restart_get_info(restart);
    return ovr_values_same(info->value_count, info->values, count, now, err);
}

static void resume(const char *path, long last)
{
    ovr_error err = {0};
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_physical();
    ovr_restart *restart = ovr_restart_open(path, NULL, &err);
    test_dent dent;
    fake f;
    ovr_state_source source = {visit_fake, &f};
    ovr_writer *w;
    if (!restart)
        fail_msg("%s", err.message);
    test_dent_init(&dent, NODES, 0);
    start(&f, &dent);
    CHECK_OK(check(restart, 3, values, &err), &err);
    if (ovr_restart_get_info(restart)->has_state) {
        CHECK_OK(ovr_restart_load_into(restart, &source, &err), &err);
        assert_int_equal(f.step, ovr_restart_get_info(restart)->step);
    }
    w = ovr_writer_resume(&o, &contact, NODES, dent.X, restart, NULL, &err);
    if (!w)
        fail_msg("%s", err.message);
    run(w, &f, last, false);
    CHECK_OK(ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err), &err);
    ovr_restart_close(restart);
    test_dent_free(&dent);
}

/* Killed during a write: a reader reports it, and only resuming repairs the
 * file. */
static bool was_cut(const char *path)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    if (!r)
        assert_non_null(strstr(err.message, "last write was interrupted"));
    ovr_result_close(r);
    return !r;
}

TEST_IN_FOLDER(survives_kills)
{
    const char *whole = test_path(*state, "whole.h5");
    const char *killed = test_path(*state, "killed.h5");
    uint64_t seed = 11;
    int died_early = 0, kills = test_draws(5, 12);
    run_whole(whole, STEPS);
    for (int k = 0; k < kills; k++) {
        run_and_kill(killed, test_random(&seed, 0.002, 0.25), k % 2);
        if (access(killed, F_OK) != 0) {
            died_early++; /* before it had its name: nothing to go on with */
            continue;
        }
        if (!was_cut(killed))
            check_prefix(killed, whole, false);
        resume(killed, STEPS);
        check_prefix(killed, whole, true);
        unlink(killed);
    }
    assert_true(died_early <= (kills + 1) / 2);
}

TEST_IN_FOLDER(goes_further)
{
    const char *whole = test_path(*state, "whole.h5");
    const char *shorter = test_path(*state, "short.h5");
    run_whole(whole, STEPS);
    run_whole(shorter, STEPS / 2);
    resume(shorter, STEPS);
    check_prefix(shorter, whole, true);
}

/* Pieces of the state by the names of another version. */
typedef struct later {
    double known, added;
    double array[2];
    bool all;
} later;

static ovr_status visit_later(void *object, ovr_visit *visit, void *context,
                              ovr_error *err)
{
    later *l = object;
    ovr_status status = OVR_OK;
    if (l->all)
        status = visit(context, "added", &l->added, sizeof l->added, err);
    if (!status)
        status = visit(context, "known", &l->known, sizeof l->known, err);
    if (!status && l->array[0] != 0)
        status = visit(context, "array", l->array, sizeof l->array, err);
    return status;
}

static void write_later(const char *path, later *l)
{
    const ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_physical();
    ovr_error err = {0};
    test_dent dent;
    fake f;
    test_dent_init(&dent, NODES, 0);
    start(&f, &dent);
    ovr_writer *w = ovr_writer_create(&o, &contact, NODES, dent.X, NULL, &err);
    assert_non_null(w);
    ovr_writer_source(w, (ovr_state_source){visit_later, l});
    CHECK_OK(record(w, &f, &err), &err);
    CHECK_OK(ovr_writer_close(w, OVR_RUN_STOPPED, NULL, &err), &err);
    test_dent_free(&dent);
}

static ovr_status read_later(const char *path, later *l, ovr_error *err)
{
    ovr_state_source source = {visit_later, l};
    ovr_restart *r = ovr_restart_open(path, NULL, err);
    assert_non_null(r);
    assert_true(ovr_restart_get_info(r)->has_state);
    ovr_status status = ovr_restart_load_into(r, &source, err);
    ovr_restart_close(r);
    return status;
}

/* A number that a checkpoint does not have is left as it was, one that nobody
 * asks for is ignored; an array must be there, and nothing is half read. */
TEST_IN_FOLDER(numbers_go_by_name)
{
    const char *path = test_path(*state, "a.h5");
    ovr_error err = {0};
    later old = {.known = 3}, new = {.known = 5, .added = 7, .all = true};
    write_later(path, &old);
    CHECK_OK(read_later(path, &new, &err), &err);
    assert_true(new.known == 3 && new.added == 7);
    new.known = 5;
    new.array[0] = 1;
    CHECK_STATUS(read_later(path, &new, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "'array' differs");
    assert_true(new.known == 5);
    path = test_path(*state, "b.h5");
    write_later(path, &new);
    old.known = 0;
    CHECK_OK(read_later(path, &old, &err), &err);
    assert_true(old.known == 5 && old.added == 0);
}

/* Replaces what follows `after` in a checkpoint, whose checksum stays right. */
static void patch(const char *path, const char *after, const void *bytes,
                  size_t count)
{
    static unsigned char all[1 << 16];
    uint64_t sum;
    FILE *f = fopen(path, "r+b");
    assert_non_null(f);
    size_t size = fread(all, 1, sizeof all, f), at = 0, length = strlen(after);
    while (at + length < size && memcmp(all + at, after, length) != 0)
        at++;
    assert_true(at + length + count < size && size < sizeof all);
    memcpy(all + at + length, bytes, count);
    sum = crc32(0, all, (uInt)(size - 24));
    memcpy(all + size - 8, &sum, sizeof sum);
    rewind(f);
    assert_int_equal(fwrite(all, 1, size, f), size);
    fclose(f);
}

/* Another patch version continues a run, another minor version or a later
 * format does not. */
TEST_IN_FOLDER(refuses_other_versions)
{
    const char *path = test_path(*state, "a.h5");
    const uint64_t next = OVR_RESTART_FORMAT + 1;
    char restart[4200], version[] = OVERROLL_VERSION;
    later l = {.known = 3};
    ovr_error err = {0};
    write_later(path, &l);
    snprintf(restart, sizeof restart, "%s.restart", path);
    version[sizeof version - 2] = '9';
    patch(restart, "version", version, sizeof version - 1);
    l.known = 0;
    CHECK_OK(read_later(path, &l, &err), &err);
    assert_true(l.known == 3);
    patch(restart, "format", &next, sizeof next);
    assert_null(ovr_restart_open(path, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "in format 3");
    path = test_path(*state, "b.h5");
    write_later(path, &l);
    snprintf(restart, sizeof restart, "%s.restart", path);
    patch(restart, "version", "9.9", 3);
    assert_null(ovr_restart_open(path, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "written by overroll 9.9.0");
}

/* The memory of a writer in `check` is the actual one. */
TEST_IN_FOLDER(estimates_its_memory)
{
    const ovr_write_options o = options_for(test_path(*state, "a.h5"));
    ovr_contact contact = test_contact_physical();
    ovr_error err = {0};
    test_dent dent;
    test_dent_init(&dent, NODES, 0);
    double told = ovr_writer_memory(&o, &contact, NODES, dent.X);
    ovr_writer *w = ovr_writer_create(&o, &contact, NODES, dent.X, NULL, &err);
    assert_non_null(w);
    CHECK_CLOSE(told, (double)w->arena.bytes + (4 << 20), 0.02);
    CHECK_OK(ovr_writer_close(w, OVR_RUN_STOPPED, NULL, &err), &err);
    test_dent_free(&dent);
}

TEST_IN_FOLDER(names_the_changed_parameter)
{
    const char *path = test_path(*state, "a.h5");
    ovr_case_value changed[3];
    ovr_error err = {0};
    ovr_restart *restart;
    run_whole(path, 20);
    restart = ovr_restart_open(path, NULL, &err);
    assert_non_null(restart);
    assert_string_equal(ovr_restart_get_info(restart)->case_path,
                        "/some/where");
    assert_string_equal(ovr_restart_get_info(restart)->case_text,
                        "[contact]\nM = 20\n");
    assert_int_equal(ovr_restart_get_info(restart)->step, 20);
    memcpy(changed, values, sizeof changed);
    changed[1].text = "7";
    CHECK_OK(check(restart, 3, changed, &err), &err);
    changed[2].text = "21 1/GPa";
    assert_int_equal(check(restart, 3, changed, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "'lubricant.alpha' was '22 1/GPa'");
    assert_int_equal(check(restart, 2, changed, &err), OVR_BAD_INPUT);
    ovr_restart_close(restart);
}

TEST_IN_FOLDER(refuses_damaged_checkpoints)
{
    const char *path = test_path(*state, "a.h5");
    const char *file = test_path(*state, "a.h5.restart");
    ovr_error err = {0};
    size_t bytes;
    char *data;
    run_whole(path, 20);
    data = test_read(file, &bytes);
    for (size_t at = 0; at < bytes; at += 37) {
        char kept = data[at];
        data[at] = (char)~kept;
        test_write(file, data, bytes);
        data[at] = kept;
        assert_null(ovr_restart_open(path, NULL, &err));
        CHECK_ERROR(&err, OVR_BAD_INPUT, "a.h5.restart");
        test_write(file, data, at);
        assert_null(ovr_restart_open(path, NULL, &err));
        CHECK_ERROR(&err, OVR_BAD_INPUT, "a.h5.restart");
    }
    free(data);
    unlink(file);
    assert_null(ovr_restart_open(path, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "No such file");
}

TEST_IN_FOLDER(refuses_another_layout)
{
    const char *path = test_path(*state, "a.h5");
    ovr_write_options o = options_for(path);
    ovr_contact contact = test_contact_physical();
    ovr_error err = {0};
    ovr_restart *restart;
    test_dent dent;
    size_t before, after;
    test_dent_init(&dent, NODES, 0);
    run_whole(path, 20);
    free(test_read(path, &before));
    restart = ovr_restart_open(path, NULL, &err);
    o.stride = 2;
    assert_null(
        ovr_writer_resume(&o, &contact, NODES, dent.X, restart, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "other nodes");
    o.stride = 1;
    o.single = true;
    assert_null(
        ovr_writer_resume(&o, &contact, NODES, dent.X, restart, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "another precision");
    ovr_restart_close(restart);
    free(test_read(path, &after));
    assert_int_equal(before, after);
    ovr_result_close(open_result(path));
    test_dent_free(&dent);
}

/* ------------------------------------------------------- allocation faults */

static ovr_status write_with(void *folder, const ovr_allocator *hook,
                             ovr_error *err)
{
    ovr_write_options o = options_for(test_path(folder, "faults.h5"));
    ovr_contact contact = test_contact_physical();
    ovr_state_source source;
    ovr_status status = OVR_OK, closed;
    ovr_writer *w;
    test_dent dent;
    fake f;
    o.force = true;
    o.fields = 0x7f;
    test_dent_init(&dent, NODES, 0);
    start(&f, &dent);
    w = ovr_writer_create(&o, &contact, NODES, dent.X, hook, err);
    if (w) {
        source = (ovr_state_source){visit_fake, &f};
        ovr_writer_source(w, source);
        for (; f.step < 30 && status == OVR_OK; advance(&f))
            status = record(w, &f, err);
        closed = ovr_writer_close(w, OVR_RUN_COMPLETE, NULL,
                                  status == OVR_OK ? err : NULL);
        status = status == OVR_OK ? closed : status;
    } else {
        status = err->status;
    }
    test_dent_free(&dent);
    return status;
}

static ovr_status resume_with(void *folder, const ovr_allocator *hook,
                              ovr_error *err)
{
    ovr_write_options o = options_for(test_path(folder, "faults.h5"));
    ovr_contact contact = test_contact_physical();
    ovr_restart *restart = ovr_restart_open(o.path, hook, err);
    ovr_writer *w = NULL;
    test_dent dent;
    o.fields = 0x7f;
    test_dent_init(&dent, NODES, 0);
    if (restart)
        w = ovr_writer_resume(&o, &contact, NODES, dent.X, restart, hook, err);
    ovr_restart_close(restart);
    test_dent_free(&dent);
    return w ? ovr_writer_close(w, OVR_RUN_STOPPED, NULL, err) : err->status;
}

static ovr_status read_with(void *folder, const ovr_allocator *hook,
                            ovr_error *err)
{
    ovr_result *r = ovr_result_open(test_path(folder, "faults.h5"), hook, err);
    double P[NODES];
    ovr_status status;
    if (!r)
        return err->status;
    status = ovr_result_snapshot(r, "pressure", 1, OVR_AS_STORED, P, err);
    ovr_result_close(r);
    return status;
}

TEST_IN_FOLDER(survives_failing_allocations)
{
    assert_true(test_every_allocation(write_with, *state) > 3);
    assert_true(test_every_allocation(resume_with, *state) > 3);
    assert_true(test_every_allocation(read_with, *state) > 0);
}
