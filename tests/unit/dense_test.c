/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dense solver of the coarsest grid. */
#include <math.h>
#include <string.h>

#include "multigrid/kernels.h"
#include "support/test.h"

static const char *const names[] = {"base", "avx2", "avx512"};
enum { NAMES = sizeof names / sizeof *names };

/* Elimination in panels against the matrix it was given, at every size about
 * that of a panel, with rows that need exchanging. */
static void dense_solver_solves(void **state)
{
    enum { MOST = 67, STRIDE = 80 };
    static double A[MOST * STRIDE], kept[MOST * STRIDE], x[MOST + 8];
    uint64_t seed = 12;
    (void)state;
    for (int k = 0; k < NAMES; k++)
        for (size_t m = 1; ovr_kernels_choose(names[k]) && m <= MOST; m++) {
            for (size_t i = 0; i < MOST * STRIDE; i++)
                A[i] = test_random(&seed, -1, 1);
            memcpy(kept, A, sizeof A);
            assert_true(
                ovr_kernels_choose(names[k])->dense_solve(m, STRIDE, A, x));
            for (size_t i = 0; i < m; i++) {
                const double *row = kept + i * STRIDE;
                double sum = -row[m], size = 1;
                for (size_t j = 0; j < m; j++) {
                    sum += row[j] * x[j];
                    size = fmax(size, fabs(x[j]));
                }
                CHECK_NEAR(sum, 0, 1e-12 * size);
            }
        }
    memset(A, 0, sizeof A);
    assert_false(ovr_kernels_choose(NULL)->dense_solve(5, STRIDE, A, x));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(dense_solver_solves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
