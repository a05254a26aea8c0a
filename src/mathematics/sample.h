/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Statistics of a sample: functions of n numbers. */
#ifndef OVR_MATHEMATICS_SAMPLE_H
#define OVR_MATHEMATICS_SAMPLE_H

#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* 95 % confidence interval. */
typedef struct ovr_interval {
    double low, high; /* NAN: no limit */
} ovr_interval;

/* Returns the quantile p of sorted numbers by linear interpolation (type 7 of
 * Hyndman & Fan 1996). */
double ovr_quantile(const double *sorted, size_t n, double p);

/* Returns the confidence interval of a quantile from order statistics, for any
 * distribution. l and u are the ranks (from 1; 0 and n + 1: none) between which
 * the quantile lies with the returned probability. l is the largest with P(X <=
 * l - 1) <= 2.5 %, u the smallest with P(X >= u) <= 2.5 %, X binomial (n,
 * p). */
double ovr_quantile_ranks(size_t n, double p, size_t *l, size_t *u);
ovr_interval ovr_quantile_interval(const double *sorted, size_t n, double p);

/* Returns the confidence interval of a probability observed k times in n
 * (Clopper & Pearson 1934). */
ovr_interval ovr_proportion(size_t k, size_t n);

/* Returns Student's factor: the half-width of a 95 % interval divided by the
 * standard error of n values. */
double ovr_student(size_t n);

/* Returns the first-order sensitivity index 1 - E(var(y | x)) / var(y), at
 * least 0: the fraction of the variance of y caused by x alone. var(y | x) is
 * the residual variance of lines fitted in round(sqrt n)/2 bins of equal counts
 * in x. Bins with constants would count the slope within a bin as noise. */
double ovr_first_order(const double *x, const double *y, size_t n,
                       ovr_arena *arena);

/* Returns the means of y in the lowest and the highest bin of x. */
ovr_interval ovr_bin_ends(const double *x, const double *y, size_t n,
                          ovr_arena *arena);

/* Returns Spearman's rank correlation. */
double ovr_rank_correlation(const double *x, const double *y, size_t n,
                            ovr_arena *arena);

/* 95 % bootstrap confidence interval of `of` by percentiles of 200 resamples
 * (Efron 1979), reproducible. The interval is shifted so that the median of
 * the resamples equals the value of the sample, which removes the bias of
 * repeated pairs. At most m = 4000 pairs are drawn; deviations are
 * scaled by sqrt(m/n). */
typedef double ovr_of_pairs(const double *x, const double *y, size_t n,
                            ovr_arena *arena);
ovr_interval ovr_bootstrap(ovr_of_pairs *of, const double *x, const double *y,
                           size_t n, const ovr_allocator *allocator);

#endif
