/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is looked for along the nodes, against plain loops. */
#include <math.h>

#include "multigrid/kernels.h"
#include "support/test.h"

enum { MOST = 120 };

static const char *const names[] = {"base", "avx2", "avx512"};
enum { NAMES = sizeof names / sizeof *names };

/* Arrays with a few equal values, some of them zero. */
typedef struct arrays {
    size_t n;
    double P[MOST], q[MOST], eps[MOST], past[3][MOST];
} arrays;

static arrays make(size_t n, uint64_t *seed)
{
    arrays a = {.n = n};
    for (size_t i = 0; i < n; i++) {
        a.P[i] = fmax(0, floor(test_random(seed, -3, 6)));
        a.q[i] = test_random(seed, 1, 2);
        a.eps[i] = test_random(seed, 0, 1);
        for (int k = 0; k < 3; k++)
            a.past[k][i] = test_random(seed, 1, 2);
    }
    return a;
}

static void check_extremes(const ovr_kernels *run, const arrays *a)
{
    size_t low = 0, high = 0;
    double change = 0, sum = 0;
    for (size_t i = 1; i < a->n; i++) {
        low = a->P[i] < a->P[low] ? i : low;
        high = a->P[i] > a->P[high] ? i : high;
    }
    for (size_t i = 0; i < a->n; i++) {
        change = fmax(change, fabs(a->q[i] - a->P[i]));
        sum += a->q[i] - a->P[i];
    }
    assert_int_equal(run->extreme(a->n, 1, a->P), low);
    assert_int_equal(run->extreme(a->n, -1, a->P), high);
    assert_true(run->difference(a->n, a->q, a->P) == change);
    CHECK_NEAR(run->gain(a->n, a->q, a->P), sum, 1e-12 * (double)a->n);
    CHECK_NEAR(run->gain(5, a->q, a->P),
               a->q[0] + a->q[1] + a->q[2] + a->q[3] + a->q[4] - a->P[0] -
                   a->P[1] - a->P[2] - a->P[3] - a->P[4],
               1e-13);
}

static void check_peaks(const ovr_kernels *run, const arrays *a)
{
    int count = 0;
    size_t last = 0, found = 0;
    for (size_t i = 1; i + 1 < a->n; i++)
        if (a->P[i] > a->P[i - 1] && a->P[i] >= a->P[i + 1])
            count++, last = i;
    assert_int_equal(run->peaks(a->n, a->P, &found), count);
    assert_int_equal(found, last);
}

static void check_means(const ovr_kernels *run, const arrays *a)
{
    const double u[2] = {1.2, -0.4}, D = 0.1, e[3] = {0.5, 0.3, -0.1};
    const double *P = a->P;
    double flow = 0, square = 0, pairs = 0, wet = 0;
    double past[3][MOST];
    for (int k = 0; k < 3; k++)
        for (size_t i = 0; i < MOST; i++)
            past[k][i] = a->past[k][i];
    for (size_t i = 1; i + 2 < a->n; i++)
        if (P[i] > 0 && P[i + 1] > 0) {
            flow += u[0] * a->q[i] + u[1] * a->q[i - 1] -
                    (a->eps[i] + a->eps[i + 1]) * (P[i + 1] - P[i]) / (2 * D);
            pairs++;
        }
    for (size_t i = 0; i < a->n; i++)
        if (P[i] > 0) {
            double off = a->q[i] - e[0] * past[0][i] - e[1] * past[1][i] -
                         e[2] * past[2][i];
            square += off * off;
            wet++;
        }
    CHECK_NEAR(run->mean_flow(a->n, u, D, P, a->q, a->eps),
               pairs > 0 ? flow / pairs : 0, 1e-12 * (double)a->n);
    CHECK_NEAR(run->deviation(a->n, e, P, a->q,
                              (double *const[]){past[0], past[1], past[2]}),
               wet > 0 ? sqrt(square / wet) : 0, 1e-13);
}

static void scans_are_as_defined(void **state)
{
    uint64_t seed = 5;
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        for (size_t n = 13; run && n < MOST; n++) {
            arrays a = make(n, &seed);
            check_extremes(run, &a);
            check_peaks(run, &a);
            check_means(run, &a);
        }
    }
}

/* One node among many, wherever it is. */
static void one_bad_node_is_found(void **state)
{
    const double bad[] = {0, -1, NAN, -INFINITY};
    (void)state;
    for (int k = 0; k < NAMES; k++) {
        const ovr_kernels *run = ovr_kernels_choose(names[k]);
        for (size_t n = 13; run && n < 40; n++) {
            double x[40];
            for (size_t i = 0; i < n; i++)
                x[i] = 1;
            assert_true(run->positive(n, x));
            for (size_t i = 0; i < n; i++) {
                x[i] = bad[i % 4];
                assert_false(run->positive(n, x));
                x[i] = 1;
            }
        }
    }
}

/* Nothing wet: no mean, no division by zero. */
static void dry_has_no_means(void **state)
{
    arrays a = {.n = 57};
    const double none[3] = {0};
    double *const past[3] = {a.past[0], a.past[1], a.past[2]};
    const ovr_kernels *run = ovr_kernels_choose(NULL);
    (void)state;
    assert_true(run->mean_flow(a.n, none, 1, a.P, a.q, a.eps) == 0);
    assert_true(run->deviation(a.n, none, a.P, a.q, past) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scans_are_as_defined),
        cmocka_unit_test(one_bad_node_is_found),
        cmocka_unit_test(dry_has_no_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
