/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run that is stopped, also in its steady start and at its last step, and
 * resumed reports and stores the same as an uninterrupted one: steps, summary
 * and warnings. */
#include "support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "overroll/overroll.h"
#include "run/run.h"

enum { NEVER = -1 };

/* Final messages, and the numbers except computing times. */
typedef struct record {
    long steps;
    int warnings;
    char text[8000], summary[16000];
    long looks, asked;    /* observed, and asked on the way */
    long stop, stop_when; /* at that look; when asked so often */
    ovr_status status;
} record;

static bool stop(void *data)
{
    record *t = data;
    return t->looks == t->stop;
}

static bool interrupt(void *data)
{
    record *t = data;
    return ++t->asked == t->stop_when;
}

static ovr_status look(void *data, const ovr_simulation *sim, ovr_error *err)
{
    record *t = data;
    (void)sim;
    (void)err;
    t->looks++;
    return OVR_OK;
}

static void add(char *to, size_t capacity, const char *text)
{
    size_t used = strlen(to);
    assert_true(used + strlen(text) + 2 < capacity);
    snprintf(to + used, capacity - used, "%s\n", text);
}

static void take(void *data, const ovr_summary_line *line)
{
    static const char *const differ[] = {"seconds", "output", "pass_output",
                                         "snapshots"};
    record *t = data;
    char text[1200];
    for (size_t k = 0; k < sizeof differ / sizeof *differ; k++)
        if (!strcmp(line->key, differ[k]))
            return;
    snprintf(text, sizeof text, "%s %.17g %.1000s", line->key, line->number,
             line->text ? line->text : "");
    add(t->summary, sizeof t->summary, text);
}

static void keep(record *t, const ovr_run *run)
{
    const ovr_run_info *info = ovr_run_get_info(run);
    t->steps = ovr_simulation_statistics(info->sim)->steps;
    t->warnings = info->warnings;
    for (int k = 0; k < info->warnings; k++)
        add(t->text, sizeof t->text, info->warning[k]);
    if (!t->status)
        ovr_run_summary(info, take, t);
}

static ovr_run_options options(record *t, const char *path)
{
    ovr_run_options how = {0};
    how.output = path;
    how.data = t;
    how.stop = stop;
    how.interrupt = interrupt;
    how.observe = look;
    return how;
}

static record run(const char *text, const char *path, record t)
{
    bool stops = t.stop > 0 || t.stop_when > 0;
    ovr_error err = {0};
    ovr_run_options how = options(&t, path);
    how.force = true;
    ovr_case *c = ovr_case_read_text(text, "case", NULL, NULL, &err);
    ovr_run *r = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    CHECK_OK(r ? OVR_OK : err.status, &err);
    t.status = ovr_run_execute(r, &err);
    CHECK_STATUS(t.status, stops ? OVR_STOPPED : OVR_OK, &err);
    keep(&t, r);
    ovr_run_free(r);
    ovr_case_free(c);
    return t;
}

static record resume(const char *path)
{
    record t = {.stop = NEVER};
    ovr_error err = {0};
    ovr_run_options how = options(&t, NULL);
    ovr_run *r = ovr_run_resume(path, &how, NULL, &err);
    CHECK_OK(r ? OVR_OK : err.status, &err);
    t.status = ovr_run_execute(r, &err);
    CHECK_OK(t.status, &err);
    keep(&t, r);
    ovr_run_free(r);
    return t;
}

/* The first line of each that the other does not have there. */
static void same_lines(const char *part, const char *whole, long look,
                       long looks)
{
    while (*part && *part == *whole && *whole) {
        size_t a = strcspn(part, "\n"), b = strcspn(whole, "\n");
        if (a != b || strncmp(part, whole, a) != 0)
            break;
        part += a + 1;
        whole += b + 1;
    }
    if (*part || *whole)
        fail_msg("stopped at %ld of %ld: '%.*s', not '%.*s'", look, looks,
                 (int)strcspn(part, "\n"), part, (int)strcspn(whole, "\n"),
                 whole);
}

/* Stopped at the k-th look, counted from the end where k < 0; or when asked k
 * times, before it is looked at. */
static void same_end_of(bool looked, const char *text, const char *folder,
                        const long *at, size_t count)
{
    char path[600], whole_path[600];
    snprintf(path, sizeof path, "%s/part.h5", folder);
    snprintf(whole_path, sizeof whole_path, "%s/whole.h5", folder);
    record whole = run(text, whole_path, (record){.stop = NEVER});
    for (size_t k = 0; k < count; k++) {
        long look = at[k] > 0 ? at[k] : whole.looks + 1 + at[k];
        record stop = {.stop = looked ? look : NEVER,
                       .stop_when = looked ? 0 : at[k]};
        run(text, path, stop);
        record part = resume(path);
        same_lines(part.text, whole.text, look, whole.looks);
        same_lines(part.summary, whole.summary, look, whole.looks);
        assert_int_equal(part.steps, whole.steps);
    }
}

static void same_end(const char *text, const char *folder, const long *at,
                     size_t count)
{
    same_end_of(true, text, folder, at, count);
}

#define AT(...)                                                                \
    (const long[]){__VA_ARGS__}, sizeof((long[]){__VA_ARGS__}) / sizeof(long)

#define CONTACT "[contact]\nM = 20\nL = 10\n"
#define DENT                                                                   \
    "[feature dent]\nshape = dent\ndepth = 0.1\nwidth = 0.5\nstart = -4.6\n"

/* It ends when nothing changes any more, which its last step shows. */
TEST_IN_FOLDER(the_last_step_of_an_automatic_end)
{
    same_end(CONTACT "[domain]\nlevel = 4\n[time]\nend = auto\n" DENT, *state,
             AT(-1, -2, -19, 3));
}

/* Nothing is kept of it, and it begins again. */
TEST_IN_FOLDER(stopped_before_it_begins)
{
    same_end_of(false, CONTACT "[domain]\nlevel = 6\n[time]\nend = 0.1\n" DENT,
                *state, AT(1, 4, 9));
}

/* The steady start of a hot, conserved film, some 10 s of CPU, ends within one
 * of the moment from which it is to. */
static bool after_a_while(void *data)
{
    return (double)clock() / CLOCKS_PER_SEC > *(const double *)data;
}

TEST(a_long_start_is_stopped_at_once)
{
    double when = (double)clock() / CLOCKS_PER_SEC + 1;
    ovr_error err = {0};
    ovr_run_options how = {0};
    ovr_case *c = ovr_case_read_text(
        "[contact]\nradius = 12.7 mm\nviscosity = 40 mPa.s\nM = 100\n"
        "L = 12\nmodulus = 226 GPa\nslide_to_roll = 0.5\n[domain]\n"
        "level = 14\n[lubricant]\nalpha = 17 1/GPa\nrheology = eyring\n"
        "eyring_stress = 5 MPa\n[heat]\nmodel = lobatto\n"
        "temperature = 80 degC\n[cavitation]\nmodel = conserving\n",
        "case", NULL, NULL, &err);
    how.data = &when;
    how.interrupt = after_a_while;
    ovr_run *r = c ? ovr_run_create(c, &how, NULL, &err) : NULL;
    CHECK_OK(r ? OVR_OK : err.status, &err);
    CHECK_STATUS(ovr_run_execute(r, &err), OVR_STOPPED, &err);
    CHECK_ERROR(&err, OVR_STOPPED, "steady start");
    assert_true((double)clock() / CLOCKS_PER_SEC < when + 1);
    ovr_run_free(r);
    ovr_case_free(c);
}

#define STRIP                                                                  \
    "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n[strip]\n"                \
    "[feature groove]\nshape = groove\nwidth = 0.5\nstart = -0.3\n"

/* The steady film of a strip; returns the number of cycles. */
static long start_of_strip(const char *depth, record *t)
{
    ovr_error err = {0};
    ovr_run_options how = options(t, NULL);
    how.steady = true;
    ovr_case *c = ovr_case_read_text(STRIP, "case", NULL, NULL, &err);
    CHECK_OK(ovr_case_set(c, "feature groove.depth", depth, "test", &err),
             &err);
    ovr_run *r = ovr_run_create(c, &how, NULL, &err);
    CHECK_OK(r ? OVR_OK : err.status, &err);
    t->status = ovr_run_execute(r, &err);
    long cycles = ovr_simulation_statistics(ovr_run_get_info(r)->sim)->cycles;
    ovr_run_free(r);
    ovr_case_free(c);
    return cycles;
}

/* Nested iteration, and features that grow after nested iteration has failed.
 * The callback is called at every cycle of the finest grid and on the grids
 * below, and not after it has returned true. */
TEST(the_start_of_a_strip_is_stopped)
{
    static const char *const depth[] = {"0.01", "0.4"};
    static const double share[] = {0, 0.02, 0.1, 0.5, 0.9};
    for (size_t k = 0; k < sizeof depth / sizeof *depth; k++) {
        record whole = {.stop = NEVER}, part;
        long cycles = start_of_strip(depth[k], &whole);
        assert_int_equal(whole.status, OVR_OK);
        assert_true(k ? cycles > 200 : cycles < 20);
        assert_true(whole.asked > cycles + 5);
        for (size_t i = 0; i < sizeof share / sizeof *share; i++) {
            long when = 1 + (long)(share[i] * (double)whole.asked);
            part = (record){.stop = NEVER, .stop_when = when};
            start_of_strip(depth[k], &part);
            assert_int_equal(part.status, OVR_STOPPED);
            assert_int_equal(part.asked, when);
        }
    }
}

/* On a level chosen before, which the run then shows to do worse. */
TEST_IN_FOLDER(warnings_of_a_chosen_level)
{
    same_end(CONTACT "[domain]\nlevel = auto\naccuracy = 0.004\n"
                     "accuracy_of = H_min\n[time]\nend = 1\n"
                     "[feature bump]\nshape = bump\nheight = 0.02\n"
                     "width = 0.5\nstart = -1\n",
             *state, AT(1, 8, -1));
}

/* Too coarse for its features, with heat and pressures that steel cannot bear.
 */
TEST_IN_FOLDER(warnings_before_and_after)
{
    same_end("[contact]\nradius = 12.7 mm\nviscosity = 8.9 mPa.s\nM = 60\n"
             "L = 10\nmodulus = 226 GPa\nslide_to_roll = 1\n[domain]\n"
             "level = 5\n[time]\nend = 2\n[lubricant]\nalpha = 17 1/GPa\n"
             "rheology = eyring\neyring_stress = 5 MPa\n[heat]\n"
             "model = lobatto\ntemperature = 80 degC\n[feature bump]\nshape = "
             "bump\nheight = 0.01\n"
             "width = 0.2\nstart = -2\n",
             *state, AT(1, 10, -1));
}

/* Warning about fourth-order corrections that did not converge, with a
 * sufficient level. */
TEST_IN_FOLDER(warnings_of_the_steady_start)
{
    same_end("[contact]\nM = 400\nL = 6\n[domain]\nlevel = 8\norder = 4\n"
             "[solver]\nmax_cycles = 4\n[time]\nend = 0.02\n",
             *state, AT(1, 3));
}

/* Stopped in each of them. */
TEST_IN_FOLDER(warnings_of_several_passes)
{
    same_end(CONTACT "[domain]\nlevel = 4\n[time]\nend = 1\n[cavitation]\n"
                     "model = conserving\n[passes]\nnumber = 3\nloss = 0.1\n"
                     "loads = 1, 1.05, 1.1\n[feature dent]\nshape = dent\n"
                     "depth = 0.1\nwidth = 0.3\nstart = -2.5\n",
             *state, AT(2, -2, -1));
}
