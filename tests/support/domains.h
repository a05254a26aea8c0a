/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random histories on the domain that the program chooses, and on one twice as
 * wide. */
#ifndef TESTS_SUPPORT_DOMAINS_H
#define TESTS_SUPPORT_DOMAINS_H

#include <stdint.h>

/*
 * From each seed, printed: M 5 to 200 (logarithmic), L 0 to 14; load, speed and
 * radius each constant, a ramp, a sine or a table, within sqrt(5), 3 and 1.4
 * times nominal or a part of it and over 0.6 b/um at least (radius 3), or two
 * passes of such loads with oil enough (a quarter); 3 b/um in steps of 0.05, on
 * meshes below 0.02 b.  Compared on the same nodes: H_cen at every step, to
 * 5e-4 (2e-3 in two of a hundred, where the front of another film passes X = 0
 * or curvature rides no farther out), and the largest P_max, to 2e-3.  Cases
 * that cannot be solved on either domain, or whose curvature cannot ride on the
 * wide one, are drawn again.  Jumps are not among them: the oil that they
 * squeeze out behind goes beyond the usual outlet (overroll-theory(7)).
 */
void test_domains_survey(uint64_t seed, int runs);

#endif
