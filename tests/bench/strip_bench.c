/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Computing time and memory of strips from 65 x 16 to 2049 x 1024 nodes. The
 * case is a round dent as deep as the film thickness, M = 20, L = 10. Times of
 * steady solutions are those of nested iteration with two V(1,1) cycles per
 * level. The last table is for the dent rolling through the contact with R <
 * 1e-3 in each step of D, in wall-clock time with one and two threads. */
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "bench.h"
#include "contact/film_formula.h"
#include "support/strip.h"
#include "support/strip_cases.h"
#include "support/test.h"

enum { CYCLES = 4 };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void measure(size_t n, size_t lines, const char *set)
{
    test_strip *s = test_strip_make(20, 10, test_strip_shape(n, lines), set);
    s->bump[s->bumps++] = (test_bump){
        .A = -0.084, .width = 0.3, .x = -0.2, .y = 1, .round = true};
    const ovr_strip_full how = {.gap = test_strip_gap,
                                .data = s,
                                .force = acos(0),
                                .speed = 1,
                                .half_width = 1,
                                .film = ovr_film_central_moes(20, 10),
                                .cycling = ovr_strip_steady(&s->strip.fluid),
                                .cycles = 2,
                                .max_cycles = 2};
    int cycles;
    double start = now(), nodes = (double)n * (double)lines;
    ovr_strip_defect first = ovr_strip_solve(&s->strip, &how, &cycles);
    double full = now() - start, last = 0;
    start = now();
    for (int c = 0; c < CYCLES; c++)
        ovr_strip_cycle(&s->strip, s->strip.finest, &how.cycling);
    double cycle = (now() - start) / CYCLES;
    ovr_strip_level *finest = &s->strip.level[s->strip.finest];
    last = ovr_strip_defect_of(&s->strip, finest).imbalance;
    double factor = pow(last / first.imbalance, 1. / CYCLES);
    printf("%6s %5zu x %4zu  full %8.4f s  cycle %5.0f ns per node, factor "
           "%.2f  %4.0f bytes per node\n",
           set, n, lines, full, 1e9 * cycle / nodes, factor,
           (double)s->arena.bytes / nodes);
    bench_row();
    bench_text("set", set);
    bench_number("n", (double)n);
    bench_number("lines", (double)lines);
    bench_number("full_seconds", full);
    bench_number("cycle_ns_per_node", 1e9 * cycle / nodes);
    bench_number("factor", factor);
    bench_number("bytes_per_node", (double)s->arena.bytes / nodes);
    bench_end();
    test_strip_free(s);
}

static double wall_clock(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void roll(size_t n, size_t lines, int threads)
{
    ovr_strip_shape shape = test_strip_shape(n, lines);
    shape.threads = threads;
    test_strip *s = test_strip_make(20, 10, shape, NULL);
    s->bump[s->bumps++] = (test_bump){
        .A = -0.08, .width = 0.3, .x = -2.5, .y = 1, .u = 1, .round = true};
    test_strip_solve(s, 1e-7);
    ovr_strip_march march;
    test_strip_march(s, &march, 1e-3);
    march.characteristic = true;
    march.carried = 1;
    double D = test_strip_finest(s)->grid.D, H_min = 1;
    double start = wall_clock();
    int steps = 0, cycles = 0, retries = 0;
    for (; steps * D < 4.5 - D / 2; steps++) {
        ovr_strip_step done = ovr_strip_march_attempt(&march, (steps + 1) * D);
        ovr_strip_march_accept(&march);
        cycles += done.cycles;
        retries += done.attempts - 1;
        H_min = fmin(H_min, test_strip_smallest(s, test_strip_finest(s)->f.H));
    }
    double each = (wall_clock() - start) / steps;
    printf("rolling %5zu x %4zu  %4d steps, %.2f cycles and %.4f s each with "
           "%d threads, %d retries, H_min %.5f\n",
           n, lines, steps, (double)cycles / steps, each, threads, retries,
           H_min);
    bench_row();
    bench_number("n", (double)n);
    bench_number("lines", (double)lines);
    bench_number("cycles_per_step", (double)cycles / steps);
    bench_number("threads", threads);
    bench_number("step_seconds", each);
    bench_end();
    test_strip_free(s);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    bench_list("strip");
    for (int k = 0; bench_sets[k]; k++) {
        if (!ovr_kernels_choose(bench_sets[k]))
            continue;
        for (int grid = 1; grid <= 5; grid++)
            measure(((size_t)32 << grid) + 1, (size_t)8 << grid, bench_sets[k]);
        if (!k)
            measure(2049, 1024, bench_sets[k]);
    }
    bench_end();
    bench_list("rolling");
    ovr_kernels_choose(NULL);
    for (int threads = 1; threads <= 2; threads++) {
        roll(257, 64, threads);
        roll(513, 128, threads);
    }
    bench_end();
    bench_close();
    return 0;
}
