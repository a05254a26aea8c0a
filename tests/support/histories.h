/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with jumps, oscillations and ramps of load and speed. */
#ifndef TESTS_SUPPORT_HISTORIES_H
#define TESTS_SUPPORT_HISTORIES_H

#include <stdbool.h>
#include <stdint.h>

typedef struct test_histories {
    long runs, steps, cycles, retries, substeps, marked;
    long maximum;  /* maximum number of cycles of a step */
    long refused;  /* number of runs with a failed or flagged step */
    long touching; /* of these, runs in which surfaces touch */
    long missed;   /* of these, runs in which the dense Newton method converges
                    */
} test_histories;

/*
 * Runs `runs` random cases of 1.2 b/um with upstream2.
 *
 *   contact       M = 5 to 1000 (logarithmic), L = 2 to 14; drawn again if the
 *                 steady film is too thin for the grid
 *   domain, step  outlet at 1.5 to 3, level 7 or 8; D/2 to 4 D (logarithmic)
 *   load, speed   each constant, or with a jump, a sine (period 1 to 3 b/um) or
 *                 a ramp (0.05 to 0.5 b/um), changing by up to 50 %
 *   feature       a third of the runs: a dent that passes the contact
 *
 * With `check`, a failed step is repeated by the dense Newton method.
 */
test_histories test_histories_run(uint64_t seed, long runs, bool check);

#endif
