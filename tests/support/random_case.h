/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random cases as text; the same seed gives the same case. */
#ifndef TESTS_SUPPORT_RANDOM_CASE_H
#define TESTS_SUPPORT_RANDOM_CASE_H

#include <stdint.h>

typedef struct test_random_case {
    uint64_t state;
    char text[4000];
    int length;
} test_random_case;

/* Films that shear thin (thinning.h). */
void test_thinning_case(test_random_case *d, uint64_t seed, int level);

/* All at once (mixed.h). */
void test_mixed_case(test_random_case *d, uint64_t seed, int level);

/* A load that jumps once where cavitation is mass-conserving (jumps.h): of the
 * flooded flow this share arrives, which the text does not say. */
void test_jump_case(test_random_case *d, uint64_t seed, double *share);

/* A smooth contact under constant conditions (stays.h). */
void test_stays_case(test_random_case *d, uint64_t seed);

/* A hot contact that slides fast (hot_starts.h). */
void test_hot_start_case(test_random_case *d, uint64_t seed);

/* The flow law by points, thinning.csv, that they may name. */
void test_write_points(const char *path);

#endif
