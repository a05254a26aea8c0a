/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady starts of hot contacts that slide fast, drawn at random. */
#ifndef TESTS_SUPPORT_HOT_STARTS_H
#define TESTS_SUPPORT_HOT_STARTS_H

#include <stdint.h>

/*
 * `runs` contacts from a seed on: slide-to-roll ratios of 2 to 6 in both
 * directions, all flow laws of the table of keys, with and without a limiting
 * stress and mass-conserving cavitation, levels 6 to 9.  At most 3 in 100 are
 * not found, energy closes in those found, and a failure takes no more cycles
 * than 20 times the mean of those found.
 */
void test_hot_starts_survey(uint64_t seed, int runs);

#endif
