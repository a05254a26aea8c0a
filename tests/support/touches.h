/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random steady contacts with asperity contact. */
#ifndef TESTS_SUPPORT_TOUCHES_H
#define TESTS_SUPPORT_TOUCHES_H

#include <stdint.h>

/* `runs` mean films from a seed on: M 5 to 200, lambda 0.1 to 6 by the film
 * formula (both logarithmic), L 5 to 14; exponential laws with 0.3, 1 or 3 ph
 * at no gap; level 5, from M = 60 on 6.  None may fail
 * (a film below which a1 = 0.3 is exhausted is found, and withheld), each
 * carries its load to 1e-9, and of Newton's steps half of what one attempt may
 * take is enough on the mean. */
void test_touches_survey(uint64_t seed, int runs);

#endif
