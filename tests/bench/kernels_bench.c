/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time of each kernel in ns per node and as fractions of the peak performance
 * of the machine, measured in the same run. The peaks are those of
 * multiply-adds in registers and of a triad with the same number of bytes. The
 * larger fraction is the limit of a kernel. If both fractions are small, the
 * kernel is limited by dependent operations or divisions. Reading is faster
 * than writing, of which the triad contains much, so that kernels that mostly
 * read can exceed its peak. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench.h"
#include "multigrid/coarsest.h"
#include "multigrid/departures.h"
#include "physics/heat/in_time.h"
#include "support/hot.h"
#include "support/test.h"

/* ----------------------------------------------------------- the kernels */

static void run_deformation(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->deformation(&s->finest->mlmi, s->finest->f.P,
                                  s->finest->f.w);
}

static void run_film(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *l = s->finest;
    s->grids.kernels->film(&s->grids.fluid, s->grids.H0, &l->lanes, l->f.gap,
                           l->f.w, &l->f);
}

static void run_residual(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *l = s->finest;
    s->grids.kernels->residual(&l->lanes, &l->weights, &l->f);
}

static void run_phase(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *l = s->finest;
    s->grids.kernels->phase(&l->lanes, &l->weights, &l->f);
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
    s->grids.kernels->band_assemble(&l->lanes, &l->weights, l->k, &l->shares,
                                    &l->f, &s->grids.band);
}

/* Assembles and solves. The solver overwrites its rows, which must therefore be
 * assembled each time. The time of the assembly is subtracted. */
static void run_assemble_solve(void *sim)
{
    ovr_simulation *s = sim;
    run_assemble(sim);
    s->grids.kernels->band_solve(&s->finest->lanes, &s->grids.band);
}

static void run_distribute(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->distribute(&s->finest->lanes, 0, &s->finest->shares,
                                 &s->grids.band, &s->finest->f);
}

static void run_restrict(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *fine = s->finest, *coarse = fine - 1;
    s->grids.kernels->restrict_fields(&coarse->lanes, &fine->lanes, &fine->f,
                                      coarse->f.P, coarse->f.entry,
                                      coarse->f.gap, s->grids.band.delta);
}

static void run_correct(void *sim)
{
    ovr_simulation *s = sim;
    ovr_level *fine = s->finest, *coarse = fine - 1;
    s->grids.kernels->correct(&coarse->lanes, &fine->lanes, 0, coarse->f.P,
                              coarse->f.entry, &fine->f);
}

/* Thermal contact, Eyring film, 5 points. */
static void run_flow_cross_film(void *sim)
{
    ovr_simulation *s = sim;
    ovr_columns c = s->heated->film;
    c.th = NULL;
    s->grids.kernels->flow_cross_film(&c);
}

static void run_heat_cross_film(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->heat_cross_film(&s->heated->film);
}

static void run_carry_along(void *sim)
{
    ovr_simulation *s = sim;
    ovr_heat_steps *h = s->heated->steps;
    const ovr_departures departures = ovr_departures_of(s->now.n, 1.25);
    ovr_carry_along(&departures, h->surface[0].past, h->P_T);
}

/* Surface with heat conduction along x. */
static void run_step_modes(void *sim)
{
    ovr_simulation *s = sim;
    ovr_heat_steps *h = s->heated->steps;
    const ovr_departures departures = ovr_departures_of(s->now.n, 1.25);
    const ovr_memory *m = &h->surface[0].memory;
    const ovr_spread spread = ovr_spread_of(0.2, 1.25, 0.01, 0.01, m->rate);
    const ovr_modes_step step = {
        &departures,        &spread,           m->fade, m->now, m->before,
        h->surface[0].past, h->surface[1].past};
    s->grids.kernels->step_modes(&step, h->surface[0].psi[0],
                                 h->surface[0].next);
}

/*
 * Operations and bytes per node, counted by hand in the sources of the kernels
 * for the line smoother, Roelands' relation, second order. A multiply-add
 * counts as two operations, a division as one, comparisons and selections as
 * one or none. Integer operations are not counted. Each array that is read or
 * written in a loop over the grid counts as 8 bytes per node. Values that
 * neighbouring vectors share are in registers or the first cache.
 *
 * film: logarithm 20, the rest of the first pass 14, t^z 16 + 3, viscosity 16
 * + 6.  Reads P, gap, w; writes H, rho, dq, q, eps, deps (the blocks of a loop
 * remain in the first cache).
 * residual: three sums and two products per side without common terms 7, wedge
 * 6, end 2, tolerance 1.  Reads P, eps, q, F; writes r.
 * phase: tolerance 1.  Reads P, q, r.
 * imbalance: d 5, fall 1, sum 1.  Reads P, eps, r.
 * band_assemble: differences 4, elastic coefficients 3, seven elastic sums 35,
 * local parts 2 + 6 + 8 + 4, five columns 5 when steady (20 in time).  Reads P,
 * eps, rho, dq, deps, r; writes five bands and delta.
 * band_solve: elimination 24, two heads 18, back substitution 8.  Reads six
 * and writes five arrays, then reads five and writes one.
 * distribute: 6.  Reads delta, P; writes P.
 * restrict_fields, per fine node: 8/2.  Reads P, H, r; writes four coarse
 * arrays.
 * correct, per fine node: (2 + 5)/2.  Reads P and two coarse arrays; writes P.
 * flow_cross_film: means 10; six powers of temperature, each a logarithm 20, a
 * power 16 and 2; five ratios 19, moments 25, Y 19; hyperbolic functions of
 * three points 28, their sums 20, a 20, its logarithm 35; rates 25, heating and
 * velocities 60, gamma 24.  Reads X, P, H, log_eta, five T; writes five u and
 * heatings, t, gamma.
 * heat_cross_film: rows 105, elimination 80, back substitution 25, mean and
 * fluxes 18.  Reads X, P, H, q, P_T, gamma, two earlier times, five u,
 * heatings, T and departure points; writes five T, the mean, two fluxes.
 * carry_along: a cubic 7.  Reads and writes an array.
 * step_modes, 16 modes: a cubic 7, two sweeps 6, a step 5.  Reads modes and two
 * arrays, writes and reads the result of one sweep, writes modes.
 */
static const struct kernel {
    const char *name;
    void (*run)(void *);
    double flops, bytes; /* 0: counted from the plan */
    bool hot;            /* needs a thermal contact */
} kernels[] = {{"deformation", run_deformation, 0, 0, false},
               {"film", run_film, 75, 72, false},
               {"residual", run_residual, 16, 40, false},
               {"phase", run_phase, 1, 24, false},
               {"imbalance", run_imbalance, 7, 24, false},
               {"band_assemble", run_assemble, 67, 96, false},
               {"band_solve", run_assemble_solve, 50, 136, false},
               {"distribute", run_distribute, 6, 24, false},
               {"restrict_fields", run_restrict, 4, 40, false},
               {"correct", run_correct, 3.5, 24, false},
               {"flow_cross_film", run_flow_cross_film, 645, 168, true},
               {"heat_cross_film", run_heat_cross_film, 228, 288, true},
               {"carry_along", run_carry_along, 7, 16, true},
               {"step_modes", run_step_modes, 288, 528, true}};
enum { KERNELS = sizeof kernels / sizeof *kernels, ASSEMBLE = 5, SOLVE = 6 };

/*
 * Counts operations and bytes of the deformation. On a grid of m nodes with
 * half order h and range r there are m/2 sums of h pairs with 3 operations
 * (transfer), m/2 of r/2 pairs (even outputs), and m/2 of h + r pairs and a
 * product (odd outputs). The loops read and write u and half of U; half of u
 * and twice half of the even outputs; these, u and the outputs. The dense sum
 * has 2 operations per pair of nodes.
 */
static void count_deformation(const ovr_mlmi *plan, double *flops,
                              double *bytes)
{
    double h = (double)plan->half_order, r = (double)plan->range;
    double m = (double)plan->n, count;
    *flops = *bytes = 0;
    for (int s = 0; s < plan->depth; s++, m /= 2) {
        *flops += m / 2 * (3 * h + 1.5 * r + 3 * (h + r) + 1);
        *bytes += 8 * m * (1.5 + 1.5 + 2.5);
    }
    count = m + (double)(plan->grid[plan->depth].left +
                         plan->grid[plan->depth].right);
    *flops = (*flops + 2 * count * count) / (double)plan->n;
    *bytes = (*bytes + 16 * count) / (double)plan->n;
}

/* ------------------------------------------------------------- measuring */

enum { LEVELS = 5, FIRST = 6 };

typedef struct figures {
    double ns, flops, bytes, of_flops, of_bytes;
} figures;

/* Creates a thermal contact and marches one step. */
static ovr_simulation *hot_contact(int level, const ovr_kernels *set)
{
    test_hot hot = test_hot_make(20, 10, 0.5, 5e6, NULL);
    ovr_error err = {0};
    ovr_simulation *sim = test_hot_simulation(&hot, level);
    ovr_hierarchy_kernels(&sim->grids, set);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    CHECK_OK(ovr_simulation_step(sim, sim->finest->grid.D, &err), &err);
    return sim;
}

static void one_level(const ovr_kernels *set, double peak, int level,
                      figures found[KERNELS])
{
    ovr_error err;
    bench_work work[KERNELS];
    ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                        OVR_STOP_TRUNCATION);
    double n = (double)sim->finest->grid.n;
    ovr_hierarchy_kernels(&sim->grids, set);
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
    ovr_simulation *hot = hot_contact(level, set);
    for (size_t k = 0; k < KERNELS; k++)
        work[k] = (bench_work){kernels[k].run, kernels[k].hot ? hot : sim, 0};
    bench_measure(KERNELS, work, 2e-3, 15);
    work[SOLVE].seconds -= work[ASSEMBLE].seconds;
    for (size_t k = 0; k < KERNELS; k++) {
        double flops = kernels[k].flops, bytes = kernels[k].bytes;
        double seconds = work[k].seconds / n;
        if (flops == 0)
            count_deformation(&sim->finest->mlmi, &flops, &bytes);
        found[k] = (figures){.ns = 1e9 * seconds,
                             .flops = flops,
                             .bytes = bytes,
                             .of_flops = flops / seconds / peak,
                             .of_bytes = bytes / seconds /
                                         bench_bandwidth((size_t)(bytes * n))};
    }
    ovr_simulation_free(sim);
    ovr_simulation_free(hot);
}

static void print_set(const char *set, double peak,
                      figures found[LEVELS][KERNELS])
{
    printf("\n%s: ns per node, %% of %.1f Gflop/s, %% of the triad's bytes\n"
           "%-16s %5s %5s",
           set, 1e-9 * peak, "", "flops", "bytes");
    for (int l = 0; l < LEVELS; l++)
        printf(" |   level %2d   ", FIRST + 2 * l);
    printf("\n");
    for (size_t k = 0; k < KERNELS; k++) {
        const figures *some = &found[LEVELS / 2][k];
        printf("%-16s %5.0f %5.0f", kernels[k].name, some->flops, some->bytes);
        for (int l = 0; l < LEVELS; l++) {
            const figures *f = &found[l][k];
            printf(" | %5.2f %3.0f %3.0f", f->ns, 100 * f->of_flops,
                   100 * f->of_bytes);
            bench_row();
            bench_text("kernels", set);
            bench_text("kernel", kernels[k].name);
            bench_number("level", FIRST + 2 * l);
            bench_number("ns_a_node", f->ns);
            bench_number("flops_a_node", f->flops);
            bench_number("bytes_a_node", f->bytes);
            bench_number("share_of_peak_flops", f->of_flops);
            bench_number("share_of_bandwidth", f->of_bytes);
            bench_end();
        }
        printf("\n");
    }
}

static void one_set(const char *set)
{
    figures found[LEVELS][KERNELS];
    double peak = bench_peak_flops(set);
    for (int l = 0; l < LEVELS; l++)
        one_level(ovr_kernels_choose(set), peak, FIRST + 2 * l, found[l]);
    print_set(set, peak, found);
}

/* ---------------------------------------------------------------- peaks */

static void bandwidths(void)
{
    printf("triad, GB/s for arrays of a number of kB:");
    bench_list("triad");
    for (size_t kB = 12; kB <= (size_t)12 << 14; kB *= 4) {
        double rate = bench_bandwidth(1024 * kB);
        printf("  %zu: %.0f", kB, 1e-9 * rate);
        bench_row();
        bench_number("kB", (double)kB);
        bench_number("bytes_a_second", rate);
        bench_end();
    }
    printf("\n");
    bench_end();
}

/* Performs a Newton step on the coarsest grid, 2/3 m^3 operations. */
static void solve_dense(void *sim)
{
    ovr_simulation *s = sim;
    ovr_newton_step(&s->grids, &s->grids.level[s->grids.coarsest], 0);
}

static void coarsest_grid(void)
{
    printf("\nNewton step of the coarsest grid, 57 nodes, us (%% of peak "
           "flops):");
    bench_list("newton_step");
    for (int k = 0; bench_sets[k]; k++) {
        ovr_error err;
        if (!ovr_kernels_choose(bench_sets[k]))
            continue;
        ovr_simulation *sim = bench_contact(6, OVR_UPSTREAM2,
                                            OVR_STOP_TRUNCATION);
        ovr_hierarchy_kernels(&sim->grids, ovr_kernels_choose(bench_sets[k]));
        CHECK_OK(ovr_simulation_steady(sim, &err), &err);
        bench_work work = {solve_dense, sim, 0};
        double m = (double)sim->grids.level[sim->grids.coarsest].grid.n + 1;
        bench_measure(1, &work, 1e-3, 15);
        printf("  %s %.1f (%.0f)", bench_sets[k], 1e6 * work.seconds,
               100 * 2 / 3. * pow(m, 3) / work.seconds /
                   bench_peak_flops(bench_sets[k]));
        bench_row();
        bench_text("kernels", bench_sets[k]);
        bench_number("us", 1e6 * work.seconds);
        bench_end();
        ovr_simulation_free(sim);
    }
    printf("\n");
    bench_end();
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    bandwidths();
    bench_list("kernels");
    for (int k = 0; bench_sets[k]; k++)
        if (ovr_kernels_choose(bench_sets[k]))
            one_set(bench_sets[k]);
    bench_end();
    coarsest_grid();
    bench_close();
    return 0;
}
