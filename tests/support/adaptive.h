/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive time steps for random dents compared with steps of D/8 and D. */
#ifndef TESTS_SUPPORT_ADAPTIVE_H
#define TESTS_SUPPORT_ADAPTIVE_H

#include <stdint.h>

typedef struct test_adaptive {
    double worst; /* maximum rms error of H_cen relative to time.error */
    double cycles, cycles_of_mesh; /* cycles of adaptive steps at the error of
                                      steps of D, and of steps of D */
    int compared; /* number of cases in which the error of steps of D is between
                     errors of adaptive steps */
} test_adaptive;

/* Runs `cases` random cases: M = 10 to 100, L = 4 to 12, rolling and sliding
 * dents that are at least 12 nodes wide. */
test_adaptive test_adaptive_cases(uint64_t seed, int cases, int level,
                                  const char *scheme);

#endif
