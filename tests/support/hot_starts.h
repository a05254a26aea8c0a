/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random steady starts of hot contacts with high sliding speed. */
#ifndef TESTS_SUPPORT_HOT_STARTS_H
#define TESTS_SUPPORT_HOT_STARTS_H

#include <stdint.h>

/*
 * Solves `runs` contacts from a seed on.  Slide-to-roll ratios are 2 to 6 in
 * both directions, levels 6 to 9.  All flow laws of the table of keys occur,
 * and a limiting stress and mass-conserving cavitation.  At most 3
 * in 100 fail.  Energy closes in the others.  A failure costs less than 20
 * times a mean start of its level, and a last iteration.
 */
void test_hot_starts_survey(uint64_t seed, int runs);

#endif
