/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random steady starts of hot contacts with high sliding speed. */
#ifndef TESTS_SUPPORT_HOT_STARTS_H
#define TESTS_SUPPORT_HOT_STARTS_H

#include <stdint.h>

/*
 * Solves `runs` contacts from a seed on. Slide-to-roll ratios are 2 to 6 in
 * both directions, and levels 6 to 9. All rheological models of the table of
 * keys occur, also with a limiting shear stress and mass-conserving cavitation.
 * At most 3 in 100 fail. The energy balance error of the others is below 2 %. A
 * failed start costs at most 22 times as much as a mean start on its level.
 * This is the limit of 20 and one iteration.
 */
void test_hot_starts_survey(uint64_t seed, int runs);

#endif
