/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A sample is summed up by pure functions of n numbers.
 */
#ifndef OVR_MATHEMATICS_SAMPLE_H
#define OVR_MATHEMATICS_SAMPLE_H

#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* 95 % between two ends. */
typedef struct ovr_interval {
    double low, high; /* NAN: no end there */
} ovr_interval;

/* The quantile p of sorted numbers, by linear interpolation (type 7 of Hyndman
 * & Fan 1996). */
double ovr_quantile(const double *sorted, size_t n, double p);

/* Its interval by order statistics, whatever the distribution: the ranks l and
 * u (from 1; 0 and n + 1: none) between which the quantile lies with the
 * probability returned, l the largest with P(X <= l - 1) <= 2.5 %, u the
 * smallest with P(X >= u) <= 2.5 %, X binomial (n, p). */
double ovr_quantile_ranks(size_t n, double p, size_t *l, size_t *u);
ovr_interval ovr_quantile_interval(const double *sorted, size_t n, double p);

/* A probability of which k of n were seen (Clopper & Pearson 1934). */
ovr_interval ovr_proportion(size_t k, size_t n);

/* The factor of a standard error from n values that makes it an interval of
 * 95 % (Student). */
double ovr_student(size_t n);

/* The share of the variance of y that the input x makes by itself,
 * 1 - E(var(y | x)) / var(y), cut at 0.  var(y | x) is what a line leaves that
 * is fitted in each of round(sqrt n)/2 bins of equal counts in x, over its
 * degrees of freedom: bins of constants count the slope within a bin as noise,
 * and have no sample of y = x whose interval holds 1. */
double ovr_first_order(const double *x, const double *y, size_t n,
                       ovr_arena *arena);

/* The bins' means in the lowest and the highest. */
ovr_interval ovr_bin_ends(const double *x, const double *y, size_t n,
                          ovr_arena *arena);

/* Spearman's rank correlation. */
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
