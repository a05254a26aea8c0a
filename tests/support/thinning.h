/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with shear-thinning films. */
#ifndef TESTS_SUPPORT_THINNING_H
#define TESTS_SUPPORT_THINNING_H

#include <stdint.h>

/* A run of 4 b/um.  From the seed: M 5 to 200 (logarithmic), L 2.5 to 14, SRR
 * -2 to 2; Eyring, Carreau-Yasuda in both forms or a table of points, 2 to 15
 * MPa; a dent, bump or ridge and roughness on each surface, each or not; load,
 * speed and sliding constant or along histories.  A failure is a failed test
 * that shows the case. */
typedef struct test_thinned {
    long steps, cycles, retries, substeps, marked;
} test_thinned;
test_thinned test_thinning(uint64_t seed, int level);

/* `runs` of them from a seed on, on a level and the next in turns, none of
 * which fails, 2 % at most marked; printed. */
void test_thinning_survey(uint64_t seed, int runs, int level);

#endif
