/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of writing results for the reference dent at level 8 (1955 steps, about
 * 250 snapshots of pressure, film thickness and roughness).
 *
 * Wall-clock time is relevant but depends on other load. Therefore the CPU time
 * of the solver's thread (the cost if another core is free) and of the whole
 * process (the cost if none is free) are also printed. The variants are run in
 * alternation, and the best time of each is used.
 *
 * A checkpoint waits for the disk. Its cost is printed for a run with a
 * checkpoint every 10 s (syncs of file, state, folder and journal; 0.3 s are 3
 * %). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "overroll/overroll.h"
#include "results/results.h"
#include "support/contact.h"

enum { LEVEL = 8, TURNS = 5 };

static const double interval = 0.05; /* between checkpoints, s */

typedef struct variant {
    const char *name;
    bool write, single, no_thread;
    int deflate;
    bool checkpoints;
    double wall, own, all; /* minimum so far, s */
    long bytes;
} variant;

static variant variants[] = {
    {"nothing written", false, false, false, 0, false, 0, 0, 0, 0},
    {"f64", true, false, false, 1, false, 0, 0, 0, 0},
    {"f32", true, true, false, 1, false, 0, 0, 0, 0},
    {"f64 uncompressed", true, false, false, 0, false, 0, 0, 0, 0},
    {"f64 without thread", true, false, true, 1, false, 0, 0, 0, 0},
    {"f64, 20 checkpoints/s", true, false, false, 1, true, 0, 0, 0, 0},
};

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void dent(void *data, double T, size_t n, const double *X, double *S)
{
    const double pi = acos(-1);
    (void)data;
    for (size_t i = 0; i < n; i++) {
        double xi = (X[i] + 4.6 - T) / 0.5, e = 10 * xi * xi;
        S[i] = e > 30 ? 0 : -0.1 * pow(10, -e) * cos(2 * pi * xi);
    }
}

static void die(const ovr_error *err)
{
    fprintf(stderr, "%s\n", err->message);
    exit(1);
}

static ovr_simulation *make_simulation(ovr_contact *contact)
{
    ovr_error err = {0};
    ovr_conditions given = ovr_conditions_default();
    ovr_options options = test_options();
    ovr_lubricant lubricant;
    ovr_simulation *sim = NULL;
    given.M = 20;
    given.L = 10;
    given.alpha = 1.7e-8;
    options.level = LEVEL;
    if (!ovr_contact_resolve(&given, contact, &err) &&
        !ovr_lubricant_make(contact, OVR_ROELANDS, OVR_DOWSON_HIGGINSON, 1.98e8,
                            NAN, &lubricant, &err))
        sim = ovr_simulation_create(contact, &lubricant, &options, NULL, &err);
    if (!sim)
        die(&err);
    ovr_simulation_surface(sim, dent, NULL);
    if (ovr_simulation_steady(sim, &err))
        die(&err);
    return sim;
}

static ovr_writer *make_writer(const variant *v, const ovr_contact *contact,
                               ovr_simulation *sim, const char *path)
{
    const ovr_state *state = ovr_simulation_state(sim);
    ovr_write_options o = ovr_write_options_default();
    ovr_error err = {0};
    ovr_writer *writer;
    o.path = path;
    o.force = true;
    o.single = v->single;
    o.deflate = v->deflate;
    o.no_thread = v->no_thread;
    if (v->checkpoints)
        o.checkpoint_interval = interval;
    o.every_steps = ovr_write_every(&o, 6, state->D, state->n);
    writer = ovr_writer_create(&o, contact, state->n, state->X, NULL, &err);
    if (!writer)
        die(&err);
    ovr_writer_checkpoints(writer, sim);
    return writer;
}

static void march(const variant *v, const ovr_contact *contact,
                  ovr_simulation *sim, const char *path)
{
    ovr_march how = {.end = 6};
    ovr_writer *writer = NULL;
    ovr_observer look;
    ovr_error err = {0};
    if (v->write) {
        writer = make_writer(v, contact, sim, path);
        look = ovr_writer_observer(writer);
        how.count = 1;
        how.observers = &look;
    }
    if (ovr_simulation_march(sim, &how, &err) ||
        (writer && ovr_writer_close(writer, OVR_RUN_COMPLETE, NULL, &err)))
        die(&err);
}

static void keep_min(double *minimum, double value)
{
    if (*minimum == 0 || value < *minimum)
        *minimum = value;
}

static void measure(variant *v, const char *path)
{
    ovr_contact contact;
    ovr_simulation *sim = make_simulation(&contact);
    double wall = seconds(CLOCK_MONOTONIC);
    double own = seconds(CLOCK_THREAD_CPUTIME_ID);
    double all = seconds(CLOCK_PROCESS_CPUTIME_ID);
    FILE *file;
    march(v, &contact, sim, path);
    keep_min(&v->wall, seconds(CLOCK_MONOTONIC) - wall);
    keep_min(&v->own, seconds(CLOCK_THREAD_CPUTIME_ID) - own);
    keep_min(&v->all, seconds(CLOCK_PROCESS_CPUTIME_ID) - all);
    file = v->write ? fopen(path, "rb") : NULL;
    if (file && fseek(file, 0, SEEK_END) == 0)
        v->bytes = ftell(file);
    if (file)
        fclose(file);
    ovr_simulation_free(sim);
}

/* Prints the cost of checkpoints relative to the same run without any. */
static void print_cost(const variant *with, const variant *without)
{
    double each = (with->wall - without->wall) / (with->wall / interval);
    printf("a checkpoint takes %.1f ms: %.2f %% of a run with one every 10 s\n",
           1e3 * each, 100 * each / 10);
}

int main(void)
{
    const size_t count = sizeof variants / sizeof *variants;
    char path[64], restart[80];
    snprintf(path, sizeof path, "/tmp/overroll-bench-%ld.h5", (long)getpid());
    snprintf(restart, sizeof restart, "%s.restart", path);
    for (int turn = 0; turn < TURNS; turn++)
        for (size_t k = 0; k < count; k++)
            measure(&variants[k], path);
    unlink(path);
    unlink(restart);
    printf("dent at level %d, seconds: %21s %16s %16s %8s\n", LEVEL, "wall",
           "solver's thread", "all threads", "MB");
    for (size_t k = 0; k < count; k++) {
        const variant *v = &variants[k], *base = &variants[0];
        printf("%-24s %14.3f (%+3.0f %%) %7.3f (%+3.0f %%) %7.3f (%+3.0f %%) "
               "%8.2f\n",
               v->name, v->wall, 100 * (v->wall / base->wall - 1), v->own,
               100 * (v->own / base->own - 1), v->all,
               100 * (v->all / base->all - 1), (double)v->bytes / 1e6);
    }
    print_cost(&variants[count - 1], &variants[1]);
    return 0;
}
