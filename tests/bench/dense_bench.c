/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Multigrid compared with Newton's method with the full matrix of the same
 * equations, from the same initial guess (Hertzian pressure) to the same
 * tolerance. LAPACK factors the matrix on one core. The times of Table 1 of the
 * paper are printed for comparison. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench.h"
#include "simulation/internal.h"
#include "support/contact.h"
#include "support/test.h"

static void solve(void *sim)
{
    ovr_error err;
    CHECK_OK(ovr_simulation_steady(sim, &err), &err);
}

#if defined(HAVE_lapacke) && defined(HAVE_openblas)
#include <cblas.h>
#include <lapacke.h>
void openblas_set_num_threads(int);

enum { MAX = 1800 };
static int newton_steps;

/* Solves with LAPACK. Rows of the kernel are columns of LAPACK, so that it
 * solves the transposed system. */
static bool by_lapack(size_t m, size_t stride, double *A, double *x)
{
    static lapack_int pivots[MAX];
    lapack_int n = (lapack_int)m, lda = (lapack_int)stride;
    for (size_t i = 0; i < m; i++)
        x[i] = A[i * stride + m];
    newton_steps++;
    return !LAPACKE_dgetrf(LAPACK_COL_MAJOR, n, n, A, lda, pivots) &&
           !LAPACKE_dgetrs(LAPACK_COL_MAJOR, 'T', n, 1, A, lda, pivots, x, n);
}

/* Returns the time of a solution by Newton steps on a single grid. */
static double newton_seconds(int level, double *film)
{
    ovr_options options = test_options();
    ovr_simulation *sim;
    options.level = options.coarsest_level = level;
    sim = test_simulation(20, 10, &options);
    ovr_kernels kernels = *sim->grids.kernels;
    bench_work work = {solve, sim, 0};
    openblas_set_num_threads(1);
    kernels.dense_solve = by_lapack;
    sim->grids.kernels = &kernels;
    newton_steps = 0;
    solve(sim);
    int steps = newton_steps;
    bench_measure(1, &work, 0, 3);
    newton_steps = steps;
    *film = sim->observation.H_cen;
    ovr_simulation_free(sim);
    return work.seconds;
}
#else
static const int newton_steps = 0;
static double newton_seconds(int level, double *film)
{
    (void)level;
    return *film = NAN;
}
#endif

static void beside_newton(void)
{
    printf("\n%6s %6s %13s %13s %13s %7s %9s %9s\n", "level", "n",
           "multigrid ms", "Newton steps", "Newton ms", "ratio", "H_cen",
           "Newton's");
    bench_list("dense_newton");
    for (int level = 6; level <= 8; level++) {
        ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM2,
                                            OVR_STOP_NEGLIGIBLE);
        bench_work work = {solve, sim, 0};
        double film, newton = newton_seconds(level, &film);
        bench_measure(1, &work, 2e-3, 9);
        printf("%6d %6zu %13.3f %13d %13.1f %7.0f %9.6f %9.6f\n", level,
               sim->finest->grid.n, 1e3 * work.seconds, newton_steps,
               1e3 * newton, newton / work.seconds, sim->observation.H_cen,
               film);
        bench_row();
        bench_number("n", (double)sim->finest->grid.n);
        bench_number("multigrid_seconds", work.seconds);
        bench_number("newton_steps", newton_steps);
        bench_number("newton_seconds", newton);
        bench_end();
        ovr_simulation_free(sim);
    }
    bench_end();
}

/* Seconds for levels 5 to 14 on an HP 9000/800 (1990). */
static const double paper[] = {12, 24, 48, 98, 197, 398, 800, 1610, 3780, 7680};

static void beside_the_paper(void)
{
    printf("\nlike the paper's Table 1: first order, 2 V(1,1) per level\n"
           "%6s %9s %10s %10s %15s\n",
           "level", "n", "ms", "paper s", "times as fast");
    bench_list("table_1");
    for (int level = 5; level <= 14; level++) {
        ovr_simulation *sim = bench_contact(level, OVR_UPSTREAM1,
                                            OVR_STOP_FIXED);
        bench_work work = {solve, sim, 0};
        double then = paper[level - 5];
        bench_measure(1, &work, 0, level < 12 ? 15 : 5);
        printf("%6d %9zu %10.3f %10.0f %15.0f\n", level, sim->finest->grid.n,
               1e3 * work.seconds, then, then / work.seconds);
        bench_row();
        bench_number("n", (double)sim->finest->grid.n);
        bench_number("seconds", work.seconds);
        bench_number("paper_seconds", then);
        bench_end();
        ovr_simulation_free(sim);
    }
    bench_end();
}

int main(int argc, char *argv[])
{
    bench_open(argc, argv);
    beside_newton();
    beside_the_paper();
    bench_close();
    return 0;
}
