/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Multigrid beside a dense Newton solution of the same equations by LAPACK
 * (dgesv: the time of one linear solution; a solve needs some ten of them and
 * as many matrices), and beside the paper's Table 1.
 */
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/test.h"

#if defined(HAVE_lapacke) && defined(HAVE_openblas)
#include <cblas.h>
#include <lapacke.h>
void openblas_set_num_threads(int);

typedef struct dense_system {
    lapack_int n, *pivots;
    double *A, *x, *work;
    uint64_t seed;
} dense_system;

static void factor(void *data)
{
    dense_system *s = data;
    size_t n = (size_t)s->n;
    for (size_t i = 0; i < n * n; i++)
        s->work[i] = s->A[i];
    for (size_t i = 0; i < n; i++)
        s->x[i] = 1;
    LAPACKE_dgesv(LAPACK_COL_MAJOR, s->n, 1, s->work, s->n, s->pivots, s->x,
                  s->n);
}

static double lapack_seconds(size_t n)
{
    dense_system s = {.n = (lapack_int)n, .seed = 1};
    bench_work work = {factor, &s, 0};
    s.pivots = calloc(n, sizeof *s.pivots);
    s.A = calloc(n * n, sizeof *s.A);
    s.work = calloc(n * n, sizeof *s.work);
    s.x = calloc(n, sizeof *s.x);
    openblas_set_num_threads(1);
    for (size_t i = 0; i < n * n; i++)
        s.A[i] = test_random(&s.seed, -1, 1);
    bench_measure(1, &work, 0, 5);
    free(s.pivots);
    free(s.A);
    free(s.work);
    free(s.x);
    return work.seconds;
}
#else
static double lapack_seconds(size_t n)
{
    (void)n;
    return 0;
}
#endif

static void solve(void *sim)
{
    ovr_error err;
    ovr_simulation_steady(sim, &err);
}

int main(int argc, char *argv[])
{
    enum { STEPS = 10 };
    bench_open(argc, argv);
    printf("\n%6s %6s %16s %20s %10s\n", "level", "n", "multigrid ms",
           "10 LAPACK steps ms", "ratio");
    bench_list("dense_newton");
    for (int level = 6; level <= 8; level++) {
        ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                            OVR_STOP_TRUNCATION);
        bench_work work = {solve, sim, 0};
        double dense = STEPS * lapack_seconds(sim->finest->n);
        bench_measure(1, &work, 2e-3, 9);
        printf("%6d %6zu %16.3f %20.1f %10.0f\n", level, sim->finest->n,
               1e3 * work.seconds, 1e3 * dense, dense / work.seconds);
        bench_row();
        bench_number("n", (double)sim->finest->n);
        bench_number("multigrid_seconds", work.seconds);
        bench_number("dense_seconds", dense);
        bench_end();
        ovr_simulation_free(sim);
    }
    bench_end();
    printf("\nlike the paper's Table 1: first order, 2 V(1,1) a level\n"
           "%6s %9s %12s\n",
           "level", "n", "ms");
    bench_list("table_1");
    for (int level = 5; level <= 14; level++) {
        ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM1,
                                            OVR_STOP_FIXED);
        bench_work work = {solve, sim, 0};
        bench_measure(1, &work, 0, level < 12 ? 15 : 5);
        printf("%6d %9zu %12.3f\n", level, sim->finest->n, 1e3 * work.seconds);
        bench_row();
        bench_number("n", (double)sim->finest->n);
        bench_number("seconds", work.seconds);
        bench_end();
        ovr_simulation_free(sim);
    }
    bench_end();
    bench_close();
    return 0;
}
