/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Discretization errors estimated by a run, compared with the true ones. */
#ifndef TESTS_SUPPORT_ERROR_ESTIMATES_H
#define TESTS_SUPPORT_ERROR_ESTIMATES_H

#include <stdint.h>

/* Runs `cases` cases of mixed physics (random_case.h) from a seed on, with
 * --estimate-error, and compares them with level + finer at the same time. At
 * most `maximum` cases may have an estimate of film thickness or pressure below
 * half of the true error. A third of all numbers must have estimates. Prints
 * and returns the number of cases with too small estimates. */
int test_error_estimates_survey(uint64_t seed, int cases, int level, int finer,
                                int maximum);

/* Fails if an estimated error of one case is below half of the true one. */
void test_error_estimates_case(const char *text, int level, int finer);

#endif
