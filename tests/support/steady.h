/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady contacts of given M and L, one call each. */
#ifndef TESTS_SUPPORT_STEADY_H
#define TESTS_SUPPORT_STEADY_H

#include "overroll/simulation.h"

typedef struct test_solution {
    ovr_status status;
    ovr_observation o;
    ovr_options options;   /* as resolved */
    ovr_refinement finest; /* the last level's record */
    double seconds;        /* of the solve */
    char message[OVR_MESSAGE_SIZE];
} test_solution;

/* The contact of support/contact.h, solved. */
test_solution test_steady(double M, double L, const ovr_options *options);

/* Returns the finest level of a table: low in `make check`; `make paper` sets
 * the environment variable OVERROLL_LEVELS. */
int test_levels(int unless_told);

#endif
