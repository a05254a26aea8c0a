/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mathematics/sample.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>

#include "mathematics/draws.h"

enum { AGAIN = 200 };
static const double TAIL = 0.025;

/* --------------------------------------------------------------- quantiles */

double ovr_quantile(const double *sorted, size_t n, double p)
{
    return n ? gsl_stats_quantile_from_sorted_data(sorted, 1, n, p) : NAN;
}

double ovr_quantile_ranks(size_t n, double p, size_t *l, size_t *u)
{
    unsigned maximum = (unsigned)n;
    double below, above;
    *l = 0;
    *u = n + 1;
    while (*l < n && gsl_cdf_binomial_P((unsigned)*l, p, maximum) <= TAIL)
        ++*l;
    while (*u > 1 && gsl_cdf_binomial_Q((unsigned)*u - 2, p, maximum) <= TAIL)
        --*u;
    below = *l ? gsl_cdf_binomial_P((unsigned)*l - 1, p, maximum) : 0;
    above = *u <= n ? gsl_cdf_binomial_Q((unsigned)*u - 1, p, maximum) : 0;
    return 1 - below - above;
}

ovr_interval ovr_quantile_interval(const double *sorted, size_t n, double p)
{
    size_t l, u;
    ovr_quantile_ranks(n, p, &l, &u);
    return (ovr_interval){l ? sorted[l - 1] : NAN,
                          u <= n ? sorted[u - 1] : NAN};
}

/* Inverts a cumulative distribution by bisection. GSL's inverses abort the
 * program if they do not converge. */
static double inverse(double (*rising)(double x, double a, double b), double a,
                      double b, double from, double to, double value)
{
    for (double x; x = 0.5 * (from + to), x > from && x < to;)
        if (rising(x, a, b) < value)
            from = x;
        else
            to = x;
    return to;
}

ovr_interval ovr_proportion(size_t k, size_t n)
{
    double a = (double)k, b = (double)(n - k);
    return (ovr_interval){
        k ? inverse(gsl_cdf_beta_P, a, b + 1, 0, 1, TAIL) : 0,
        k < n ? inverse(gsl_cdf_beta_P, a + 1, b, 0, 1, 1 - TAIL) : 1};
}

static double student(double x, double degrees, double unused)
{
    (void)unused;
    return gsl_cdf_tdist_P(x, degrees);
}

double ovr_student(size_t n)
{
    return n > 1 ? inverse(student, (double)n - 1, 0, 0, 100, 1 - TAIL) : NAN;
}

/* ------------------------------------------------------------------- bins */

typedef struct pair {
    double x, y;
} pair;

static int by_x(const void *a, const void *b)
{
    const pair *p = a, *q = b;
    return (p->x > q->x) - (p->x < q->x);
}

static pair *sorted_pairs(const double *x, const double *y, size_t n,
                          ovr_arena *arena)
{
    pair *p = ovr_arena_take(arena, n, sizeof *p, NULL);
    for (size_t i = 0; p && i < n; i++)
        p[i] = (pair){x[i], y[i]};
    if (p)
        qsort(p, n, sizeof *p, by_x);
    return p;
}

static size_t bins_of(size_t n)
{
    return (size_t)lround(sqrt((double)n));
}

/* Computes mean and variance (ddof 1) of the y in a bin of sorted pairs;
 * returns their number. */
static size_t bin_moments(const pair *p, size_t n, size_t bin, double *mean,
                          double *variance)
{
    size_t bins = bins_of(n), from = bin * n / bins, to = (bin + 1) * n / bins;
    size_t count = to - from;
    double sum = 0, squares = 0;
    for (size_t i = from; i < to; i++)
        sum += p[i].y;
    *mean = sum / (double)count;
    for (size_t i = from; i < to; i++)
        squares += pow(p[i].y - *mean, 2);
    *variance = count > 1 ? squares / (double)(count - 1) : 0;
    return count;
}

/* Returns the sum of squared residuals of a line fitted to the y of sorted
 * pairs, and its degrees of freedom. If all x are equal, a constant is
 * fitted. */
static double residual_of_line(const pair *p, size_t count, double *freedom)
{
    double x = 0, y = 0, xx = 0, xy = 0, squares = 0, n = (double)count;
    for (size_t i = 0; i < count; i++) {
        x += p[i].x / n;
        y += p[i].y / n;
    }
    for (size_t i = 0; i < count; i++) {
        xx += (p[i].x - x) * (p[i].x - x);
        xy += (p[i].x - x) * (p[i].y - y);
    }
    double slope = xx > 0 ? xy / xx : 0;
    for (size_t i = 0; i < count; i++) {
        double left = p[i].y - y - slope * (p[i].x - x);
        squares += left * left;
    }
    *freedom += xx > 0 ? n - 2 : n - 1;
    return squares;
}

double ovr_first_order(const double *x, const double *y, size_t n,
                       ovr_arena *arena)
{
    const pair *p = n > 3 ? sorted_pairs(x, y, n, arena) : NULL;
    size_t bins = (bins_of(n) + 1) / 2;
    double variance, left = 0, freedom = 0;
    if (!p)
        return NAN;
    variance = gsl_stats_variance(y, 1, n);
    for (size_t k = 0; k < bins; k++) {
        size_t from = k * n / bins, to = (k + 1) * n / bins;
        left += residual_of_line(p + from, to - from, &freedom);
    }
    if (!(variance > 0))
        return 0;
    return fmax(0, 1 - left / freedom / variance);
}

ovr_interval ovr_bin_ends(const double *x, const double *y, size_t n,
                          ovr_arena *arena)
{
    const pair *p = n > 3 ? sorted_pairs(x, y, n, arena) : NULL;
    ovr_interval ends = {NAN, NAN};
    double variance;
    if (p) {
        bin_moments(p, n, 0, &ends.low, &variance);
        bin_moments(p, n, bins_of(n) - 1, &ends.high, &variance);
    }
    return ends;
}

double ovr_rank_correlation(const double *x, const double *y, size_t n,
                            ovr_arena *arena)
{
    double *work = n > 2 ? ovr_arena_take(arena, 2 * n, sizeof *work, NULL)
                         : NULL;
    return work ? gsl_stats_spearman(x, 1, y, 1, n, work) : NAN;
}

/* --------------------------------------------------------------- bootstrap */

ovr_interval ovr_bootstrap(ovr_of_pairs *of, const double *x, const double *y,
                           size_t n, const ovr_allocator *allocator)
{
    enum { LARGEST = 4000 };
    const ovr_interval none = {NAN, NAN};
    const size_t m = n < LARGEST ? n : LARGEST;
    ovr_arena arena = ovr_arena_make(allocator);
    double *drawn = n ? ovr_arena_take(&arena, 2 * m, sizeof *drawn, NULL)
                      : NULL;
    double found[AGAIN], middle, whole, scale;
    for (uint64_t k = 0; drawn && k < AGAIN; k++) {
        ovr_arena own = ovr_arena_make(allocator);
        for (size_t i = 0; i < m; i++) {
            size_t j = (size_t)(ovr_uniform_at(1, k, i) * (double)n);
            drawn[i] = x[j];
            drawn[m + i] = y[j];
        }
        found[k] = of(drawn, drawn + m, m, &own);
        ovr_arena_release(&own);
    }
    if (!drawn)
        return none;
    gsl_sort(found, 1, AGAIN);
    middle = ovr_quantile(found, AGAIN, 0.5);
    whole = of(x, y, n, &arena);
    scale = sqrt((double)m / (double)n);
    ovr_arena_release(&arena);
    return (ovr_interval){
        whole + scale * (ovr_quantile(found, AGAIN, TAIL) - middle),
        whole + scale * (ovr_quantile(found, AGAIN, 1 - TAIL) - middle)};
}
