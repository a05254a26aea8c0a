/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Errors of random cases on the levels chosen by level = auto and usual. */
#ifndef TESTS_SUPPORT_LEVELS_H
#define TESTS_SUPPORT_LEVELS_H

#include <stdint.h>

/* Solves random steady contacts, M = 5 to 1000, L = 1 to 15, with a requested
 * error of H_cen of 1e-2 to 1e-4 (H_min: 5 times that), and compares them with
 * two finer levels. Fails the test if an error exceeds the request without a
 * warning, or if more than a tenth of the errors exceed it. */
void test_levels_steady(uint64_t seed, int cases);

/* Checks the same for runs with a dent or a wave that passes the contact, with
 * a requested rms error of H_cen of 3e-3. */
void test_levels_in_time(uint64_t seed, int cases);

/* Runs random cases of five kinds with level = usual: a sliding dent, also with
 * a load ramp, starved or with heat, and a ground surface. Fails the test if an
 * rms error of film thicknesses or friction exceeds 4e-3, or if more than a
 * fifth exceed 1e-3. */
void test_levels_usual(uint64_t seed, int cases);

/* Checks the same for random steady contacts with asperity contact. No error
 * may exceed 2e-3. */
void test_levels_touching(uint64_t seed, int cases);

#endif
