/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Dense linear algebra of the coarsest grid. */
#include <math.h>
#include <string.h>

#include "support/kernels.h"
#include "support/test.h"

enum { MAX = 67, STRIDE = 80 };

static double *solution(const ovr_kernels *run, size_t m, const double *A)
{
    static double copy[MAX * STRIDE], x[MAX + 8];
    memcpy(copy, A, sizeof copy);
    assert_true(run->dense_solve(m, STRIDE, copy, x));
    return x;
}

/* Largest of 1 and |x|. */
static double size_of(size_t m, const double *x)
{
    double size = 1;
    for (size_t j = 0; j < m; j++)
        size = fmax(size, fabs(x[j]));
    return size;
}

/* What an elimination leaves of the matrix it was given, at every size about
 * that of a panel, with rows that need exchanging; and beside the plain one, as
 * well as the matrix knows x.  The space behind b may hold anything. */
TEST(dense_solver_solves)
{
    static double A[MAX * STRIDE], plain[MAX];
    const ovr_kernels *run;
    uint64_t seed = 12;
    for (int k = 0; (run = test_kernels(k)); k++)
        for (size_t m = 1; m <= MAX; m++) {
            for (size_t i = 0; i < MAX * STRIDE; i++)
                A[i] = i % STRIDE > m ? NAN : test_random(&seed, -1, 1);
            memcpy(plain, solution(test_kernels(0), m, A), sizeof plain);
            const double *x = solution(run, m, A);
            double size = size_of(m, x);
            for (size_t i = 0; i < m; i++) {
                const double *row = A + i * STRIDE;
                double sum = -row[m];
                for (size_t j = 0; j < m; j++)
                    sum += row[j] * x[j];
                CHECK_NEAR(sum, 0, 1e-12 * size);
                CHECK_NEAR(x[i], plain[i], 1e-10 * size);
            }
        }
}

TEST(singular_is_refused)
{
    static double A[5 * STRIDE], x[5 + 8];
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        memset(A, 0, sizeof A);
        assert_false(run->dense_solve(5, STRIDE, A, x));
    }
}

/* Rows of any length. The plain kernel is checked by its response to an
 * impulse. */
TEST(rows_agree)
{
    const double c[4] = {0.3, -2, 5, 0.7};
    const ovr_kernels *run, *plain = test_kernels(0);
    double k[MAX + 16], row[MAX + 8], expected[MAX + 8];
    uint64_t seed = 13;
    memset(k, 0, sizeof k);
    k[4] = 1;
    plain->dense_row(6, c, k + 1, row);
    assert_memory_equal(row, ((double[]){0, c[0], c[1], c[2], c[3], 0}),
                        6 * sizeof *row);
    for (size_t j = 0; j < MAX + 16; j++)
        k[j] = test_random(&seed, -1, 1);
    for (int set = 1; (run = test_kernels(set)); set++)
        for (size_t n = 1; n <= MAX; n++) {
            plain->dense_row(n, c, k + 1, expected);
            run->dense_row(n, c, k + 1, row);
            for (size_t j = 0; j < n; j++)
                CHECK_NEAR(row[j], expected[j], 1e-14);
        }
}
