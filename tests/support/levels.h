/* SPDX-License-Identifier: GPL-3.0-or-later */
/* level = auto for random cases: actual and requested errors. */
#ifndef TESTS_SUPPORT_LEVELS_H
#define TESTS_SUPPORT_LEVELS_H

#include <stdint.h>

/* Random steady contacts, M = 5 to 1000, L = 1 to 15, with a requested error
 * of H_cen or H_min of 1e-2 to 1e-4, compared with two levels more. Fails if
 * an error exceeds the request without a warning of the run, or if more than a
 * tenth of the errors do. */
void test_levels_steady(uint64_t seed, int cases);

/* The same of runs with a dent or a wave that rolls or slides through, H_cen
 * to 3e-3, rms in time. */
void test_levels_in_time(uint64_t seed, int cases);

/* level = usual: films and friction, rms in time, on random runs of five kinds
 * (a dent that slides, under a ramp of load, starved, hot; a ground surface),
 * asked for to 1e-3.  Fails where one is beyond 4e-3, or more than a fifth are
 * beyond 1e-3. */
void test_levels_usual(uint64_t seed, int cases);

/* The same of random steady contacts whose surfaces touch; fails beyond 2e-3.
 */
void test_levels_touching(uint64_t seed, int cases);

#endif
