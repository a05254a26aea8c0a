/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A study of 64 transient cases with snapshots, run by one and by two workers:
 * wall-clock time, CPU time of all processes, and speed-up. Wall-clock time
 * depends on other load. Therefore two processes that only compute are timed
 * for comparison. */
#define _GNU_SOURCE /* getloadavg, mkdtemp */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "bench.h"
#include "overroll/overroll.h"

enum { TURNS = 3, CASES = 64, LONGEST = 256 };

static const char base_case[] = "[contact]\nM = 20\nL = 10\n"
                                "[domain]\nlevel = 6\n"
                                "[time]\nend = 3\n"
                                "[feature dent]\nshape = dent\ndepth = 0.1\n"
                                "width = 0.5\nstart = -3.1\n"
                                "[output]\nevery = 4\n";
static const char study_text[] = "[study]\ncase = base.ini\n[product]\n"
                                 "contact.M = linear 10 to 25 in 8\n"
                                 "contact.L = linear 5 to 12 in 8\n";

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Returns the CPU time of all processes that have ended. */
static double processor_time(void)
{
    struct rusage r;
    getrusage(RUSAGE_CHILDREN, &r);
    return (double)(r.ru_utime.tv_sec + r.ru_stime.tv_sec) +
           1e-6 * (double)(r.ru_utime.tv_usec + r.ru_stime.tv_usec);
}

static void die(const char *message)
{
    fprintf(stderr, "%s\n", message);
    exit(1);
}

static void write_text(const char *name, const char *text)
{
    FILE *to = fopen(name, "w");
    if (!to || fputs(text, to) < 0 || fclose(to) != 0)
        die(name);
}

/* Checks that each case is finished, i.e. has a summary. */
static void report(void *data, const ovr_run *run, const ovr_error *err,
                   FILE *summary)
{
    (void)data;
    (void)run;
    (void)err;
    if (summary)
        fputs("{\n}\n", summary);
}

static double sweep_once(int workers)
{
    ovr_error err = {0};
    ovr_sweep_options how = {0};
    ovr_study *study = ovr_study_read("study.ini", NULL, &err);
    double began = now();
    if (!study || ovr_study_cases(study) != CASES)
        die(err.message);
    how.workers = workers;
    how.redo = true;
    how.report = report;
    if (ovr_sweep(study, &how, &err))
        die(err.message);
    for (size_t k = 0; k < CASES; k++)
        if (ovr_sweep_state_of(study, k) != OVR_SWEEP_FINISHED)
            die("a case has not finished");
    ovr_study_free(study);
    return now() - began;
}

static double compute_once(int processes)
{
    double began = now();
    for (int k = 0; k < processes; k++)
        if (fork() == 0) {
            volatile double x = 1;
            for (long i = 0; i < 200000000 / processes; i++)
                x = x * 0.5 + 1;
            _exit(0);
        }
    while (wait(NULL) > 0)
        ;
    return now() - began;
}

/* Measures the minimum of several turns, with one and two workers in
 * alternation. */
static void measure(double (*once)(int), double wall[2], double all[2])
{
    for (int turn = 0; turn < TURNS; turn++)
        for (int k = 0; k < 2; k++) {
            double before = processor_time(), t = once(k + 1);
            double used = processor_time() - before;
            wall[k] = fmin(wall[k], t);
            all[k] = fmin(all[k], used);
        }
}

static void measure_and_print(const char *name, double (*once)(int))
{
    double wall[2] = {INFINITY, INFINITY}, all[2] = {INFINITY, INFINITY};
    measure(once, wall, all);
    printf("%-24s %8.2f %8.2f %8.2f x %12.2f %8.2f\n", name, wall[0], wall[1],
           wall[0] / wall[1], all[0], all[1]);
    bench_row();
    bench_text("name", name);
    bench_number("one", wall[0]);
    bench_number("two", wall[1]);
    bench_number("speedup", wall[0] / wall[1]);
    bench_end();
}

int main(int argc, char *argv[])
{
    char folder[] = "/tmp/overroll-bench-XXXXXX", command[LONGEST];
    char *here = getcwd(NULL, 0);
    double load[1] = {NAN};
    bench_open(argc, argv);
    if (!here || !mkdtemp(folder) || chdir(folder) != 0)
        die("no folder for the study");
    write_text("base.ini", base_case);
    write_text("study.ini", study_text);
    (void)!getloadavg(load, 1);
    printf("\n%d cases, seconds (load of the machine before: %.1f)\n"
           "%-24s %8s %8s %10s %12s %8s\n",
           CASES, load[0], "workers", "1", "2", "faster", "processor 1", "2");
    bench_list("sweep");
    measure_and_print("study", sweep_once);
    measure_and_print("computing only", compute_once);
    bench_end();
    bench_number("load", load[0]);
    bench_close();
    snprintf(command, sizeof command, "rm -r %s", folder);
    if (chdir(here) != 0 || system(command) != 0)
        die(folder);
    free(here);
    return 0;
}
