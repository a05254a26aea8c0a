/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases drawn from the table of keys itself. */
#ifndef TESTS_SUPPORT_ANY_CASE_H
#define TESTS_SUPPORT_ANY_CASE_H

#include <stdint.h>

/*
 * `runs` cases from a seed on: a contact of plausible numbers or of extreme
 * ones, and up to twelve keys of any section, set to any of their words, to a
 * usual number, or to one anywhere in their range; what is refused is left out;
 * in SI units where it has one, to files and lists (only levels, ends and the
 * names of results are the survey's own).  Steady or 0.5 b/um long, on level 5,
 * of 40 steps at most.  Each is solved or fails in a sentence; the fields of
 * what was solved are finite, its summary holds no infinite number and its
 * messages no word for one; and what is called converged carries its load to
 * 1e-4, and keeps its oil to 1e-2: a step may leave R = 1e-3 on any mesh, and
 * rounding of extreme contacts some times that.
 * Steady ones are solved again on levels 7 and 8: of those that tell an error
 * not more than 3 in 100 differ by more than that.
 */
void test_any_case_survey(uint64_t seed, int runs);

/*
 * Wider cases, half of them strips on levels 4 to 6.  Contacts of rubber to
 * ceramics have slide-to-roll ratios to 30 either way.  Features are 0.01 to 10
 * times as high as the smooth film.  Up to six keys of any section are drawn
 * too.  Each case is solved or fails in a sentence.  In a survey of 200 or more
 * at most one in twenty of those that take time takes ten times as long as
 * `check` says.  With OVERROLL_CASES the cases are written to files SEED.ini in
 * this folder, and not solved (verify/wide_files.sh).
 */
void test_wide_case_survey(uint64_t seed, int runs);

#endif
