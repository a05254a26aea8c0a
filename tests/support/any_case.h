/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases drawn from the table of keys itself. */
#ifndef TESTS_SUPPORT_ANY_CASE_H
#define TESTS_SUPPORT_ANY_CASE_H

#include <stdint.h>

/*
 * Runs cases of consecutive seeds. Each has a contact of plausible or extreme
 * numbers and up to twelve keys of any section.  A key is one of its words, a
 * usual number or a number anywhere in its range, in SI units if it has any, or
 * a file or list.  Levels, end times and names of results are set by the
 * survey.  Refused cases are left out.  Runs are steady or 0.5 b/um long, on
 * level 5, of at most 40 steps.
 *
 * A case is solved or fails with a message.  Fields of solved cases are finite,
 * and neither summary nor messages have numbers that are not.  Converged films
 * carry their load to 1e-4 and conserve lubricant to 1e-2: a step may leave R =
 * 1e-3 on any mesh, and rounding of extreme contacts several times that.
 * Steady cases are solved again on levels 7 and 8. Of those with an expected
 * error at most 3 in 100 may differ by more than it.
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
