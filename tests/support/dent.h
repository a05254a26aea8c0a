/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An artificial run: a dent moves through prescribed pressure and film
 * thickness, which are formulas of position and time. The contents of a file
 * can therefore be checked to the bit without a solution. */
#ifndef TESTS_SUPPORT_DENT_H
#define TESTS_SUPPORT_DENT_H

#include <stddef.h>

#include "overroll/results.h"
#include "results/results.h"

typedef struct test_dent {
    size_t n;
    double D, dT;
    double *X, *P, *H, *S, *rho, *eta, *flow;
    ovr_state state;
    ovr_observation seen;
    ovr_frame frame;
} test_dent;

/* Initializes nodes X_i = -4 + 5.5 i/(n - 1) and step 0. */
void test_dent_init(test_dent *dent, size_t n, double dT);
void test_dent_free(test_dent *dent);

/* Sets the fields of a step, which depend only on its number. */
void test_dent_move(test_dent *dent, long step);

/* Contact of a steel roller with mineral oil, M = 20, L = 10, with all scales;
 * and the same contact without scales. */
ovr_contact test_contact_physical(void);
ovr_contact test_contact_bare(void);

#endif
