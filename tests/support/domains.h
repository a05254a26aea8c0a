/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random histories on the default domain and on a domain twice as wide. */
#ifndef TESTS_SUPPORT_DOMAINS_H
#define TESTS_SUPPORT_DOMAINS_H

#include <stdbool.h>
#include <stdint.h>

/*
 * Runs and prints random cases of consecutive seeds. M is 5 to 200
 * (logarithmic) and L 0 to 14. Load, speed and radius are each constant, a
 * ramp, a sine or a table. Their values are within a factor of sqrt(5), 3 and
 * 1.4 of the reference values. They change within 0.6 b/um (radius: 3) or
 * longer. A quarter of the cases have two passes of such loads with a flooded
 * supply. Runs are 3 b/um long in steps of 0.05, with mesh sizes below 0.02 b.
 *
 * Both domains have common nodes. H_cen of every step agrees within 5e-4, and
 * the maximum of P_max within 2e-3. In two of a hundred runs H_cen may differ
 * by 2e-3. In these runs the front of another film passes X = 0, or the
 * curvature is not convected further upstream. Cases are drawn again if a
 * domain has no solution, if a step is halved, or if the wide domain cannot
 * convect the curvature.
 *
 * With `jumps`, the load is a step within a factor of sqrt(5), and the radius
 * is constant. With the outlet position of constant loads, errors would be 0.4
 * to 1 % of a film thickness and 5 % of P_max during the jump. One of ten runs
 * may exceed the bounds, up to 2e-3 and 5e-3. In these runs the front of the
 * film before the jump passes X = 0, where the discretization error is larger.
 */
void test_domains_survey(uint64_t seed, int runs, bool jumps);

#endif
