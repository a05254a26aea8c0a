/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random strips, and numbers of steps and cycles of their solution. */
#ifndef TESTS_SUPPORT_STRIP_CASES_H
#define TESTS_SUPPORT_STRIP_CASES_H

#include "strip.h"
#include "strip/march.h"

/* Begins a march from the present film, with a tolerance of R. */
void test_strip_march(test_strip *s, ovr_strip_march *march, double tolerance);

typedef struct strip_survey {
    int cases, unsolved_steady;
    long steps, cycles, retries, flagged, failed;
} strip_survey;

/* Solves the case of a seed on n nodes and prints a line about it. */
void strip_survey_add(strip_survey *found, unsigned seed, size_t n);

/* Checks that all steady films are solved, no run fails, and at most one step
 * in 100 is repeated and one in 1000 flagged. */
void strip_survey_check(const strip_survey *found);

#endif
