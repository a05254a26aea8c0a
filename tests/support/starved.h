/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random starved contacts with mass-conserving cavitation. */
#ifndef TESTS_SUPPORT_STARVED_H
#define TESTS_SUPPORT_STARVED_H

#include <stdint.h>

#include "overroll/simulation.h"

/* Central film thickness and flow rate of the flooded steady contact. */
typedef struct test_flooded {
    double film, flow;
} test_flooded;
test_flooded test_flood(double M, double L, int level);

/* Solves a steady contact supplied with a share of the flooded flow rate.
 * *strategies is the number of strategies that were tried. */
ovr_status test_starve(double M, double L, int level, double share,
                       int *strategies, ovr_error *err);

/* Runs a random case of 4 b/um and counts retries, halved and flagged steps. */
typedef struct test_starved_run {
    ovr_status status;
    ovr_error err;
    double M, L, cycles; /* cycles per step */
    long retries, substeps, marked;
} test_starved_run;
test_starved_run test_starved(uint64_t seed, int level, ovr_scheme scheme,
                              int order);

#endif
