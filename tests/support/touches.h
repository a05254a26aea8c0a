/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random steady contacts with asperity contact. */
#ifndef TESTS_SUPPORT_TOUCHES_H
#define TESTS_SUPPORT_TOUCHES_H

#include <stdint.h>

/* Solves `runs` random mean films from a seed on: M 5 to 200 and lambda 0.1 to
 * 6 by the film thickness formula (both logarithmic), L 5 to 14, exponential
 * law with an asperity pressure of 0.3, 1 or 3 p_h at H = 0, level 5 or, from M
 * = 60, 6. None may fail, except for solutions that are withheld because the
 * law (0.3 p_h) does not apply. The load error is below 1e-9. The mean number
 * of Newton steps is at most half of the maximum of one attempt. */
void test_touches_survey(uint64_t seed, int runs);

#endif
