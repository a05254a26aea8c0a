/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases, each defined by its seed, and how they end.
 *
 *   steady     M 2..1000 (log-uniform), L 0..15, level 6..10, the default
 *              domain or an automatic one
 *   transient  M 5..200 (log-uniform), L 2..15, u_s/um 0..2, one to three
 *              features of random shape, up to 1.5 H_cen deep and 0.1..2 b
 *              wide; level 7, until the last feature has left */
#ifndef TESTS_SUPPORT_MASS_H
#define TESTS_SUPPORT_MASS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "overroll/error.h"

typedef struct test_ending {
    char what[200]; /* the case in a line */
    ovr_error err;
    double seconds;
    int cycles,
        retries; /* steady: strategies tried before; transient: attempts */
    long steps, marked;
    bool number; /* every value and observation is a number where it should */
} test_ending;

test_ending test_steady_case(uint64_t seed);
test_ending test_transient_case(uint64_t seed);

/* How many of `count` cases ended in which way. */
typedef struct test_statistics {
    long cases, converged, retried, gave_up, impossible, unnamed, not_numbers;
    long steps, marked, worst_marked; /* marked in all; most in one case */
    long cycles;
    double seconds, slowest;
} test_statistics;

/* Runs cases first..first+count-1, prints failures, and a line of sums. */
test_statistics test_mass(const char *name, test_ending (*run)(uint64_t seed),
                          uint64_t first, long count);

#endif
