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

/* Compares patches up to a level (M = 20, L = 10, level 8) with the uniform
 * grid of that level and linear pressure: spike height within 1e-4, minimum
 * film thickness within 2e-6. */
void test_spike_beside_uniform(int to);

/* So many random contacts, M = 5 to 1000, L = 1 to 16: they converge, and the
 * smallest film over levels 8 and 9 is the same within 2e-3 but for a tenth. */
void test_spike_survey(uint64_t seed, int cases);

#endif
