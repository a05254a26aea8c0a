/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of a rheological model: a rolling and sliding dent, M = 20, L = 10, SRR
 * = 0.5, with Newtonian, Eyring and Carreau films in alternation, and the
 * kernel of the model alone. Goals: an Eyring step takes 1.35 times, a Carreau
 * step 1.5 times as long as a Newtonian step. */
#include <math.h>
#include <stdio.h>

#include "bench.h"
#include "contact/contact.h"
#include "multigrid/flow.h"
#include "simulation/internal.h"
#include "support/test.h"

enum { LAWS = 4, STEPS = 200, ROUNDS = 3, LEVEL = 8 };

static const struct law {
    const char *name;
    ovr_rheology rheology;
    double Sigma0, goal;
} laws[LAWS] = {{"newtonian", OVR_NEWTONIAN, NAN, NAN},
                {"eyring", OVR_EYRING, 0.334, 1.35},
                {"carreau", OVR_CARREAU, 0.334, 1.5},
                {"carreau", OVR_CARREAU, 0.03, 1.5}};

static ovr_simulation *contact(const struct law *law, ovr_flow_law **table)
{
    test_contact c = test_contact_make(20, 10);
    ovr_options o = test_options();
    ovr_flow_form form = ovr_flow_form_default();
    ovr_error err = {0};
    o.level = LEVEL;
    c.contact.u1_ratio = 1.25;
    c.contact.u2_ratio = 0.75;
    form.rheology = law->rheology;
    form.number = law->Sigma0;
    *table = NULL;
    if (law->rheology == OVR_CARREAU)
        form.law = *table = ovr_flow_law_create(&form, NULL, &err);
    CHECK_OK(ovr_lubricant_flow(&c.contact, &form, &c.lubricant, &err), &err);
    return ovr_simulation_create(&c.contact, &c.lubricant, &o, NULL, &err);
}

/* Marches from a steady state until the dent is in the contact. */
static void steps(void *data)
{
    static test_feature dent = {'l', -0.1, 0.5, -1.5, 1.25, 0};
    ovr_simulation *sim = data;
    ovr_error err;
    ovr_simulation_surface(sim, test_feature_heights, &dent);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    double D = sim->finest->grid.D;
    for (int k = 0; k < STEPS; k++)
        CHECK_OK(ovr_simulation_step(sim, D, &err), &err);
}

static void flow(void *data)
{
    ovr_simulation *sim = data;
    const ovr_level *l = sim->finest;
    ovr_flow_store(sim->grids.kernels, &sim->grids.fluid, l->grid.D, &l->lanes,
                   &l->f);
}

static void print(const char *set, const struct law *law,
                  const ovr_simulation *sim, const bench_work measured[2],
                  double newtonian)
{
    const ovr_statistics *s = ovr_simulation_statistics(sim);
    double ratio = measured[0].seconds / newtonian;
    double cycles = (double)s->cycles / (double)s->steps;
    double us = 1e6 * measured[0].seconds / STEPS;
    double ns = 1e9 * measured[1].seconds / (double)sim->finest->grid.n;
    printf("%-7s %-10s %7.3g %9.1f %7.2f %7.3g %7.2f %9.2f\n", set, law->name,
           law->Sigma0, us, ratio, law->goal, cycles, ns);
    bench_row();
    bench_text("kernels", set);
    bench_text("law", law->name);
    bench_number("Sigma0", law->Sigma0);
    bench_number("step_us", us);
    bench_number("of_newtonian", ratio);
    bench_number("goal", law->goal);
    bench_number("cycles_a_step", cycles);
    bench_number("flow_ns_a_node", ns);
    bench_end();
}

static void compare(const char *set)
{
    ovr_simulation *sim[LAWS];
    ovr_flow_law *table[LAWS];
    bench_work work[LAWS], alone[LAWS];
    for (int k = 0; k < LAWS; k++) {
        sim[k] = contact(&laws[k], &table[k]);
        ovr_hierarchy_kernels(&sim[k]->grids, ovr_kernels_choose(set));
        work[k] = (bench_work){steps, sim[k], 0};
        alone[k] = (bench_work){flow, sim[k], 0};
    }
    bench_measure(LAWS, work, 0, ROUNDS);
    bench_measure(LAWS, alone, 1e-3, 15);
    for (int k = 0; k < LAWS; k++) {
        const bench_work measured[2] = {work[k], alone[k]};
        print(set, &laws[k], sim[k], measured, work[0].seconds);
    }
    for (int k = 0; k < LAWS; k++) {
        ovr_simulation_free(sim[k]);
        ovr_flow_law_free(table[k]);
    }
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    printf("steps of a dent by rheological model, level 8; medians of CPU "
           "time; flow: kernel of the model, ns per node\n%-7s %-10s %7s %9s "
           "%7s %7s %7s %9s\n",
           "kernels", "law", "Sigma0", "step, us", "ratio", "goal", "cycles",
           "flow, ns");
    bench_list("flow_laws");
    for (int k = 0; bench_sets[k]; k++)
        if (ovr_kernels_choose(bench_sets[k]))
            compare(bench_sets[k]);
    bench_end();
    bench_close();
    return 0;
}
