/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pressure spike: height, minimum film thickness and computing time of a steady
 * solution on uniform grids of second order and with patches. */
#include <stdio.h>

#include "bench.h"
#include "support/test.h"

enum { ROUNDS = 3, BASE = 8, LEVELS = 2 };
static const int levels[LEVELS] = {14, 16};

typedef struct solution {
    double P_spike, H_min, nodes, seconds;
} solution;

static void solve(void *data)
{
    ovr_simulation_steady(data, NULL);
}

static solution solution_of(ovr_options o)
{
    ovr_error err = {0};
    ovr_simulation *sim = test_simulation(20, 10, &o);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    const ovr_observation *seen = ovr_simulation_observation(sim);
    bench_work work = {solve, sim, 0};
    bench_measure(1, &work, 0, ROUNDS);
    solution s = {seen->P_spike, seen->H_min,
                  (double)ovr_simulation_state(sim)->n, work.seconds};
    ovr_simulation_free(sim);
    return s;
}

static void print(const char *grid, int level, const solution *s)
{
    printf("%8s %5d %8.0f  %.6f  %.8f  %9.2f\n", grid, level, s->nodes,
           s->P_spike, s->H_min, 1e3 * s->seconds);
    bench_row();
    bench_text("grid", grid);
    bench_number("level", level);
    bench_number("nodes", s->nodes);
    bench_number("P_spike", s->P_spike);
    bench_number("H_min", s->H_min);
    bench_number("seconds", s->seconds);
    bench_end();
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("the spike of M = 20, L = 10\n");
    printf("    grid level    nodes   P_spike       H_min         ms\n");
    bench_list("spike");
    for (int k = 0; k < LEVELS; k++) {
        ovr_options o = test_options();
        o.level = levels[k];
        solution uniform = solution_of(o);
        print("uniform", levels[k], &uniform);
        o.level = BASE;
        o.order = 4;
        o.refine = OVR_REFINE_SPIKE;
        o.refine_level = levels[k];
        solution patches = solution_of(o);
        print("patches", levels[k], &patches);
        printf("patches: %.0f times faster\n",
               uniform.seconds / patches.seconds);
    }
    bench_end();
    bench_close();
    return 0;
}
