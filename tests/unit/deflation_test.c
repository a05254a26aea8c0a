/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Coarse correction of Newton's method on fine grids: the coarse rows of the
 * remaining residual vanish, compared with a dense matrix. */
#include "support/test.h"

#include <math.h>
#include <stdlib.h>

#include "mathematics/draws.h"
#include "multigrid/kernels.h"
#include "multigrid/tripoles.h"

enum { N = 200, STRIDE = 16, HATS = 11 };

static double random_at(uint64_t stream, uint64_t i)
{
    return 2 * ovr_uniform_at(7, stream, i) - 1;
}

static double hat(int i, int middle)
{
    return fmax(0, 1 - fabs((double)(i - middle)) / STRIDE);
}

/* Row i of the matrix times a step. */
static double times(const ovr_newton_row *row, int i, const double *kernel,
                    const double *step)
{
    double sum = 0;
    for (int m = 0; m < 4; m++) {
        int j = i + m - 2;
        double w = 0;
        if (j < 0 || j >= N)
            continue;
        for (int k = 0; k < N; k++)
            w += kernel[j - k] * step[k];
        sum += row[i].e[m] * (w - step[N]) + row[i].local[m] * step[j];
    }
    return sum;
}

TEST(rest_of_the_coarse_correction)
{
    static double of[2 * (N + 2) + 1], v[N], u[N], step[N + 1];
    static ovr_newton_row row[N];
    const double D = 0.02, *kernel = of + N + 2;
    const ovr_kernels *run = ovr_kernels_choose(NULL);
    ovr_arena arena = ovr_arena_make(NULL);
    ovr_error err = {0};
    ovr_deflation d;
    for (int k = -N - 2; k <= N + 2; k++)
        of[k + N + 2] = 0.01 * log(fabs((double)k) + 0.3);
    for (uint64_t i = 0; i < N; i++) {
        v[i] = random_at(1, i);
        for (uint64_t m = 0; m < 4; m++) {
            row[i].e[m] = random_at(2, 4 * i + m);
            row[i].local[m] = random_at(3, 4 * i + m);
        }
        row[i].e[2] += 4;
    }
    CHECK_OK(ovr_deflation_take(&d, N, &arena, &err), &err);
    assert_int_equal(d.count, HATS);
    assert_true(ovr_deflation_factor(&d, run, row, N, D, kernel));
    ovr_deflation_apply(&d, run, N, D, v, u);
    ovr_deflation_add(&d, N, step);
    /* The remainder is v - A Q v, and its coarse rows and force vanish */
    double force = 0, largest = 0;
    for (int j = 0; j < N; j++)
        force += D * step[j];
    CHECK_NEAR(v[N - 2] - force, 0, 1e-10);
    CHECK_NEAR(u[N - 2], 0, 1e-10);
    for (int i = 1; i + 1 < N; i++) {
        double left = v[i - 1] - times(row, i, kernel, step);
        CHECK_NEAR(u[i - 1], left, 1e-10);
        largest = fmax(largest, fabs(left));
    }
    for (int k = 1; k <= HATS; k++) {
        double sum = 0;
        for (int i = 1; i + 1 < N; i++)
            sum += hat(i, STRIDE * k) * u[i - 1];
        CHECK_NEAR(sum, 0, 1e-10);
    }
    assert_true(largest > 0.1);
    ovr_arena_release(&arena);
}
