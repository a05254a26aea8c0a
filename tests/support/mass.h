/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases, each defined by its seed, and their results.
 *
 *   steady     M 2..1000 (log-uniform), L 0..15, level 6..10, domain [-4, 1.5]
 *              or automatic
 *   transient  M 5..200 (log-uniform), L 2..15, u_s/um 0..2, level 7, one to
 *              three features of random shape, up to 1.5 H_cen deep and 0.1..2
 *              b wide; the run ends when the last feature has passed */
#ifndef TESTS_SUPPORT_MASS_H
#define TESTS_SUPPORT_MASS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "overroll/error.h"

typedef struct test_ending {
    char what[200]; /* description of the case */
    ovr_error err;
    double seconds;
    int cycles;
    int retries; /* number of failed strategies (steady) or attempts of steps */
    long steps, marked;
    bool number; /* all defined values and observations are finite */
} test_ending;

test_ending test_steady_case(uint64_t seed);
test_ending test_transient_case(uint64_t seed);

/* Numbers of cases by their result. */
typedef struct test_statistics {
    long cases, converged, retried, gave_up, impossible, unnamed, not_numbers;
    long steps, marked; /* number of steps, and of flagged steps */
    long worst_marked;  /* maximum number of flagged steps of a case */
    long cycles;
    double seconds, slowest;
} test_statistics;

/* Runs the cases of the seeds first..first+count-1; prints failures and sums.
 */
test_statistics test_mass(const char *name, test_ending (*run)(uint64_t seed),
                          uint64_t first, long count);

#endif
