/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady contacts with patches around the pressure spike, compared with uniform
 * grids of the same kernel. */
#ifndef TESTS_SUPPORT_SPIKE_H
#define TESTS_SUPPORT_SPIKE_H

#include <stdint.h>

#include "overroll/simulation.h"

/* With patches over a level; `to` 0: until the spike changes by less than
 * `change`.  The observation's P_spike is NAN when it did not converge. */
ovr_observation test_spike(double M, double L, double inlet, int level, int to,
                           double change);

/* Compares patches up to a level with the uniform grid of that level and
 * linear pressure (M = 20, L = 10, level 8). Tolerances: spike height 1e-4,
 * minimum film thickness 2e-6. */
void test_spike_beside_uniform(int to);

/* Solves `cases` random contacts, M = 5 to 1000, L = 1 to 16. All converge.
 * The minimum film thickness on levels 8 and 9 agrees within 2e-3 in nine of
 * ten. */
void test_spike_survey(uint64_t seed, int cases);

#endif
