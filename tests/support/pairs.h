/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each pair of model features (overroll/conflicts.h) in a small case: rejected
 * as listed in the table, or effective. */
#ifndef TESTS_SUPPORT_PAIRS_H
#define TESTS_SUPPORT_PAIRS_H

/* Resolves and prints all pairs. Every `every`-th pair that is not rejected is
 * run: load and mass are conserved, and a run that is killed and resumed gives
 * the same bits. Files are written to `folder`. */
void test_walk_pairs(const char *folder, int every);

/* Runs each feature in combination with a gear, a cam and a roller bearing. */
void test_walk_elements(const char *folder, int every);

#endif
