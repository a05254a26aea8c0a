/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of mass-conserving cavitation: a cycle of the steady contact and a step
 * of a rolling dent, M = 20, L = 10, flooded and with half of the flooded flow
 * rate, in alternation with Reynolds cavitation. Goals: a cycle 1.25 times, a
 * step 1.15 times. */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "physics/supply/supply.h"
#include "simulation/internal.h"
#include "simulation/simulation.h"
#include "support/test.h"

enum { KINDS = 3, STEPS = 200, ROUNDS = 3, LEVEL = 8 };

static const struct kind {
    const char *name;
    ovr_cavitation cavitation;
    double share; /* supply ratio; 0: flooded */
} kinds[KINDS] = {{"reynolds", OVR_CAVITATION_REYNOLDS, 0},
                  {"conserving", OVR_CAVITATION_CONSERVING, 0},
                  {"starved", OVR_CAVITATION_CONSERVING, 0.5}};

/* Flooded flow rate for M = 20, L = 10 on level 8, within 1 %. */
static const double FLOODED = 0.102;

static double arriving(void *data, double T)
{
    (void)T;
    return ((const struct kind *)data)->share * FLOODED;
}

static ovr_simulation *contact(const struct kind *kind)
{
    ovr_options o = test_options();
    o.level = LEVEL;
    o.cavitation = kind->cavitation;
    ovr_simulation *sim = test_simulation(20, 10, &o);
    if (kind->share > 0)
        ovr_simulation_supply(sim, arriving, (void *)(uintptr_t)kind, 0.1);
    return sim;
}

static void cycle(void *data)
{
    ovr_simulation *sim = data;
    ovr_cycle(&sim->grids, sim->finest, ovr_simulation_cycling(sim, 0));
}

static void start(void *data)
{
    static test_feature dent = {'l', -0.1, 0.5, -1.5, 1, 0};
    ovr_simulation *sim = data;
    ovr_error err;
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
}

/* Marches from a steady state until the dent is in the contact. */
static void steps(void *data)
{
    ovr_simulation *sim = data;
    ovr_error err;
    start(sim);
    double D = sim->finest->grid.D;
    for (int k = 0; k < STEPS; k++)
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
}

static void print(const char *set, const struct kind *kind,
                  const ovr_simulation *sim, double of_cycle, double of_steps,
                  const double reynolds[2])
{
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    double cycles = (double)s->cycles / (double)s->steps;
    double us = 1e6 * of_steps / STEPS;
    printf("%-7s %-11s %9.1f %7.2f %9.1f %7.2f %7.2f\n", set, kind->name,
           1e6 * of_cycle, of_cycle / reynolds[0], us, of_steps / reynolds[1],
           cycles);
    bench_row();
    bench_text("kernels", set);
    bench_text("oil", kind->name);
    bench_number("cycle_us", 1e6 * of_cycle);
    bench_number("cycle_of_reynolds", of_cycle / reynolds[0]);
    bench_number("step_us", us);
    bench_number("step_of_reynolds", of_steps / reynolds[1]);
    bench_number("cycles_a_step", cycles);
    bench_end();
}

static void compare(const char *set)
{
    ovr_simulation *sim[KINDS];
    bench_work cycles[KINDS], starts[KINDS], marches[KINDS];
    ovr_error err;
    for (int k = 0; k < KINDS; k++) {
        sim[k] = contact(&kinds[k]);
        ovr_hierarchy_kernels(&sim[k]->grids, ovr_kernels_choose(set));
        CHECK_OK(ovr_simulation_steady(sim[k], &err), &err);
        cycles[k] = (bench_work){cycle, sim[k], 0};
        starts[k] = (bench_work){start, sim[k], 0};
        marches[k] = (bench_work){steps, sim[k], 0};
    }
    bench_measure(KINDS, cycles, 5e-3, 15);
    bench_measure(KINDS, starts, 0, ROUNDS);
    bench_measure(KINDS, marches, 0, ROUNDS);
    for (int k = 0; k < KINDS; k++)
        marches[k].seconds -= starts[k].seconds;
    const double reynolds[] = {cycles[0].seconds, marches[0].seconds};
    for (int k = 0; k < KINDS; k++) {
        print(set, &kinds[k], sim[k], cycles[k].seconds, marches[k].seconds,
              reynolds);
        ovr_simulation_free(sim[k]);
    }
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("mass-conserving cavitation, level 8; medians of CPU time; goals "
           "1.25 per cycle, 1.15 per step\n%-7s %-11s %9s %7s %9s %7s "
           "%7s\n",
           "kernels", "oil", "cycle, us", "ratio", "step, us", "ratio",
           "cycles");
    bench_list("conserved_oil");
    for (int k = 0; bench_sets[k]; k++)
        if (ovr_kernels_choose(bench_sets[k]))
            compare(bench_sets[k]);
    bench_end();
    bench_close();
    return 0;
}
