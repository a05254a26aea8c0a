/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases drawn from the table of keys itself. */
#ifndef TESTS_SUPPORT_ANY_CASE_H
#define TESTS_SUPPORT_ANY_CASE_H

#include <stdint.h>

/*
 * `runs` cases from a seed on: a contact of plausible numbers or of extreme
 * ones, and up to twelve keys of any section, set to any of their words, to a
 * usual number, or to one anywhere in their range; what is refused is left out.
 * Steady or 0.5 b/um long, on level 5, of 40 steps at most.  Each is solved or
 * fails in a sentence; the fields of what was solved are finite, its summary
 * holds no infinite number and its messages no word for one; and what is called
 * converged carries its load to 1e-4, and keeps its oil to 5e-4, the tolerance
 * of a step on that level.
 */
void test_any_case_survey(uint64_t seed, int runs);

#endif
