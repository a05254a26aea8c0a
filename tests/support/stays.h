/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random smooth contacts at constant conditions: a run remains at its steady
 * initial state. */
#ifndef TESTS_SUPPORT_STAYS_H
#define TESTS_SUPPORT_STAYS_H

#include <stdint.h>

/*
 * Runs `runs` random cases of 3 b/um from a seed on and prints those that do
 * not remain at their steady state.
 *
 *   contact    0.4 to 2 GPa, radius 3 to 30 mm, 0.1 to 20 m/s; slide-to-roll
 *              ratio 0 (1 in 6) or up to 0.3, 1.9, 2 or 3 in both directions
 *   lubricant  3 to 100 mPa s, 12 to 24 1/GPa; Newtonian, Eyring or Carreau;
 *              limiting shear stress (1 in 4); heat (3 in 4)
 *   supply     mass-conserving cavitation (2 in 5), of which 2 in 5 have a
 *              supplied film of 0.05 to 2 um
 *   grid       level 6 or 7, scheme characteristic (2 in 3) or upstream2,
 *              default steps
 *
 * The steady start and time steps have different discretizations. On these
 * levels the film thickness of thin films therefore changes by some per cent,
 * in a wave that leaves the contact before T = 2. From T = 2.5 to 3, H_min and
 * H_cen may change by 3e-3, P_max and the maximum temperature rise by 2e-2. No
 * step may fail. One run in 50 each may have flagged steps, an energy balance
 * error above 5 % at the start, or no steady solution.
 */
void test_stays_survey(uint64_t seed, int runs);

#endif
