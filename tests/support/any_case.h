/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases drawn from the table of keys. */
#ifndef TESTS_SUPPORT_ANY_CASE_H
#define TESTS_SUPPORT_ANY_CASE_H

#include <stdint.h>

/*
 * Runs cases of consecutive seeds. Each has a contact of plausible or extreme
 * numbers and up to twelve keys of any section. The value of a key is one of
 * its words, a usual number, a number anywhere in its range, a file or a list.
 * Numbers with a dimension are in SI units. The survey sets levels, end times
 * and names of result files. Rejected keys are omitted. Runs are steady or 0.5
 * b/um long, on level 5, with at most 40 steps.
 *
 * A case is solved or fails with a message. All fields of solved cases are
 * finite, and so are the numbers in summary and messages. Errors of converged
 * films are below 1e-4 (load) and 1e-2 (mass conservation). A step is accepted
 * with R = 1e-3 on any grid, and rounding errors of extreme contacts are
 * several times larger. Steady cases are solved again on levels 7 and 8. At
 * most 3 of 100 with an error estimate may differ by more than the estimate.
 */
void test_any_case_survey(uint64_t seed, int runs);

/*
 * Runs cases with wider ranges. Half of them are strips on levels 4 to 6.
 * Bodies are of rubber to ceramics, and slide-to-roll ratios are up to 30 in
 * both directions. Features are 0.01 to 10 times as high as the smooth film
 * thickness. Up to six keys of any section are added. Each case is solved or
 * fails with a message. In a survey of 200 cases or more, at most one in twenty
 * of the timed cases takes ten times the CPU time that `check` predicts. If
 * OVERROLL_CASES names a folder, the cases are written there to files SEED.ini
 * and not solved (verify/wide_files.sh).
 */
void test_wide_case_survey(uint64_t seed, int runs);

#endif
