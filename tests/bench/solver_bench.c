/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The solver in convolutions: MLMI, a V(1,1) cycle and full multigrid, each
 * in units of one FFTW convolution of the same n measured in the same rounds;
 * growth per doubling of n; the largest steady solution; the reference dent.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

static const char *const sets[] = {"avx512", "avx2", "base"};
enum { SETS = sizeof sets / sizeof *sets };

static void deform(void *sim)
{
    ovr_simulation *s = sim;
    s->grids.kernels->deformation(&s->finest->mlmi, s->finest->f.P,
                                  s->finest->w);
}

static void cycle(void *sim)
{
    ovr_simulation *s = sim;
    ovr_cycle(&s->grids, s->finest);
}

static void solve(void *sim)
{
    ovr_error err;
    ovr_simulation_steady(sim, &err);
}

static double last[SETS][3], last_n[SETS];

static double growth(double *before, double now, double ratio)
{
    double factor = *before > 0 ? pow(now / *before, 1 / log2(ratio)) : NAN;
    *before = now;
    return factor;
}

static void solver_row(int set, int level)
{
    const ovr_kernels *kernels = ovr_kernels_choose(sets[set]);
    if (!kernels)
        return;
    ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                        OVR_STOP_TRUNCATION);
    sim->grids.kernels = kernels;
    solve(sim);
    double n = (double)sim->finest->n;
    bench_fft *fft = bench_fft_plan(sim->finest->n, sim->finest->D);
    bench_work work[] = {{bench_fft_run, fft, 0},
                         {deform, sim, 0},
                         {cycle, sim, 0},
                         {solve, sim, 0}};
    bench_measure(4, work, level < 14 ? 2e-3 : 0, level < 14 ? 15 : 5);
    double unit = fft ? work[0].seconds : NAN, ratio = n / last_n[set];
    last_n[set] = n;
    bench_row();
    bench_text("kernels", sets[set]);
    bench_number("level", level);
    bench_number("n", n);
    bench_number("fft_us", 1e6 * unit);
    printf("%-7s %5d %9.0f %9.1f |", sets[set], level, n, 1e6 * unit);
    const char *const names[] = {"mlmi", "cycle", "fmg"};
    for (int k = 0; k < 3; k++) {
        double t = work[k + 1].seconds, grows = growth(&last[set][k], t, ratio);
        char name[32];
        snprintf(name, sizeof name, "%s_us", names[k]);
        bench_number(name, 1e6 * t);
        snprintf(name, sizeof name, "%s_in_ffts", names[k]);
        bench_number(name, t / unit);
        snprintf(name, sizeof name, "%s_growth_per_doubling", names[k]);
        bench_number(name, grows);
        printf(" %9.1f %6.3f %5.2f |", 1e6 * t, t / unit, grows);
    }
    bench_number("fmg_cycles", sim->observation.cycles);
    bench_end();
    printf(" %d\n", sim->observation.cycles);
    bench_fft_free(fft);
    ovr_simulation_free(sim);
}

static void largest_steady(void)
{
    double n = 0;
    ovr_simulation *sim = bench_contact(17, OVR_UPSTREAM1, OVR_STOP_FIXED);
    bench_work work = {solve, sim, 0};
    bench_measure(1, &work, 0, 5);
    n = (double)sim->finest->n;
    printf("\nsteady, first order, 2 V(1,1) a level, n = %.0f: %.3f s\n", n,
           work.seconds);
    bench_number("steady_917505_seconds", work.seconds);
    ovr_simulation_free(sim);
}

typedef struct rolling {
    ovr_simulation *sim;
    double depth, width, start;
} rolling;

/* depth 10^(-10 xi^2) cos(2 pi xi), no more than 1e-30 beyond |xi| = sqrt 3 */
static void dent_heights(void *data, double T, size_t n, const double *X,
                         double *S)
{
    const rolling *r = data;
    for (size_t i = 0; i < n; i++) {
        double xi = (X[i] - r->start - T) / r->width;
        S[i] = xi * xi > 3 ? 0
                           : -r->depth * exp(-10 * log(10) * xi * xi) *
                                 cos(2 * acos(-1) * xi);
    }
}

static void roll(void *data)
{
    rolling *r = data;
    ovr_error err;
    ovr_march march = {.end = 6};
    ovr_simulation_surface(r->sim, dent_heights, r);
    ovr_simulation_steady(r->sim, &err);
    ovr_simulation_march(r->sim, &march, &err);
}

static void reference_dent(int level, int rounds)
{
    rolling r = {bench_contact(level, OVR_UPSTREAM2, OVR_STOP_NEGLIGIBLE), 0.1,
                 0.5, -4.6};
    bench_work work = {roll, &r, 0};
    bench_measure(1, &work, 0, rounds);
    const ovr_statistics *s = ovr_simulation_statistics(r.sim);
    printf("dent, level %d, second order, to T = 6: %.3f s, %ld steps, %.2f "
           "cycles a step, %.1f us a step\n",
           level, work.seconds, s->steps, (double)s->cycles / (double)s->steps,
           1e6 * work.seconds / (double)s->steps);
    bench_row();
    bench_number("level", level);
    bench_number("seconds", work.seconds);
    bench_number("steps", (double)s->steps);
    bench_number("cycles", (double)s->cycles);
    bench_end();
    ovr_simulation_free(r.sim);
}

int main(int argc, char *argv[])
{
    static const int levels[] = {6, 8, 10, 12, 14, 16};
    bench_open(argc, argv);
    printf("M = 20, L = 10, second order; CPU time, medians\n"
           "%-7s %5s %9s %9s | %23s | %23s | %23s | cycles\n"
           "%-7s %5s %9s %9s |",
           "kernels", "level", "n", "FFT us", "MLMI", "V(1,1)",
           "FMG to truncation", "", "", "", "");
    for (int k = 0; k < 3; k++)
        printf(" %9s %6s %5s |", "us", "FFTs", "grows");
    printf("\n");
    bench_list("solver");
    for (int set = 0; set < SETS; set++)
        for (size_t k = 0; k < sizeof levels / sizeof *levels; k++)
            if (set == 0 || levels[k] <= 12)
                solver_row(set, levels[k]);
    bench_end();
    largest_steady();
    bench_list("dent");
    for (int level = 6; level <= 9; level++)
        reference_dent(level, level < 9 ? 5 : 1);
    bench_end();
    bench_close();
    return 0;
}
