/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random histories on the default domain and on a domain twice as wide. */
#ifndef TESTS_SUPPORT_DOMAINS_H
#define TESTS_SUPPORT_DOMAINS_H

#include <stdbool.h>
#include <stdint.h>

/*
 * From each seed, printed: M 5 to 200 (logarithmic), L 0 to 14; load, speed and
 * radius each constant, a ramp, a sine or a table, within sqrt(5), 3 and 1.4
 * times nominal or a part of it and over 0.6 b/um at least (radius 3), or two
 * passes of such loads with oil enough (a quarter); 3 b/um in steps of 0.05, on
 * meshes below 0.02 b.  Compared on the same nodes: H_cen at every step, to
 * 5e-4 (2e-3 in two of a hundred, where the front of another film passes X = 0
 * or curvature is convected no farther out), and the largest P_max, to 2e-3.
 * Cases that cannot be solved on either domain, in which a step is halved on
 * either, or whose curvature cannot ride on the wide one, are drawn again.
 *
 * With `jumps` the load is a step within sqrt(5) times nominal or a part of it,
 * and the radius constant: 0.4 to 1 % of a film are lost by the outlet of
 * constant loads, and 5 % of P_max in the jump.  In one of ten the same bounds
 * may be missed (the front of the film before the jump passes X = 0, where a
 * mesh of 0.02 b and the steps leave more), never by more than 2e-3 and 5e-3.
 */
void test_domains_survey(uint64_t seed, int runs, bool jumps);

#endif
