/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Accuracy of steady solutions against computing time: errors of H_cen and
 * H_min on each level by second order (as in version 0.1.0) and fourth order,
 * and the time of a complete solution. The reference is fourth order on level
 * 14. */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "support/test.h"

enum { FIRST = 6, LAST = 12, TRUTH = 14, ROUNDS = 3 };

typedef struct contact {
    double M, L;
} contact;
static const contact contacts[] = {{20, 10}, {100, 10}, {1000, 10}};

typedef struct solution {
    bool solved;
    double H_cen, H_min, seconds;
} solution;

static void solve(void *data)
{
    ovr_simulation_steady(data, NULL);
}

static solution solution_of(contact c, int order, int level, int rounds)
{
    ovr_error err = {0};
    ovr_options o = test_options();
    o.order = order;
    o.level = level;
    ovr_simulation *sim = test_simulation(c.M, c.L, &o);
    solution s = {.solved = !ovr_simulation_steady(sim, &err)};
    if (s.solved) {
        const ovr_observation *seen = ovr_simulation_observation(sim);
        bench_work work = {solve, sim, 0};
        s.H_cen = seen->H_cen;
        s.H_min = seen->H_min_located;
        bench_measure(1, &work, 0, rounds);
        s.seconds = work.seconds;
    }
    ovr_simulation_free(sim);
    return s;
}

/* Prints all levels. Returns the time of the coarsest level whose error of
 * H_cen is not above `target`. */
static double print_order(contact c, const solution *truth, int order,
                          double target)
{
    double quickest = NAN;
    for (int level = FIRST; level <= LAST; level++) {
        solution s = solution_of(c, order, level, ROUNDS);
        double H_cen = fabs(s.H_cen / truth->H_cen - 1);
        double H_min = fabs(s.H_min / truth->H_min - 1);
        if (!s.solved)
            continue;
        printf("%5g %3g %5d %5d  %8.1e %8.1e  %8.2f\n", c.M, c.L, order, level,
               H_cen, H_min, 1e3 * s.seconds);
        bench_row();
        bench_number("M", c.M);
        bench_number("L", c.L);
        bench_number("order", order);
        bench_number("level", level);
        bench_number("H_cen_error", H_cen);
        bench_number("H_min_error", H_min);
        bench_number("seconds", s.seconds);
        bench_end();
        if (isnan(quickest) && H_cen <= target)
            quickest = s.seconds;
    }
    return quickest;
}

int main(int argc, char *argv[])
{
    const double target = 1e-4;
    bench_open(argc, argv);
    printf("steady solutions: errors relative to level %d, ms\n", TRUTH);
    printf("    M   L order level     H_cen    H_min        ms\n");
    bench_list("steady");
    for (size_t k = 0; k < sizeof contacts / sizeof *contacts; k++) {
        solution truth = solution_of(contacts[k], 4, TRUTH, 1);
        double second = print_order(contacts[k], &truth, 2, target);
        double fourth = print_order(contacts[k], &truth, 4, target);
        printf("H_cen to %.0e: %.2f ms by fourth order, %.2f by second\n",
               target, 1e3 * fourth, 1e3 * second);
    }
    bench_end();
    bench_close();
    return 0;
}
