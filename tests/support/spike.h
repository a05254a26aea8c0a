/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady contacts with patches around the pressure spike, compared with uniform
 * grids of the same kernel. */
#ifndef TESTS_SUPPORT_SPIKE_H
#define TESTS_SUPPORT_SPIKE_H

#include <stdint.h>

#include "overroll/simulation.h"

/* Solves on a level with patches up to level `to` or, if `to` is 0, until the
 * spike changes by less than `change`. P_spike is NAN if not converged. */
ovr_observation test_spike(double M, double L, double inlet, int level, int to,
                           double change);

/* Compares patches up to a level with the uniform grid of that level and
 * linear pressure (M = 20, L = 10, level 8). Tolerances: spike height 1e-4,
 * minimum film thickness 2e-6. */
void test_spike_and_uniform(int to);

/* Solves `cases` random contacts, M = 5 to 1000, L = 1 to 16, on levels 8 and
 * 9. In nine of ten, both solutions converge and their minimum film thicknesses
 * agree within 2e-3. */
void test_spike_survey(uint64_t seed, int cases);

#endif
