/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Samples, distributions and statistics compared with SciPy and NumPy, closed
 * forms, and simulations of their confidence levels. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <gsl/gsl_qrng.h>

#include "mathematics/draws.h"
#include "mathematics/sample.h"

/* ------------------------------------------------------------------- draws */

static const double u_of_truth[] = {1e-06, 0.01, 0.25, 0.5, 0.9, 0.999};
static const struct {
    ovr_distribution d;
    double x[6];
} inverses[] = {
    {{OVR_NORMAL, 10, 2, 0, -INFINITY, INFINITY},
     {0.49315138235420264, 5.3473042519183185, 8.651020499607837, 10.0,
      12.5631031310892, 16.180464612335626}},
    {{OVR_LOGNORMAL, 10, 2, 0, -INFINITY, INFINITY},
     {3.8251440499811435, 6.18582067170488, 8.579685880089244, 9.8058067569092,
      12.638857897542271, 18.08297959849042}},
    {{OVR_UNIFORM, 2, 5, 0, -INFINITY, INFINITY},
     {2.000003, 2.03, 2.75, 3.5, 4.7, 4.997}},
    {{OVR_TRIANGULAR, 1, 2, 5, -INFINITY, INFINITY},
     {1.002, 1.2, 2.0, 2.550510257216822, 3.904554884989668,
      4.890455488498967}},
    {{OVR_NORMAL, 10, 2, 0, 8, 13},
     {8.000006401900945, 8.06302620178484, 9.241707546129154,
      10.230739771256241, 12.12273944336825, 12.98809291014743}},
};

TEST(distributions)
{
    for (size_t k = 0; k < sizeof inverses / sizeof *inverses; k++)
        for (int i = 0; i < 6; i++)
            CHECK_CLOSE(ovr_distribution_inverse(&inverses[k].d, u_of_truth[i]),
                        inverses[k].x[i], 1e-9);
    assert_non_null(ovr_distribution_wrong(
        &(ovr_distribution){OVR_NORMAL, 1, 0, 0, -INFINITY, INFINITY}));
    assert_non_null(ovr_distribution_wrong(
        &(ovr_distribution){OVR_TRIANGULAR, 1, 3, 2, -INFINITY, INFINITY}));
    assert_null(ovr_distribution_wrong(&inverses[4].d));
}

/* The hash by its published values; the numbers by their moments. */
TEST(uniform_numbers)
{
    double sum = 0, squares = 0, product = 0;
    const size_t n = 100000;
    assert_true(ovr_text_hash("") == 0xcbf29ce484222325u);
    assert_true(ovr_text_hash("a") == 0xaf63dc4c8601ec8cu);
    assert_true(ovr_text_hash("foobar") == 0x85944171f73967e8u);
    for (size_t i = 0; i < n; i++) {
        double u = ovr_uniform_at(7, 1, i), v = ovr_uniform_at(7, 2, i);
        assert_true(u > 0 && u < 1);
        sum += u - 0.5;
        squares += (u - 0.5) * (u - 0.5);
        product += (u - 0.5) * (v - 0.5);
    }
    /* four standard errors */
    CHECK_NEAR(sum / (double)n, 0, 4 * sqrt(1.0 / 12 / (double)n));
    CHECK_NEAR(squares / (double)n, 1.0 / 12, 4 * sqrt(1.0 / 180 / (double)n));
    CHECK_NEAR(product / (double)n, 0, 4.0 / 12 / sqrt((double)n));
}

static void take(ovr_design design, size_t draws, size_t shifts, uint64_t seed,
                 double *u)
{
    static const char *const keys[] = {"a.b", "a.c", "d.e"};
    const ovr_sampling how = {design, seed, draws, keys, 3, shifts};
    ovr_error err = {0};
    CHECK_OK(ovr_sampling_check(&how, &err), &err);
    for (size_t k = 0; k < how.keys; k++)
        for (size_t i = 0; i < draws; i++)
            u[k * draws + i] = ovr_draw_at(&how, k, i);
}

/* All 40 dimensions of 5000 points are GSL's. */
TEST(sobol_of_gsl)
{
    enum { N = 5000 };
    char name[OVR_SOBOL_MAX][8];
    const char *keys[OVR_SOBOL_MAX];
    double point[OVR_SOBOL_MAX], origin[OVR_SOBOL_MAX];
    gsl_qrng *all = gsl_qrng_alloc(gsl_qrng_sobol, OVR_SOBOL_MAX);
    const ovr_sampling how = {OVR_SOBOL, 3, N, keys, OVR_SOBOL_MAX, 1};
    for (size_t k = 0; k < OVR_SOBOL_MAX; k++) {
        snprintf(name[k], sizeof name[k], "k%zu", k);
        keys[k] = name[k];
        origin[k] = ovr_draw_at(&how, k, 0);
    }
    for (size_t i = 1; i < N; i++) {
        gsl_qrng_get(all, point);
        for (size_t k = 0; k < OVR_SOBOL_MAX; k++) {
            double d = ovr_draw_at(&how, k, i) - origin[k];
            CHECK_NEAR(d - floor(d), point[k], 1e-15);
        }
    }
    gsl_qrng_free(all);
}

/* Images of 0 and 1 under many permutations of 5: each pair as often as any
 * other, by chi-squared (19 degrees of freedom, 43.8 is 1 in 1000). */
TEST(latin_is_any_permutation)
{
    enum { N = 5, TRIES = 20000 };
    static const char *const keys[] = {"a"};
    int count[N][N] = {{0}};
    double chi = 0, each = (double)TRIES / (N * (N - 1));
    for (uint64_t seed = 0; seed < TRIES; seed++) {
        const ovr_sampling how = {OVR_LHS, seed, N, keys, 1, 0};
        count[(int)(N * ovr_draw_at(&how, 0, 0))]
             [(int)(N * ovr_draw_at(&how, 0, 1))]++;
    }
    for (int i = 0; i < N; i++)
        for (int k = 0; k < N; k++)
            chi += i == k ? 0 : pow(count[i][k] - each, 2) / each;
    assert_true(chi < 43.8);
}

/* Every stratum once; another seed, another sample. */
TEST(latin)
{
    enum { N = 97 };
    double u[3 * N], other[3 * N];
    take(OVR_LHS, N, 0, 1, u);
    for (int k = 0; k < 3; k++) {
        int seen[N] = {0};
        for (int i = 0; i < N; i++)
            seen[(int)(u[k * N + i] * N)]++;
        for (int i = 0; i < N; i++)
            assert_int_equal(seen[i], 1);
    }
    take(OVR_LHS, N, 0, 2, other);
    assert_true(memcmp(u, other, sizeof u) != 0);
}

/* Points of GSL except for the shift, one per replicate and key; point 0 is the
 * origin. A sample that is enlarged keeps its points. */
static const double points[][3] = {
    {0.5, 0.5, 0.5},       {0.75, 0.25, 0.75},       {0.25, 0.75, 0.25},
    {0.375, 0.375, 0.625}, {0.875, 0.875, 0.125},    {0.625, 0.125, 0.375},
    {0.125, 0.625, 0.875}, {0.1875, 0.3125, 0.3125},
};

TEST(sobol)
{
    enum { SHIFTS = 4, N = 9 * SHIFTS };
    double u[3 * N], plain[3 * N], more[6 * N];
    take(OVR_SOBOL, N, SHIFTS, 1, u);
    for (int k = 0; k < 3; k++)
        for (int r = 0; r < SHIFTS; r++)
            for (int i = 1; i < 9; i++) {
                double d = u[k * N + i * SHIFTS + r] - u[k * N + r];
                CHECK_NEAR(d - floor(d), points[i - 1][k], 1e-15);
            }
    assert_true(fabs(u[0] - u[1]) > 1e-6);
    take(OVR_SOBOL, 2 * N, SHIFTS, 1, more);
    for (int k = 0; k < 3; k++)
        assert_memory_equal(more + 2 * k * N, u + k * N, N * sizeof *u);
    take(OVR_PLAIN, N, 0, 1, plain);
    take(OVR_PLAIN, 2 * N, 0, 1, more);
    for (int k = 0; k < 3; k++)
        assert_memory_equal(more + 2 * k * N, plain + k * N, N * sizeof *u);
}

/* -------------------------------------------------------------- statistics */

static const struct {
    size_t n;
    double p;
    size_t l, u;
    double coverage;
} ranks[] = {
    {20, 0.01, 0, 2, 0.9831406623643483},
    {20, 0.05, 0, 4, 0.9840984739802364},
    {20, 0.1, 0, 6, 0.988746865835491},
    {20, 0.5, 6, 15, 0.9586105346679688},
    {20, 0.9, 15, 21, 0.988746865835491},
    {20, 0.95, 17, 21, 0.9840984739802364},
    {20, 0.99, 19, 21, 0.9831406623643482},
    {59, 0.01, 0, 3, 0.9785446769920286},
    {59, 0.05, 0, 8, 0.9911362570110953},
    {59, 0.1, 2, 12, 0.972110038438189},
    {59, 0.5, 22, 38, 0.9636568200429461},
    {59, 0.9, 48, 58, 0.972110038438189},
    {59, 0.95, 52, 60, 0.9911362570110952},
    {59, 0.99, 57, 60, 0.9785446769920286},
    {100, 0.01, 0, 4, 0.9816259635553504},
    {100, 0.05, 1, 11, 0.9826070607121813},
    {100, 0.1, 5, 17, 0.9556901071912229},
    {100, 0.5, 40, 61, 0.9647997997822952},
    {100, 0.9, 84, 96, 0.955690107191223},
    {100, 0.95, 90, 100, 0.9826070607121812},
    {100, 0.99, 97, 101, 0.9816259635553503},
    {299, 0.01, 0, 8, 0.9887358244713847},
    {299, 0.05, 8, 24, 0.9673049380576966},
    {299, 0.1, 20, 41, 0.9579190213267348},
    {299, 0.5, 133, 167, 0.9509143633462778},
    {299, 0.9, 259, 280, 0.957919021326735},
    {299, 0.95, 276, 292, 0.9673049380576964},
    {299, 0.99, 292, 300, 0.9887358244713847},
    {500, 0.01, 1, 11, 0.9801859498578059},
    {500, 0.05, 16, 36, 0.9604987355159625},
    {500, 0.1, 37, 65, 0.963395297002785},
    {500, 0.5, 228, 273, 0.9559365304210727},
    {500, 0.9, 436, 464, 0.9633952970027854},
    {500, 0.95, 465, 485, 0.9604987355159622},
    {500, 0.99, 490, 500, 0.9801859498578058},
    {1000, 0.01, 4, 18, 0.9760947634979773},
    {1000, 0.05, 37, 65, 0.958095268222655},
    {1000, 0.1, 82, 120, 0.9549071811148258},
    {1000, 0.5, 469, 532, 0.9537088026395018},
    {1000, 0.9, 881, 919, 0.9549071811148261},
    {1000, 0.95, 936, 964, 0.9580952682226543},
    {1000, 0.99, 983, 997, 0.976094763497977},
};

static const struct {
    size_t k, n;
    double low, high;
} proportions[] = {
    {0, 20, 0.0, 0.1684334709830853},
    {1, 20, 0.0012650894979498047, 0.24873276277202777},
    {3, 100, 0.006229971538306397, 0.08517605297428002},
    {0, 300, 0.0, 0.012220974694293552},
    {50, 100, 0.39832112950330106, 0.6016788704966989},
    {5, 1000, 0.0016254195175627604, 0.011629470559812147},
    {200, 200, 0.9817246596448638, 1.0},
};

TEST(intervals)
{
    for (size_t k = 0; k < sizeof ranks / sizeof *ranks; k++) {
        size_t l, u;
        double coverage = ovr_quantile_ranks(ranks[k].n, ranks[k].p, &l, &u);
        assert_int_equal(l, ranks[k].l);
        assert_int_equal(u, ranks[k].u);
        CHECK_CLOSE(coverage, ranks[k].coverage, 1e-9);
    }
    for (size_t k = 0; k < sizeof proportions / sizeof *proportions; k++) {
        ovr_interval i = ovr_proportion(proportions[k].k, proportions[k].n);
        CHECK_NEAR(i.low, proportions[k].low, 1e-9);
        CHECK_NEAR(i.high, proportions[k].high, 1e-9);
    }
    CHECK_CLOSE(ovr_student(8), 2.3646242515927849, 1e-9);
    assert_true(isnan(ovr_student(1)));
}

static int by_size(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

TEST(quantiles)
{
    double sample[] = {3, 1, 4, 1.5, 9, 2.6, 5.3};
    static const double p[] = {0.05, 0.1, 0.5, 0.9},
                        q[] = {1.15, 1.3, 3.0, 6.780000000000001};
    qsort(sample, 7, sizeof *sample, by_size);
    for (int k = 0; k < 4; k++)
        CHECK_CLOSE(ovr_quantile(sample, 7, p[k]), q[k], 1e-12);
}

/* 1000 samples of 256: the interval of the quantile .05 holds the true one as
 * often as the binomial numbers say (.970), within four standard errors. */
TEST(coverage)
{
    enum { N = 256, TIMES = 1000 };
    double x[N];
    size_t l, u, held = 0;
    double nominal = ovr_quantile_ranks(N, 0.05, &l, &u);
    for (uint64_t k = 0; k < TIMES; k++) {
        ovr_interval i;
        for (size_t j = 0; j < N; j++)
            x[j] = ovr_uniform_at(k, 5, j);
        qsort(x, N, sizeof *x, by_size);
        i = ovr_quantile_interval(x, N, 0.05);
        held += i.low <= 0.05 && 0.05 <= i.high;
    }
    assert_true(nominal > 0.95);
    CHECK_NEAR((double)held / TIMES, nominal,
               4 * sqrt(nominal * (1 - nominal) / TIMES));
}

/* --------------------------------------------------- which input matters */

enum { N = 1024, TIMES = 100, INPUTS = 5 };

/* Mean and deviation of the first-order indices of `of` over many samples. */
static void repeat(double (*of)(const double *x), int inputs, double *mean,
                   double *sd)
{
    static double x[INPUTS][N], y[N];
    for (int k = 0; k < inputs; k++)
        mean[k] = sd[k] = 0;
    for (uint64_t t = 0; t < TIMES; t++) {
        for (size_t i = 0; i < N; i++) {
            double at[INPUTS];
            for (int k = 0; k < inputs; k++)
                at[k] = x[k][i] = ovr_uniform_at(t + 1, (uint64_t)k, i);
            y[i] = of(at);
        }
        for (int k = 0; k < inputs; k++) {
            ovr_arena arena = ovr_arena_make(NULL);
            double S = ovr_first_order(x[k], y, N, &arena);
            ovr_arena_release(&arena);
            mean[k] += S / TIMES;
            sd[k] += S * S / TIMES;
        }
    }
    for (int k = 0; k < inputs; k++)
        sd[k] = sqrt(fmax(0, sd[k] - mean[k] * mean[k]));
}

static double g_function(const double *x)
{
    static const double a[] = {0, 1, 4.5, 9, 99};
    double product = 1;
    for (int k = 0; k < 5; k++)
        product *= (fabs(4 * x[k] - 2) + a[k]) / (1 + a[k]);
    return product;
}

static double ishigami(const double *x)
{
    const double pi = acos(-1);
    double a = pi * (2 * x[0] - 1), b = pi * (2 * x[1] - 1);
    double c = pi * (2 * x[2] - 1);
    return sin(a) + 7 * pow(sin(b), 2) + 0.1 * pow(c, 4) * sin(a);
}

/* Spreads of an independent program in Python, 200 repetitions at n = 1024, of
 * which these 100 differ by less than half; its bias was below .003, and what
 * is cut at 0 leans up by .4 of its spread. */
TEST(first_order)
{
    static const double spread[] = {.014, .023, .011, .009, .005};
    double mean[INPUTS], sd[INPUTS];
    static const double g[] = {0.7164177234431923, 0.17910443086079808,
                               0.02368323052704768, 0.007164177234431923,
                               7.164177234431924e-05};
    repeat(g_function, 5, mean, sd);
    for (int k = 0; k < 5; k++) {
        CHECK_NEAR(mean[k], g[k], 0.003 + 0.4 * spread[k]);
        assert_true(sd[k] < 1.5 * spread[k]);
    }
    static const double i[] = {0.31390519114781146, 0.4424111447900409, 0.0};
    repeat(ishigami, 3, mean, sd);
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(mean[k], i[k], 0.003 + 0.4 * 0.023);
        assert_true(sd[k] < 1.5 * 0.03);
    }
}

/* A straight line in noise: rho of normal pairs is 6/pi asin(r/2); its
 * bootstrap interval holds it in 19 of 20 samples, give or take. */
TEST(correlation)
{
    enum { SAMPLES = 200, PAIRS = 100 };
    const ovr_distribution normal = {OVR_NORMAL, 0, 1, 0, -INFINITY, INFINITY};
    double x[PAIRS], y[PAIRS], rho = 6 / acos(-1) * asin(0.6 / 2), mean = 0;
    int held = 0;
    for (uint64_t t = 0; t < SAMPLES; t++) {
        ovr_arena arena = ovr_arena_make(NULL);
        ovr_interval i;
        for (uint64_t k = 0; k < PAIRS; k++) {
            x[k] = ovr_distribution_inverse(&normal, ovr_uniform_at(t, 1, k));
            y[k] = 0.6 * x[k] + 0.8 * ovr_distribution_inverse(
                                          &normal, ovr_uniform_at(t, 2, k));
        }
        mean += ovr_rank_correlation(x, y, PAIRS, &arena) / SAMPLES;
        i = ovr_bootstrap(ovr_rank_correlation, x, y, PAIRS, NULL);
        held += i.low <= rho && rho <= i.high;
        ovr_arena_release(&arena);
    }
    CHECK_NEAR(mean, rho, 0.02);
    assert_in_range(held, 178, 198); /* .95 and four standard errors below */
}

/* y = x + a z of uniform x and z: the share of x is 1/(1 + a^2).  The interval
 * holds it in nine of ten samples of 64 and 256 draws at least; without noise,
 * in all of them. */
TEST(shares_of_lines_held)
{
    enum { MAXIMUM = 256, SAMPLES = 100 };
    static const double noise[] = {0, 0.01, 0.1, 0.5, 1, 3};
    static double x[MAXIMUM], y[MAXIMUM];
    for (size_t draws = 64; draws <= MAXIMUM; draws *= 4)
        for (int a = 0; a < 6; a++) {
            double share = 1 / (1 + noise[a] * noise[a]);
            int held = 0;
            for (uint64_t t = 0; t < SAMPLES; t++) {
                for (size_t i = 0; i < draws; i++) {
                    x[i] = ovr_uniform_at(t + 900, 1, i);
                    y[i] = x[i] + noise[a] * ovr_uniform_at(t + 900, 2, i);
                }
                ovr_interval i = ovr_bootstrap(ovr_first_order, x, y, draws,
                                               NULL);
                held += i.low <= share + 1e-12 && share - 1e-12 <= i.high;
            }
            print_message("%zu draws, noise %g: held %d of %d\n", draws,
                          noise[a], held, SAMPLES);
            assert_true(held >= (noise[a] > 0 ? 88 : SAMPLES));
        }
}

/* Of the g-function's first and third index the interval holds the true one in
 * 9 of 10 samples at least: bins that are cut at 0, and few of them, cost the
 * rest of 95 %. */
TEST(indices_held)
{
    enum { DRAWS = 512, SAMPLES = 100 };
    static const double true_index[] = {0.7164177234431923,
                                        0.02368323052704768};
    static double x[5][DRAWS], y[DRAWS];
    int held[2] = {0};
    for (uint64_t t = 0; t < SAMPLES; t++) {
        for (size_t i = 0; i < DRAWS; i++) {
            double at[5];
            for (int k = 0; k < 5; k++)
                at[k] = x[k][i] = ovr_uniform_at(t + 500, (uint64_t)k, i);
            y[i] = g_function(at);
        }
        for (int k = 0; k < 2; k++) {
            ovr_interval i = ovr_bootstrap(ovr_first_order, x[2 * k], y, DRAWS,
                                           NULL);
            held[k] += i.low <= true_index[k] && true_index[k] <= i.high;
        }
    }
    print_message("held %d and %d of %d\n", held[0], held[1], SAMPLES);
    assert_true(held[0] >= 88 && held[1] >= 88);
}

static double mean_of(const double *x, const double *y, size_t n,
                      ovr_arena *arena)
{
    double sum = 0;
    (void)x;
    (void)arena;
    for (size_t i = 0; i < n; i++)
        sum += y[i] / (double)n;
    return sum;
}

/* The interval of a mean is 1.96 sd/sqrt(n), of small samples and of large
 * ones, for which fewer pairs are drawn.  200 means have an error of 15 %. */
TEST(bootstrap_of_any_size)
{
    enum { LARGEST = 40000 };
    static double x[LARGEST], y[LARGEST];
    for (size_t i = 0; i < LARGEST; i++)
        x[i] = y[i] = ovr_uniform_at(4, 4, i);
    for (size_t n = 400; n <= LARGEST; n *= 10) {
        ovr_interval i = ovr_bootstrap(mean_of, x, y, n, NULL);
        double right = 1.96 * sqrt(1.0 / 12 / (double)n);
        CHECK_CLOSE((i.high - i.low) / 2, right, 0.15);
        assert_true(i.low < mean_of(x, y, n, NULL) &&
                    mean_of(x, y, n, NULL) < i.high);
    }
}
