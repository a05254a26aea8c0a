/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Solves the steady contact of given M and L. */
#ifndef TESTS_SUPPORT_STEADY_H
#define TESTS_SUPPORT_STEADY_H

#include "overroll/simulation.h"

typedef struct test_solution {
    ovr_status status;
    ovr_observation o;
    ovr_options options;   /* resolved options */
    ovr_refinement finest; /* record of the finest level */
    double seconds;        /* wall-clock time of the solution */
    char message[OVR_MESSAGE_SIZE];
} test_solution;

/* Solves the contact of support/contact.h. */
test_solution test_steady(double M, double L, const ovr_options *options);

/* Returns the finest level of a table: low in `make check`; `make paper` sets
 * the environment variable OVERROLL_LEVELS. */
int test_levels(int default_level);

#endif
