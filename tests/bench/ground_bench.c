/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of a time step for random pairs of ground surfaces below a lambda ratio
 * of 1 (support/ground.h; M and the lubricant are random). Some films are found
 * by multigrid cycles, others only by Newton's method as the last attempt
 * (simulation/last_newton.c). */
#include <stdio.h>

#include "bench.h"
#include "support/ground.h"
#include "support/test.h"

enum { LEVEL = 7, ROUNDS = 3, PAIRS = 3 };

static const struct pair {
    const char *solved;
    uint64_t seed;
} pairs[PAIRS] = {{"cycles", 32000}, {"cycles", 32005}, {"Newton", 32003}};

typedef struct asked {
    uint64_t seed;
    test_ground found;
} asked;

static void run(void *data)
{
    asked *a = data;
    a->found = test_ground_run(a->seed, 0.3, 1, LEVEL);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("ground pairs below lambda 1, level %d\n", LEVEL);
    printf("solved by   seed  steps  cycles/step    retries  us/step\n");
    bench_list("ground");
    for (int k = 0; k < PAIRS; k++) {
        asked a = {.seed = pairs[k].seed};
        bench_work work = {run, &a, 0};
        bench_measure(1, &work, 0, ROUNDS);
        const test_ground *g = &a.found;
        CHECK_OK(g->status, &g->err);
        double cycles = (double)g->cycles / g->steps;
        double us = 1e6 * work.seconds / g->steps;
        printf("%-9s %6d %6d %14.2f %8d %10.1f\n", pairs[k].solved, (int)a.seed,
               g->steps, cycles, g->retries, us);
        bench_row();
        bench_text("solved", pairs[k].solved);
        bench_number("seed", (double)a.seed);
        bench_number("steps", g->steps);
        bench_number("cycles", cycles);
        bench_number("retries", g->retries);
        bench_number("seconds", 1e-6 * us);
        bench_end();
    }
    bench_end();
    bench_close();
    return 0;
}
