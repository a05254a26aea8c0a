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
    bench_close();
    return 0;
}
