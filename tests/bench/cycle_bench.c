/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time of a V(1,1) cycle on all levels: share of each kernel, measured by a
 * table of kernels that record their own time. */
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

enum {
    DEFORM,
    FILM,
    RESIDUAL,
    ASSEMBLE,
    SOLVE,
    DISTRIBUTE,
    RESTRICT,
    CORRECT,
    COARSEST,
    PARTS
};
static const char *const part_names[] = {"deformation", "film",    "residual",
                                         "assemble",    "solve",   "distribute",
                                         "restrict",    "correct", "coarsest"};

/* Time of each part of the present cycle; the last is the whole cycle. */
static double spent[PARTS + 1];
static const ovr_kernels *inner;

/* Clock of the measurement: wall-clock time, which is cheap to read, or CPU
 * time for long cycles, which other programs may interrupt. */
static clockid_t watch;

static double now(void)
{
    struct timespec t;
    clock_gettime(watch, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define KEEP_TIME(part, call)                                                  \
    do {                                                                       \
        double start = now();                                                  \
        inner->call;                                                           \
        spent[part] += now() - start;                                          \
    } while (0)

static void timed_deformation(const ovr_mlmi *plan, double *P, double *w)
{
    KEEP_TIME(DEFORM, deformation(plan, P, w));
}

static void timed_film(const ovr_fluid *fluid, double H0, const ovr_lanes *g,
                       const double *gap, const double *w, const ovr_fields *f)
{
    KEEP_TIME(FILM, film(fluid, H0, g, gap, w, f));
}

static void timed_residual(const ovr_lanes *g, const ovr_weights *w,
                           const ovr_fields *f)
{
    KEEP_TIME(RESIDUAL, residual(g, w, f));
}

static void timed_phase(const ovr_lanes *g, const ovr_weights *w,
                        const ovr_fields *f)
{
    KEEP_TIME(RESIDUAL, phase(g, w, f));
}

static void timed_assemble(const ovr_lanes *g, const ovr_weights *w,
                           const double k[6], const ovr_shares *shares,
                           const ovr_fields *f, const ovr_band *band)
{
    KEEP_TIME(ASSEMBLE, band_assemble(g, w, k, shares, f, band));
}

static void timed_solve(const ovr_lanes *g, const ovr_band *band)
{
    KEEP_TIME(SOLVE, band_solve(g, band));
}

static void timed_distribute(const ovr_lanes *g, double limit,
                             const ovr_shares *shares, const ovr_band *band,
                             const ovr_fields *f)
{
    KEEP_TIME(DISTRIBUTE, distribute(g, limit, shares, band, f));
}

static void timed_restrict(const ovr_lanes *coarse, const ovr_lanes *fine,
                           const ovr_fields *f, double *Pc, double *entry,
                           double *Hc, double *rc)
{
    KEEP_TIME(RESTRICT, restrict_fields(coarse, fine, f, Pc, entry, Hc, rc));
}

static void timed_gap(const ovr_lanes *g, double H0, const double *w,
                      double *gap)
{
    KEEP_TIME(RESTRICT, coarse_gap(g, H0, w, gap));
}

static void timed_side(const ovr_lanes *g, const double *residual, double *F,
                       double *r)
{
    KEEP_TIME(RESTRICT, coarse_side(g, residual, F, r));
}

static void timed_correct(const ovr_lanes *coarse, const ovr_lanes *fine,
                          double factor, const double *Pc, const double *entry,
                          const ovr_fields *f)
{
    KEEP_TIME(CORRECT, correct(coarse, fine, factor, Pc, entry, f));
}

static void timed_row(size_t n, const double c[4], const double *k, double *row)
{
    KEEP_TIME(COARSEST, dense_row(n, c, k, row));
}

static bool timed_dense(size_t m, size_t stride, double *A, double *x)
{
    bool solved = false;
    double start = now();
    solved = inner->dense_solve(m, stride, A, x);
    spent[COARSEST] += now() - start;
    return solved;
}

static ovr_kernels timed_kernels(const ovr_kernels *kernels)
{
    ovr_kernels timed = *kernels;
    inner = kernels;
    timed.deformation = timed_deformation;
    timed.film = timed_film;
    timed.residual = timed_residual;
    timed.phase = timed_phase;
    timed.band_assemble = timed_assemble;
    timed.band_solve = timed_solve;
    timed.distribute = timed_distribute;
    timed.restrict_fields = timed_restrict;
    timed.coarse_gap = timed_gap;
    timed.coarse_side = timed_side;
    timed.correct = timed_correct;
    timed.dense_row = timed_row;
    timed.dense_solve = timed_dense;
    return timed;
}

/* Number of cycles for the medians. Other programs may interrupt some cycles.
 */
enum { CYCLES = 51 };

static void measure(ovr_simulation *sim, double medians[PARTS + 1])
{
    static double taken[PARTS + 1][CYCLES];
    ovr_cycling how = ovr_simulation_cycling(sim, 0);
    for (int c = 0; c < CYCLES; c++) {
        memset(spent, 0, sizeof spent);
        spent[PARTS] = -now();
        ovr_cycle(&sim->grids, sim->finest, how);
        spent[PARTS] += now();
        for (int k = 0; k <= PARTS; k++)
            taken[k][c] = spent[k];
    }
    for (int k = 0; k <= PARTS; k++)
        medians[k] = bench_median(CYCLES, taken[k]);
}

static void profile(const char *set, int level)
{
    ovr_error err;
    ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                        OVR_STOP_TRUNCATION);
    ovr_kernels timed = timed_kernels(ovr_kernels_choose(set));
    double taken[PARTS + 1], total, rest = 1;
    watch = level < 12 ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID;
    ovr_hierarchy_kernels(&sim->grids, inner);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    sim->grids.kernels = &timed;
    measure(sim, taken);
    total = taken[PARTS];
    bench_row();
    bench_text("kernels", set);
    bench_number("level", level);
    bench_number("cycle_us", 1e6 * total);
    printf("%-7s %5d %9.1f", set, level, 1e6 * total);
    for (int k = 0; k < PARTS; k++) {
        bench_number(part_names[k], taken[k] / total);
        rest -= taken[k] / total;
        printf(" %11.1f", 100 * taken[k] / total);
    }
    bench_number("rest", rest);
    printf(" %6.1f\n", 100 * rest);
    bench_end();
    ovr_simulation_free(sim);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("\nshare of a V(1,1) cycle, %%, all levels together; the clock's "
           "own time is in rest\n%-7s %5s %9s",
           "kernels", "level", "us");
    for (int k = 0; k < PARTS; k++)
        printf(" %11s", part_names[k]);
    printf(" %6s\n", "rest");
    bench_list("share_of_cycle");
    for (int k = 0; bench_sets[k]; k++)
        for (int level = 6; level <= 14; level += 2)
            if (ovr_kernels_choose(bench_sets[k]))
                profile(bench_sets[k], level);
    bench_end();
    bench_close();
    return 0;
}
