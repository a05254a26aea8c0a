/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Central film thickness of a run against time, from the text of a case, and
 * its distance from that of a more accurate run. */
#ifndef TESTS_SUPPORT_SERIES_H
#define TESTS_SUPPORT_SERIES_H

#include <stddef.h>

enum { TEST_SERIES = 60000 };

typedef struct test_series {
    size_t n;
    double T[TEST_SERIES], H[TEST_SERIES];
    long cycles;
    double seconds; /* CPU time of the thread: start and march */
} test_series;

/* Fails the test unless it converges; relative paths of the case start at
 * `directory` (NULL: the working directory). */
void test_series_run(const char *text, const char *directory, test_series *s);

/* rms in time of the relative error of H_cen, the better series linear. */
double test_series_error(const test_series *s, const test_series *better);

#endif
