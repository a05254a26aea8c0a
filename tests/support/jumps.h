/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random load jumps with mass-conserving cavitation. */
#ifndef TESTS_SUPPORT_JUMPS_H
#define TESTS_SUPPORT_JUMPS_H

#include <stdint.h>

/*
 * Runs `runs` random cases of 0.8 b/um and prints those that fail.
 *
 *   contact    M 5 to 200 (logarithmic), L 2.5 to 14, p_h 0.4 to 2 GPa, SRR -2
 *              to 2; half of the cases with a rheological model, 30 % with heat
 *   grid       levels 6 to 8, steps of 0.5 to 4 D
 *   supply     mass-conserving cavitation with 0.3 to 1.2 times the flooded
 *              flow rate
 *   load       one jump by up to 50 %
 *   features   half of the cases: features and roughness
 *
 * No step may fail unless surfaces touch. No step may be flagged, except for
 * lagging temperatures in the step of the jump and the next two, with the given
 * step or a quarter of it. At most one of 50 cases may have no steady start.
 */
void test_jumps_survey(uint64_t seed, int runs);

#endif
