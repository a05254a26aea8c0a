/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed of the solver relative to its goals: MLMI, a V(1,1) cycle and full
 * multigrid in units of one FFTW convolution of the same n (in alternation),
 * the largest steady solution, the reference dent, and the growth per doubling
 * of n. All instruction sets are measured with one program. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

enum { SETS = 3, FIRST = 8, LAST = 18, LEVELS = (LAST - FIRST) / 2 + 1 };

/* Prints a row. Goals are for AVX-512; NAN: no goal. */
static void row(const char *what, int level, double goal,
                const double measured[SETS])
{
    bench_row();
    bench_text("what", what);
    bench_number("level", level);
    bench_number("goal", goal);
    printf("%-34s %5d", what, level);
    if (isnan(goal))
        printf(" %7s", "");
    else
        printf(" %7.3g", goal);
    for (int k = 0; k < SETS; k++) {
        bench_number(bench_sets[k], measured[k]);
        if (isnan(measured[k]))
            printf(" %8s", "");
        else
            printf(" %8.3g", measured[k]);
    }
    printf("\n");
    bench_end();
}

static ovr_simulation *contact(int set, int level, ovr_scheme scheme,
                               ovr_stop stop)
{
    const ovr_kernels *kernels = ovr_kernels_choose(bench_sets[set]);
    ovr_simulation *sim = kernels ? bench_contact(level, scheme, stop) : NULL;
    if (sim)
        ovr_hierarchy_kernels(&sim->grids, kernels);
    return sim;
}

/* Returns the fastest instruction set of this machine. */
static int best_set(void)
{
    int set = 0;
    while (!ovr_kernels_choose(bench_sets[set]))
        set++;
    return set;
}

/* -------------------------------- parts in units of a convolution by FFTW */

static void deform(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->deformation(&s->finest->mlmi, s->finest->f.P,
                                  s->finest->f.w);
}

static void cycle(void *sim)
{
    ovr_simulation *s = sim;
    ovr_cycle(&s->grids, s->finest, ovr_simulation_cycling(s, 0));
}

static void solve(void *sim)
{
    ovr_error err;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
}

enum { MLMI, CYCLE, FMG, PARTS };
static void (*const parts[PARTS])(void *) = {deform, cycle, solve};
static const char *const names[PARTS] = {"MLMI, FFTs", "V(1,1), FFTs",
                                         "FMG, FFTs"};

/* Seconds of each part by level and set; algebraic error of FMG relative to the
 * discretization error; seconds of the convolution. */
typedef struct timed {
    double part[PARTS][LEVELS][SETS], algebraic[LEVELS], fft[LEVELS], n[LEVELS];
} timed;

/* Measures a level. Above level 16 only the growth is measured, with one
 * instruction set and without the convolution. */
static void measure_level(timed *t, int k)
{
    int level = FIRST + 2 * k;
    size_t works = 1, n = ovr_level_nodes(level);
    ovr_simulation *sim[SETS] = {NULL};
    bench_work work[1 + SETS * PARTS];
    bench_fft *fft = level > 16 ? NULL : bench_fft_plan(n, 5.5 / (double)n);
    work[0] = (bench_work){fft ? bench_fft_run : deform, fft, 0};
    for (int s = 0; s < SETS; s++) {
        if (level <= 16 || s == best_set())
            sim[s] = contact(s, level, OVR_UPSTREAM2, OVR_STOP_TRUNCATION);
        for (int p = 0; sim[s] && p < PARTS; p++)
            work[works++] = (bench_work){parts[p], sim[s], 0};
        if (sim[s])
            solve(sim[s]);
    }
    /* Long enough for the arrays to be in the cache. */
    double minimum = level < 14 ? 2e-3 : level < 16 ? 5e-3 : 20e-3;
    if (fft)
        bench_measure(works, work, minimum, level < 14 ? 15 : 5);
    else
        bench_measure(works - 1, work + 1, minimum, 3);
    t->n[k] = (double)n;
    t->fft[k] = fft ? work[0].seconds : NAN;
    works = 1;
    for (int s = 0; s < SETS; s++)
        for (int p = 0; p < PARTS; p++)
            t->part[p][k][s] = sim[s] ? work[works++].seconds : NAN;
    for (int s = SETS - 1; s >= 0; s--)
        if (sim[s]) {
            const ovr_refinement *r = &sim[s]->start.refinement[0];
            r += sim[s]->start.refinements - 1;
            t->algebraic[k] = r->algebraic / r->difference;
            ovr_simulation_free(sim[s]);
        }
    bench_fft_free(fft);
}

static void in_convolutions(timed *t)
{
    static const double goals[PARTS][LEVELS] = {{.25, .17, .13, .07, .05, NAN},
                                                {8, 5.5, 4.5, NAN, NAN, NAN},
                                                {50, 30, 20, 15, NAN, NAN}};
    for (int k = 0; k < LEVELS; k++)
        measure_level(t, k);
    for (int p = 0; p < PARTS; p++)
        for (int k = 0; k < LEVELS && !isnan(t->fft[k]); k++) {
            double ratio[SETS];
            for (int s = 0; s < SETS; s++)
                ratio[s] = t->part[p][k][s] / t->fft[k];
            row(names[p], FIRST + 2 * k, goals[p][k], ratio);
        }
}

/* -------------------------------------------------------------- whole runs */

/* Solves at second order to below the discretization error. */
static void largest_steady(void)
{
    double seconds[SETS];
    for (int s = 0; s < SETS; s++) {
        ovr_simulation *sim = contact(s, 17, OVR_UPSTREAM2,
                                      OVR_STOP_TRUNCATION);
        bench_work work = {solve, sim, NAN};
        if (sim)
            bench_measure(1, &work, 0, 3);
        ovr_simulation_free(sim);
        seconds[s] = work.seconds;
    }
    row("steady, 917,505 nodes, s", 17, 0.18, seconds);
}

static void roll(void *sim)
{
    static bench_dent dent = {-4.6};
    ovr_error err;
    ovr_march march = {.end = 6};
    ovr_simulation_surface(sim, bench_dent_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_march(sim, &march, &err), &err);
}

static void reference_dent(void)
{
    double seconds[SETS], cycles[SETS];
    for (int s = 0; s < SETS; s++) {
        ovr_simulation *sim = contact(s, 8, OVR_UPSTREAM2, OVR_STOP_NEGLIGIBLE);
        bench_work work = {roll, sim, NAN};
        if (sim)
            bench_measure(1, &work, 0, s ? 3 : 5);
        seconds[s] = work.seconds;
        cycles[s] = sim ? (double)sim->statistics.cycles /
                              (double)sim->statistics.steps
                        : NAN;
        ovr_simulation_free(sim);
    }
    row("reference dent, 1955 steps, s", 8, 0.22, seconds);
    row("  cycles a step", 8, NAN, cycles);
}

/* ----------------------------------------------------------------- growth */

/* Number of quiet steps, with one cycle each at any residual. The number of
 * cycles of ordinary steps does not depend on n alone. */
enum { SOME_STEPS = 8 };

static void some_steps(void *sim)
{
    ovr_error err;
    ovr_simulation *s = sim;
    for (int k = 0; k < SOME_STEPS; k++)
        CHECK_OK(ovr_simulation_step(s, s->finest->grid.D, &err), &err);
}

static double step_seconds(int level)
{
    bench_dent dent = {-0.8};
    ovr_simulation *sim = contact(best_set(), level, OVR_UPSTREAM2,
                                  OVR_STOP_TRUNCATION);
    bench_work work = {some_steps, sim, 0};
    ovr_simulation_surface(sim, bench_dent_heights, &dent);
    solve(sim);
    sim->options.tolerance = 1;
    some_steps(sim);
    bench_measure(1, &work, 0, level < 14 ? 15 : 3);
    ovr_simulation_free(sim);
    return work.seconds / SOME_STEPS;
}

/* Returns the factor per doubling of n between two levels. */
static double factor(const timed *t, const double *seconds, int from, int to)
{
    return pow(seconds[to] / seconds[from], 1 / log2(t->n[to] / t->n[from]));
}

static void growth_row(const timed *t, const char *what, const double *seconds)
{
    static const double goals[] = {2.05, 2.3};
    static const int ends[] = {0, 2, LEVELS - 1}; /* levels 8, 12, 18 */
    for (int part = 0; part < 2; part++) {
        char text[64];
        double measured[SETS] = {factor(t, seconds, ends[part], ends[part + 1]),
                                 NAN, NAN};
        snprintf(text, sizeof text, "%s per doubling, %d-%d", what,
                 FIRST + 2 * ends[part], FIRST + 2 * ends[part + 1]);
        row(text, FIRST + 2 * ends[part + 1], goals[part], measured);
    }
}

/* Prints microseconds of all parts by level, with the fastest instruction set.
 */
static void by_level(const timed *t, const double *fmg, const double *step)
{
    int set = best_set();
    printf("\n%s by level; times in us; growth per doubling of n since the "
           "previous level;\nestimated algebraic error of FMG relative to the "
           "discretization error\n"
           "%5s %9s %9s %9s %9s %10s %6s %8s %10s %6s\n",
           ovr_kernels_choose(NULL)->name, "level", "n", "FFT", "MLMI",
           "V(1,1)", "FMG", "grows", "error", "quiet step", "grows");
    bench_list("by_level");
    for (int k = 0; k < LEVELS; k++) {
        double grows[2] = {NAN, NAN};
        if (k) {
            grows[0] = factor(t, fmg, k - 1, k);
            grows[1] = factor(t, step, k - 1, k);
        }
        printf("%5d %9.0f %9.1f %9.1f %9.1f %10.1f %6.2f %8.3f %10.1f %6.2f\n",
               FIRST + 2 * k, t->n[k], 1e6 * t->fft[k],
               1e6 * t->part[MLMI][k][set], 1e6 * t->part[CYCLE][k][set],
               1e6 * fmg[k], grows[0], t->algebraic[k], 1e6 * step[k],
               grows[1]);
        bench_row();
        bench_number("level", FIRST + 2 * k);
        bench_number("n", t->n[k]);
        bench_number("fft_us", 1e6 * t->fft[k]);
        bench_number("mlmi_us", 1e6 * t->part[MLMI][k][set]);
        bench_number("cycle_us", 1e6 * t->part[CYCLE][k][set]);
        bench_number("fmg_us", 1e6 * fmg[k]);
        bench_number("fmg_growth", grows[0]);
        bench_number("fmg_algebraic_error", t->algebraic[k]);
        bench_number("step_us", 1e6 * step[k]);
        bench_number("step_growth", grows[1]);
        bench_end();
    }
    bench_end();
}

int main(int argc, char *argv[])
{
    static timed t;
    double fmg[LEVELS], step[LEVELS];
    bench_open(argc, argv);
    printf("M = 20, L = 10; CPU time, medians; goals with AVX-512\n"
           "%-34s %5s %7s %8s %8s %8s\n",
           "", "level", "goal", bench_sets[0], bench_sets[1], bench_sets[2]);
    bench_list("goals");
    in_convolutions(&t);
    largest_steady();
    reference_dent();
    for (int k = 0; k < LEVELS; k++) {
        fmg[k] = t.part[FMG][k][best_set()];
        step[k] = step_seconds(FIRST + 2 * k);
    }
    growth_row(&t, "FMG", fmg);
    growth_row(&t, "quiet step", step);
    bench_end();
    by_level(&t, fmg, step);
    bench_close();
    return 0;
}
