/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searches along the nodes compared with plain loops, and the plain loops with
 * small cases. */
#include <math.h>

#include "support/kernels.h"
#include "support/test.h"

enum { MAX = 120 };

/* Arrays with a few equal values, some of them zero. */
typedef struct arrays {
    size_t n;
    double P[MAX], q[MAX], eps[MAX], X[MAX], past[3][MAX];
} arrays;

static arrays make(size_t n, uint64_t *seed)
{
    arrays a = {.n = n};
    for (size_t i = 0; i < n; i++) {
        a.P[i] = fmax(0, floor(test_random(seed, -3, 6)));
        a.q[i] = test_random(seed, 1, 2);
        a.X[i] = (double)i + test_random(seed, 0, 0.5);
        a.eps[i] = test_random(seed, 0, 1);
        for (int k = 0; k < 3; k++)
            a.past[k][i] = test_random(seed, 1, 2);
    }
    return a;
}

static void check_extremes(const ovr_kernels *run, const arrays *a)
{
    const ovr_kernels *plain = test_kernels(0);
    const double *P = a->P, *q = a->q;
    size_t n = a->n;
    for (int sign = -1; sign <= 1; sign += 2)
        assert_int_equal(run->extreme(n, sign, P), plain->extreme(n, sign, P));
    assert_true(run->difference(n, q, P) == plain->difference(n, q, P));
    CHECK_NEAR(run->gain(n, a->eps, q, P), plain->gain(n, a->eps, q, P),
               1e-12 * (double)n);
    CHECK_NEAR(run->gain(5, a->eps, q, P), plain->gain(5, a->eps, q, P), 1e-13);
    CHECK_NEAR(run->gain(n, P, q, NULL), plain->gain(n, P, q, NULL),
               1e-12 * (double)n);
}

static void check_peaks(const ovr_kernels *run, const arrays *a)
{
    size_t last = 0, found = 0;
    assert_int_equal(run->peaks(a->n, a->P, &found),
                     test_kernels(0)->peaks(a->n, a->P, &last));
    assert_int_equal(found, last);
}

static void check_means(const ovr_kernels *run, arrays *a)
{
    const double u[2] = {1.2, -0.4}, e[3] = {0.5, 0.3, -0.1};
    const ovr_kernels *plain = test_kernels(0);
    double *const past[] = {a->past[0], a->past[1], a->past[2]};
    size_t n = a->n;
    CHECK_NEAR(run->mean_flow(n, u, a->X, a->P, a->q, a->eps, NULL),
               plain->mean_flow(n, u, a->X, a->P, a->q, a->eps, NULL),
               1e-12 * (double)n);
    CHECK_NEAR(run->flow_size(n, 1.2, a->X, a->P, a->q, a->eps, NULL),
               plain->flow_size(n, 1.2, a->X, a->P, a->q, a->eps, NULL),
               1e-12 * (double)n);
    CHECK_NEAR(run->flow_size(n, 1.2, a->X, a->P, a->q, NULL, a->eps),
               plain->flow_size(n, 1.2, a->X, a->P, a->q, NULL, a->eps),
               1e-12 * (double)n);
    CHECK_NEAR(run->deviation(n, e, 0.9, a->X, a->P, a->q, past),
               plain->deviation(n, e, 0.9, a->X, a->P, a->q, past),
               1e-13 * (double)n);
}

static void check_film_sums(const ovr_kernels *run, const arrays *a)
{
    const ovr_kernels *plain = test_kernels(0);
    double sums[5], expected[5];
    for (size_t n = 0; n <= a->n; n += a->n - 5 > n ? 5 : 1) {
        run->film_sums(n, a->eps, a->q, a->past[0], sums);
        plain->film_sums(n, a->eps, a->q, a->past[0], expected);
        for (int k = 0; k < 5; k++)
            CHECK_NEAR(sums[k], expected[k], 1e-13 * (double)(n + 1));
    }
}

/* Content 2, 4, 6, films 1, 2, 4, weights 1/2, 1, 1/2. */
TEST(film_sums_by_hand)
{
    const double w[] = {0.5, 1, 0.5}, q[] = {2, 4, 6}, H[] = {1, 2, 4};
    double sums[5];
    test_kernels(0)->film_sums(3, w, q, H, sums);
    assert_true(sums[0] == 2 && sums[1] == 4.5 && sums[2] == 3.75);
    assert_true(sums[3] == 4 && sums[4] == 12);
}

TEST(scans_agree)
{
    const ovr_kernels *run;
    uint64_t seed = 5;
    for (int k = 1; (run = test_kernels(k)); k++)
        for (size_t n = 13; n < MAX; n++) {
            arrays a = make(n, &seed);
            check_extremes(run, &a);
            check_peaks(run, &a);
            check_means(run, &a);
            check_film_sums(run, &a);
        }
}

/* Plain scans, by hand: equal values, a peak with a shoulder, pairs of
 * pressurized nodes only at 1 and 2 (a pair at an end does not count). */
TEST(plain_scans_by_hand)
{
    const double x[] = {3, 1, 4, 4, 1, 5, 0, 5}, y[] = {3, 2, 4, 1, 1, 5, 7, 5};
    const double P[] = {1, 2, 4, 3, 0, 1, 2}, q[] = {1, 2, 4, 8, 0, 8, 9};
    const double eps[] = {0, 1, 3, 5, 0, 0, 0}, zero[7] = {0};
    const double X[] = {0, 0.5, 1, 2, 3, 4, 5};
    const double w[] = {1, 2, 1, 0.5, 1, 1, 1, 1};
    const double u[2] = {2, 1}, e[3] = {1, 0.5, 0.25};
    double *const past[3] = {(double[]){1, 1, 1, 1, 9, 6, 6},
                             (double[]){0, 2, 2, 4, 9, 2, 2},
                             (double[]){0, 0, 8, 12, 9, 4, 4}};
    const ovr_kernels *run = test_kernels(0);
    size_t last = 0;
    assert_int_equal(run->extreme(8, 1, x), 6);
    assert_int_equal(run->extreme(5, 1, x), 1);
    assert_int_equal(run->extreme(8, -1, x), 5);
    assert_int_equal(run->peaks(8, x, &last), 2);
    assert_int_equal(last, 5);
    assert_true(run->difference(8, x, y) == 7);
    assert_true(run->gain(8, w, x, y) == -7.5);
    assert_true(run->gain(8, w, x, NULL) == 22);
    /* 2*2 + 1 - 2*2/0.5 = -3 and 2*4 + 2 + 4*1/1 = 14 */
    assert_true(run->mean_flow(7, u, X, P, q, eps, NULL) == 5.5);
    /* |1.5 - .5|, |3 - 4|, 12 + 4, 8 + 7.5, 8, 17; then |1.5 - 0|, |3 - 1| */
    assert_true(run->flow_size(7, 2, X, P, q, eps, NULL) == 58.5);
    assert_true(run->flow_size(3, 2, X, P, q, NULL, eps) == 3.5);
    /* off by 0, 0, 0, 2, (dry), 0, 1 */
    assert_true(run->deviation(7, e, INFINITY, w, P, q, past) ==
                2 * w[3] + w[6]);
    assert_true(run->deviation(7, e, q[6], w, P, q, past) ==
                (q[3] < q[6] ? 2 * w[3] : 0));
    assert_true(run->mean_flow(7, u, X, zero, q, eps, NULL) == 0);
}

/* One node among many, wherever it is. */
TEST(one_bad_node_is_found)
{
    const double bad[] = {0, -1, NAN, -INFINITY};
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++)
        for (size_t n = 13; n < 40; n++) {
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

/* Nothing wet: no mean, no division by zero. */
TEST(dry_has_no_means)
{
    arrays a = {.n = 57};
    const double none[3] = {0};
    double *const past[3] = {a.past[0], a.past[1], a.past[2]};
    const ovr_kernels *run;
    for (int k = 0; (run = test_kernels(k)); k++) {
        assert_true(run->mean_flow(a.n, none, a.X, a.P, a.q, a.eps, NULL) == 0);
        assert_true(run->deviation(a.n, none, INFINITY, a.X, a.P, a.q, past) ==
                    0);
    }
}
