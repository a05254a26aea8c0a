/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs with an entrainment speed that passes through zero. */
#ifndef TESTS_SUPPORT_REVERSAL_H
#define TESTS_SUPPORT_REVERSAL_H

#include <stdint.h>

#include "contact.h"

/* Cu = mean + swing cos(2 pi T/period + phase) on [-4, 4]; a feature at start +
 * u int Cu dT, none where its kind is 0. */
typedef struct test_reversal {
    double M, L, mean, swing, period, phase, end;
    int level;
    double steps_of_mesh; /* 0: one mesh */
    ovr_scheme scheme;
    int order;            /* 0: second */
    double tolerance;     /* 0: automatic */
    double eyring, slide; /* Sigma0, 0: Newtonian; V, 0: none */
    test_feature feature;
} test_reversal;

/* Largest differences over a run; how often the speed changed its sign. */
typedef struct test_apart {
    double P, H; /* of P at any node; of H_cen, relative */
    int turns;
} test_apart;

/* Against the dense Newton solution, step by step with a past of its own. */
test_apart test_reversal_against_dense(const test_reversal *r);

/* Against the run of the other sign with the feature at -start. */
test_apart test_reversal_against_mirror(const test_reversal *r);

/* H_min at the end. */
double test_reversal_film(const test_reversal *r);

typedef struct test_reversals {
    long runs, steps, cycles, retries, marked, failed, turns;
    double load; /* largest error of it */
} test_reversals;

/*
 * So many runs of 1.25 periods of Cu = m + sin, |m| < 0.6, period 2 to
 * `longest`, any phase; M = 5 to 200 logarithmic, L = 2.5 to 14, level 8, 9
 * above M = 100, steps of a mesh, a third each by upstream1, upstream2 and the
 * characteristic; half of them with one to three dents (to 1.5 H_c) or bumps
 * (to 0.4 H_c) at surfaces of slide-to-roll -1 to 1.
 */
test_reversals test_reversals_run(uint64_t seed, long runs, double longest);

#endif
