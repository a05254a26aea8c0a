/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adaptive steps for random dents compared with dT = D/8 and dT = D. */
#ifndef TESTS_SUPPORT_ADAPTIVE_H
#define TESTS_SUPPORT_ADAPTIVE_H

#include <stdint.h>

typedef struct test_adaptive {
    double worst; /* error of H_cen, rms in time, over the asked for one */
    double cycles, cycles_of_mesh; /* of runs at the error of those of dT = D,
                                      and of these */
    int compared;                  /* where that lies between errors found */
} test_adaptive;

/* So many cases: M = 10 to 100, L = 4 to 12, 12 nodes a width or more, rolling
 * and sliding. */
test_adaptive test_adaptive_cases(uint64_t seed, int cases, int level,
                                  const char *scheme);

#endif
