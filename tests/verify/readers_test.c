/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Twenty-four readers of a file during the run: none fails, and none reads
 * fewer rows than before. The slow-down of the run is printed, relative to a
 * run with as many readers of another file, which use the same processors but
 * do not delay the writer. On an idle machine it is less than a twentieth.
 * (Medians of runs in alternation; runs without readers are printed for
 * comparison.)
 *
 * Every reader opens the file twice a second, reads the newest snapshot and the
 * history, and closes it.
 *
 * Effect of results/journal.h: with its locks the writer waited less than 1 ms
 * for readers in a whole run, and none failed. The same holds with retries only
 * (five, over 31 ms), but in tests/unit/live_test.c, where commits follow each
 * other within 0.6 ms, a reader failed in 4 of 6 attempts. */
#include "support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "overroll/results.h"

enum { READERS = 24, TIMES = 5, MAX = 4096 };

static const char case_text[] =
    "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 8\n[time]\nend = 6\n"
    "[feature dent]\nshape = dent\ndepth = 0.1\nwidth = 0.5\nstart = -4.6\n"
    "[output]\nevery = 1\n";

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Reads the file once; false: the reader failed. Stores the number of rows and
 * whether the run has ended. */
static bool look(const char *path, size_t *rows, bool *ended)
{
    static double values[MAX];
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(path, NULL, &err);
    const ovr_result_info *about = r ? ovr_result_get_info(r) : NULL;
    bool good = about && about->nodes <= MAX && about->snapshots >= *rows;
    if (good) {
        *rows = about->snapshots;
        *ended = strcmp(about->status, "running") != 0;
    }
    if (good && *rows)
        good = ovr_result_snapshot(r, "pressure", *rows - 1, OVR_AS_STORED,
                                   values, &err) == OVR_OK;
    if (good && about->steps <= MAX)
        good = ovr_result_history(r, "time", OVR_AS_STORED, values, &err) ==
               OVR_OK;
    if (!good)
        print_message("%s (%zu rows)\n", err.message, *rows);
    ovr_result_close(r);
    return good;
}

/* Reads until the file reports the end of the run or another file exists. */
static int read_on(const char *path, const char *over)
{
    const struct timespec pause = {0, 500000000};
    size_t rows = 0;
    bool ended = false, good = true;
    while (access(path, F_OK) != 0)
        nanosleep(&pause, NULL);
    while (good && (over ? access(over, F_OK) != 0 : !ended)) {
        good = look(path, &rows, &ended);
        nanosleep(&pause, NULL);
    }
    return good ? 0 : 1;
}

static void touch(const char *path)
{
    FILE *made = fopen(path, "w");
    assert_non_null(made);
    fclose(made);
}

/* Seconds that a run to a.h5 takes beside so many readers of a file; how many
 * of those failed. */
static double run_beside(int readers, const char *of, const char *folder,
                         int *failed)
{
    const char *program = getenv("OVERROLL");
    bool own = strcmp(of, "a.h5") == 0;
    char path[512], input[512], read[512], over[512];
    double begun;
    pid_t run;
    int code;
    snprintf(path, sizeof path, "%s/a.h5", folder);
    snprintf(input, sizeof input, "%s/dent.ini", folder);
    snprintf(read, sizeof read, "%s/%s", folder, of);
    snprintf(over, sizeof over, "%s/over", folder);
    unlink(path);
    unlink(over);
    for (int k = 0; k < readers; k++)
        if (fork() == 0)
            _exit(read_on(read, own ? NULL : over));
    begun = now();
    run = fork();
    if (run == 0) {
        execl("/bin/sh", "sh", "-c",
              "exec \"$0\" run \"$1\" -o \"$2\" -q >$2.out", program, input,
              path, (char *)NULL);
        _exit(127);
    }
    waitpid(run, &code, 0);
    begun = now() - begun;
    assert_int_equal(code, 0);
    touch(over);
    while (readers-- > 0) {
        assert_true(wait(&code) > 0);
        *failed += code != 0;
    }
    return begun;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *seconds)
{
    qsort(seconds, TIMES, sizeof *seconds, by_size);
    return seconds[TIMES / 2];
}

TEST_IN_FOLDER(readers_and_run_live_together)
{
    double alone[TIMES], beside[TIMES], read[TIMES], ratio;
    const char *folder = *state;
    char done[512], kept[512];
    int failed = 0;
    FILE *input = fopen(test_path(folder, "dent.ini"), "w");
    if (!getenv("OVERROLL"))
        skip();
    assert_non_null(input);
    fputs(case_text, input);
    fclose(input);
    snprintf(done, sizeof done, "%s/a.h5", folder);
    snprintf(kept, sizeof kept, "%s/b.h5", folder);
    for (int k = 0; k < TIMES; k++) {
        alone[k] = run_beside(0, "b.h5", folder, &failed);
        assert_int_equal(rename(done, kept), 0);
        beside[k] = run_beside(READERS, "b.h5", folder, &failed);
        read[k] = run_beside(READERS, "a.h5", folder, &failed);
        print_message("%.2f s alone, %.2f s beside readers, %.2f s read\n",
                      alone[k], beside[k], read[k]);
    }
    ratio = median(read) / median(beside);
    print_message("medians: %.2f s alone; read against beside readers %+.1f "
                  "%%; %d readers failed\n",
                  median(alone), 100 * (ratio - 1), failed);
    assert_int_equal(failed, 0); /* times are printed and not checked */
}
