/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each pair of model features (overroll/conflicts.h) in a small case: rejected
 * as listed in the table, or effective. */
#ifndef TESTS_SUPPORT_PAIRS_H
#define TESTS_SUPPORT_PAIRS_H

/* Resolves all pairs; those of which nothing is refused march, every
 * `every`-th, are killed on the way, resumed to the same bits, and keep mass
 * and load.  Prints what was walked; files go to `folder`. */
void test_walk_pairs(const char *folder, int every);

/* The same of each part with a gear, a cam and a bearing. */
void test_walk_elements(const char *folder, int every);

#endif
