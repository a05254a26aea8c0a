/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs with an entrainment speed that passes through zero. */
#ifndef TESTS_SUPPORT_REVERSAL_H
#define TESTS_SUPPORT_REVERSAL_H

#include <stdint.h>

#include "contact.h"

/* A run with Cu = mean + swing cos(2 pi T/period + phase) on [-4, 4] and a
 * feature at start + u int Cu dT (feature.kind = 0: none). */
typedef struct test_reversal {
    double M, L, mean, swing, period, phase, end;
    int level;
    double steps_of_mesh; /* step in units of D; 0: 1 */
    ovr_scheme scheme;
    int order;        /* 0: 2 */
    double tolerance; /* 0: automatic */
    double eyring;    /* Sigma0; 0: Newtonian */
    double slide;     /* sliding speed V; 0: none */
    test_feature feature;
} test_reversal;

/* Maximum differences of two runs. */
typedef struct test_apart {
    double P, H; /* P at any node; H_cen, relative */
    int reversals;
} test_apart;

/* Compares a run with a dense Newton solution that has its own past. */
test_apart test_reversal_against_dense(const test_reversal *r);

/* Compares a run with the mirror image: opposite speeds, feature at -start. */
test_apart test_reversal_against_mirror(const test_reversal *r);

/* Returns H_min at the end of a run. */
double test_reversal_film(const test_reversal *r);

typedef struct test_reversals {
    long runs, steps, cycles, retries, marked, failed, reversals;
    double load; /* maximum load error */
} test_reversals;

/*
 * Runs `runs` random cases of 1.25 periods.
 *
 *   speed     Cu = m + sin, |m| < 0.6, period 2 to `longest`, any phase
 *   contact   M = 5 to 200 (logarithmic), L = 2.5 to 14
 *   grid      level 8, or 9 above M = 100; steps of D by upstream1, upstream2
 *             and characteristic, a third each
 *   features  half of the runs: one to three dents (up to 1.5 H_c) or bumps (up
 *             to 0.4 H_c) with slide-to-roll ratios of -1 to 1
 */
test_reversals test_reversals_run(uint64_t seed, long runs, double longest);

#endif
