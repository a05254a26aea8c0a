/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Where the time goes: ns a point of each kernel by instruction set, then
 * the share of each in the run of a dent, by a table of kernels that keep
 * their own time.
 */
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

static const char *const sets[] = {"avx512", "avx2", "base"};
enum { SETS = sizeof sets / sizeof *sets };

/* ----------------------------------------------------- one kernel by itself */

static void run_deformation(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->deformation(&s->finest->mlmi, s->finest->f.P,
                                  s->finest->w);
}

static void run_film(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *l = s->finest;
    s->grids.kernels->film(&s->grids.fluid, s->grids.H0, l->n, l->gap, l->w,
                           &l->f);
}

static void run_residual(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level_residual(&s->grids, s->finest);
}

static void run_imbalance(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level_imbalance(&s->grids, s->finest);
}

static void run_assemble(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *l = s->finest;
    s->grids.kernels->band_assemble(l->n, &l->weights, l->k, l->minus, l->plus,
                                    false, &l->f, &s->grids.band);
}

/* The solver works in place: its rows have to be made again each time. */
static void run_assemble_solve(void *sim)
{
    ovr_simulation *s = sim;
    run_assemble(sim);
    s->grids.kernels->band_solve(s->finest->n, &s->grids.band);
}

static void run_distribute(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->distribute(s->finest->n, 0, &s->grids.band,
                                 s->finest->f.P);
}

static const struct {
    const char *name;
    void (*run)(void *);
} kernels[] = {
    {"deformation", run_deformation}, {"film", run_film},
    {"residual", run_residual},       {"imbalance", run_imbalance},
    {"band_assemble", run_assemble},  {"band_solve", run_assemble_solve},
    {"distribute", run_distribute}};
enum { KERNELS = sizeof kernels / sizeof *kernels };

static void one_level(int set, int level)
{
    ovr_error err;
    bench_work work[KERNELS];
    ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                        OVR_STOP_TRUNCATION);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    sim->grids.kernels = ovr_kernels_choose(sets[set]);
    for (size_t k = 0; k < KERNELS; k++)
        work[k] = (bench_work){kernels[k].run, sim, 0};
    bench_measure(KERNELS, work, 2e-3, 15);
    work[5].seconds -= work[4].seconds;
    bench_row();
    bench_text("kernels", sets[set]);
    bench_number("level", level);
    printf("%-7s %5d", sets[set], level);
    for (size_t k = 0; k < KERNELS; k++) {
        double ns = 1e9 * work[k].seconds / (double)sim->finest->n;
        bench_number(kernels[k].name, ns);
        printf(" %13.2f", ns);
    }
    printf("\n");
    bench_end();
    ovr_simulation_free(sim);
}

/* ------------------------------------------------- all of them in one run */

/* Kernels that keep their own time: the table of the instruction set with
 * wrappers around the hot ones. */
static const ovr_kernels *inner;
static double spent[8];
enum { DEFORM, FILM, RESIDUAL, ASSEMBLE, SOLVE, DENSE, RESTRICT, PARTS };
static const char *const part_names[] = {
    "deformation", "film",        "residual", "band_assemble",
    "band_solve",  "dense_solve", "restrict"};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define KEEP_TIME(part, call)                                                  \
    do {                                                                       \
        double start = now();                                                  \
        inner->call;                                                           \
        spent[part] += now() - start;                                          \
    } while (0)

static void timed_deformation(const ovr_mlmi *plan, const double *P, double *w)
{
    KEEP_TIME(DEFORM, deformation(plan, P, w));
}

static void timed_film(const ovr_fluid *fluid, double H0, size_t n,
                       const double *gap, const double *w, const ovr_fields *f)
{
    KEEP_TIME(FILM, film(fluid, H0, n, gap, w, f));
}

static void timed_residual(size_t n, const ovr_weights *w, const ovr_fields *f)
{
    KEEP_TIME(RESIDUAL, residual(n, w, f));
}

static void timed_assemble(size_t n, const ovr_weights *w, const double k[6],
                           double minus, double plus, bool transient,
                           const ovr_fields *f, const ovr_band *band)
{
    KEEP_TIME(ASSEMBLE,
              band_assemble(n, w, k, minus, plus, transient, f, band));
}

static void timed_solve(size_t n, const ovr_band *band)
{
    KEEP_TIME(SOLVE, band_solve(n, band));
}

static bool timed_dense(size_t m, size_t stride, double *A, double *x)
{
    bool solved = false;
    double start = now();
    solved = inner->dense_solve(m, stride, A, x);
    spent[DENSE] += now() - start;
    return solved;
}

static void timed_restrict(size_t nc, const double *P, const double *H,
                           const double *r, double *Pc, double *entry,
                           double *Hc, double *rc)
{
    KEEP_TIME(RESTRICT, restrict_fields(nc, P, H, r, Pc, entry, Hc, rc));
}

/* Time of a cycle by kernel, all levels together. */
static void profile(int level)
{
    enum { CYCLES = 400 };
    ovr_error err;
    ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                        OVR_STOP_TRUNCATION);
    ovr_kernels timed = *sim->grids.kernels;
    double rest = 1;
    inner = sim->grids.kernels;
    timed.deformation = timed_deformation;
    timed.film = timed_film;
    timed.residual = timed_residual;
    timed.band_assemble = timed_assemble;
    timed.band_solve = timed_solve;
    timed.dense_solve = timed_dense;
    timed.restrict_fields = timed_restrict;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    sim->grids.kernels = &timed;
    memset(spent, 0, sizeof spent);
    double start = now();
    for (int k = 0; k < CYCLES; k++)
        ovr_cycle(&sim->grids, sim->finest);
    double total = now() - start;
    bench_row();
    bench_number("level", level);
    bench_number("cycle_us", 1e6 * total / CYCLES);
    printf("%13d", level);
    for (int k = 0; k < PARTS; k++) {
        bench_number(part_names[k], spent[k] / total);
        rest -= spent[k] / total;
        printf(" %13.1f", 100 * spent[k] / total);
    }
    printf(" %13.1f\n", 100 * rest);
    bench_end();
    ovr_simulation_free(sim);
}

int main(int argc, char *argv[])
{
    static const int levels[] = {6, 8, 10, 12, 14};
    bench_open(argc, argv);
    printf("ns a point\n%-7s %5s", "kernels", "level");
    for (size_t k = 0; k < KERNELS; k++)
        printf(" %13s", kernels[k].name);
    printf("\n");
    bench_list("ns_a_point");
    for (int set = 0; set < SETS; set++)
        for (size_t k = 0; k < sizeof levels / sizeof *levels; k++)
            if (ovr_kernels_choose(sets[set]))
                one_level(set, levels[k]);
    bench_end();
    printf("\nshare of a V(1,1) cycle, %%\n%13s", "level");
    for (int k = 0; k < PARTS; k++)
        printf(" %13s", part_names[k]);
    printf(" %13s\n", "rest");
    bench_list("share_of_cycle");
    for (int level = 6; level <= 14; level += 2)
        profile(level);
    bench_end();
    bench_close();
    return 0;
}
