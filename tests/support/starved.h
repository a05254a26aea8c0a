/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random starved contacts with mass-conserving cavitation. */
#ifndef TESTS_SUPPORT_STARVED_H
#define TESTS_SUPPORT_STARVED_H

#include <stdint.h>

#include "overroll/simulation.h"

/* Central film thickness and flow rate of the flooded steady contact, and the
 * work to solve it. */
typedef struct test_flooded {
    double film, flow;
} test_flooded;
test_flooded test_flood(double M, double L, int level);

/* A steady contact of this share of the flooded flow: its status, and how many
 * of the ways of solving it took. */
ovr_status test_starve(double M, double L, int level, double share, int *ways,
                       ovr_error *err);

/* A run of 4 b/um whose contact, supply, histories and features follow from the
 * seed; how often a step was tried again, or halved; marked steps. */
typedef struct test_starved_run {
    ovr_status status;
    ovr_error err;
    double M, L, cycles; /* a step */
    long retries, substeps, marked;
} test_starved_run;
test_starved_run test_starved(uint64_t seed, int level, ovr_scheme scheme,
                              int order);

#endif
