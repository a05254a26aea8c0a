/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with jumps, oscillations and ramps of load and speed. */
#ifndef TESTS_SUPPORT_HISTORIES_H
#define TESTS_SUPPORT_HISTORIES_H

#include <stdbool.h>
#include <stdint.h>

typedef struct test_histories {
    long runs, steps, cycles, retries, substeps, marked;
    long maximum; /* cycles of a step */
    long refused, touching;
    long missed; /* refused or marked, where the dense Newton converges */
} test_histories;

/*
 * So many runs of 1.2 b/um, upstream2: M = 5 to 1000 and dT = D/2 to 4 D
 * logarithmic, L = 2 to 14, outlet at 1.5 to 3, level 7 or 8; load and speed
 * each constant, a jump by half or less up or down, a swing by half or less
 * within 1 to 3 b/um, or a ramp as far within 0.05 to 0.5; a third with a dent
 * on the way through.  Contacts whose film is too thin for the mesh are drawn
 * again.  A step that is refused is tried by the dense Newton from the same
 * past.
 */
test_histories test_histories_run(uint64_t seed, long runs, bool check);

#endif
