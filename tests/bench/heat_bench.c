/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of heat: a rolling and sliding wave, M = 20, L = 10, SRR = 0.5, with a
 * Newtonian film, an Eyring film and a thermal Eyring film in alternation.
 * Goal: a thermal Eyring step takes at most 3 times as long as a Newtonian
 * isothermal step. */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "physics/heat/heat.h"
#include "simulation/internal.h"
#include "simulation/simulation.h"
#include "support/hot.h"
#include "support/test.h"

enum { KINDS = 4, STEPS = 100, ROUNDS = 5, LEVEL = 8 };

static const struct kind {
    const char *name;
    double tau0; /* Pa */
    int points;  /* 0: no heat */
    double goal;
} kinds[KINDS] = {{"newtonian", 0, 0, NAN},
                  {"eyring", 5e6, 0, NAN},
                  {"eyring, heat", 5e6, 5, 3},
                  {"eyring, heat 7", 5e6, 7, NAN}};

static ovr_simulation *contact(const struct kind *kind, const char *set)
{
    static test_feature wave = {'w', 0.02, 0.5, 0, 1.25, 1};
    ovr_heat_form form = test_heat_form();
    ovr_options o = test_options();
    ovr_error err = {0};
    ovr_simulation *sim;
    test_hot hot;
    o.level = LEVEL;
    form.points = kind->points ? kind->points : 5;
    hot = test_hot_make(20, 10, 0.5, kind->tau0, &form);
    sim = ovr_simulation_create(&hot.contact, &hot.oil, &o, NULL, &err);
    assert_non_null(sim);
    if (kind->points)
        CHECK_OK(ovr_physics_add(sim, &ovr_physics_heat, &hot.heat, &err),
                 &err);
    ovr_hierarchy_kernels(&sim->grids, ovr_kernels_choose(set));
    ovr_simulation_surface(sim, test_feature_heights, &wave);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    return sim;
}

/* Marches from the present state. */
static void steps(void *data)
{
    ovr_simulation *sim = data;
    ovr_error err;
    double D = sim->finest->grid.D;
    for (int k = 0; k < STEPS; k++)
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
}

static void print(const char *set, const struct kind *kind,
                  const ovr_simulation *sim, const bench_work *measured,
                  double newtonian)
{
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    double cycles = (double)s->cycles / (double)s->steps;
    double ns = 1e9 * measured->seconds / STEPS / (double)sim->finest->grid.n;
    double ratio = measured->seconds / newtonian;
    printf("%-7s %-14s %8.1f %7.2f %5.2g %7.2f\n", set, kind->name, ns, ratio,
           kind->goal, cycles);
    bench_row();
    bench_text("kernels", set);
    bench_text("film", kind->name);
    bench_number("step_ns_a_node", ns);
    bench_number("of_newtonian", ratio);
    bench_number("goal", kind->goal);
    bench_number("cycles_a_step", cycles);
    bench_end();
}

static void compare(const char *set)
{
    ovr_simulation *sim[KINDS];
    bench_work work[KINDS];
    for (int k = 0; k < KINDS; k++) {
        sim[k] = contact(&kinds[k], set);
        steps(sim[k]); /* the first steps are not measured */
        work[k] = (bench_work){steps, sim[k], 0};
    }
    bench_measure(KINDS, work, 0, ROUNDS);
    for (int k = 0; k < KINDS; k++)
        print(set, &kinds[k], sim[k], &work[k], work[0].seconds);
    for (int k = 0; k < KINDS; k++)
        ovr_simulation_free(sim[k]);
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("steps of a wave with heat, level 8; medians of CPU time\n"
           "%-7s %-14s %8s %7s %5s %7s\n",
           "kernels", "film", "ns/node", "ratio", "goal", "cycles");
    bench_list("heat");
    for (int k = 0; bench_sets[k]; k++)
        if (ovr_kernels_choose(bench_sets[k]))
            compare(bench_sets[k]);
    bench_end();
    bench_close();
    return 0;
}
