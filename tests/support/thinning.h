/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with shear-thinning films. */
#ifndef TESTS_SUPPORT_THINNING_H
#define TESTS_SUPPORT_THINNING_H

#include <stdint.h>

/*
 * Runs a random case of 4 b/um; fails the test and prints the case if the run
 * fails.
 *
 *   contact    M 5 to 200 (logarithmic), L 2.5 to 14, SRR -2 to 2
 *   lubricant  Eyring, Carreau-Yasuda in both forms or a table of points, 2 to
 *              15 MPa
 *   features   on each surface none, a dent, bump or ridge, and roughness
 *   histories  load, speed and sliding constant or varying
 */
typedef struct test_thinned {
    long steps, cycles, retries, substeps, marked;
} test_thinned;
test_thinned test_thinning(uint64_t seed, int level);

/* Runs and prints `runs` cases, on a level and the next in turn. None may fail,
 * and at most 2 % may have flagged steps. */
void test_thinning_survey(uint64_t seed, int runs, int level);

#endif
