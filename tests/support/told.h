/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Discretization errors estimated by a run, compared with the true ones. */
#ifndef TESTS_SUPPORT_TOLD_H
#define TESTS_SUPPORT_TOLD_H

#include <stdint.h>

/* `cases` of mixed physics (random_case.h) from a seed on, at a level, with
 * --estimate-error. The true error is from `finer` levels more, at the same
 * time. At most `maximum` cases may have an estimate of film or pressure below
 * half of the true error, and a third of all cases must have estimates. Prints
 * them. Returns the number of too small estimates. */
int test_told_survey(uint64_t seed, int cases, int level, int finer,
                     int maximum);

/* Fails if an estimated error of one case is below half of the true one. */
void test_told_case(const char *text, int level, int finer);

#endif
