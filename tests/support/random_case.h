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

/* Draws a film with shear thinning (thinning.h). */
void test_thinning_case(test_random_case *d, uint64_t seed, int level);

/* Draws a combination of all models (mixed.h). */
void test_mixed_case(test_random_case *d, uint64_t seed, int level);

/* Draws a load jump with mass-conserving cavitation (jumps.h). *share is the
 * supply ratio, which is not in the text. */
void test_jump_case(test_random_case *d, uint64_t seed, double *share);

/* Draws a smooth contact under constant conditions (stays.h). */
void test_stays_case(test_random_case *d, uint64_t seed);

/* Draws a thermal contact with high sliding speed (hot_starts.h). */
void test_hot_start_case(test_random_case *d, uint64_t seed);

/* Writes the rheological model by points that the cases name (thinning.csv). */
void test_write_points(const char *path);

#endif
