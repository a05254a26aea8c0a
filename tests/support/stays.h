/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random smooth contacts at constant conditions: a run remains at its steady
 * initial state. */
#ifndef TESTS_SUPPORT_STAYS_H
#define TESTS_SUPPORT_STAYS_H

#include <stdint.h>

/*
 * `runs` of 3 b/um from a seed on; printed, those that do not stay with their
 * case.  From each seed: 0.4 to 2 GPa, radii of 3 to 30 mm, 0.1 to 20 m/s,
 * slide-to-roll 0 (1 of 6), up to 0.3, 1.9, 2 or 3 either way; oils of 3 to 100
 * mPa s and 12 to 24 1/GPa, Newtonian, by Eyring's or Carreau's law, one in
 * four with a limiting shear stress; three in four hot; two in five
 * mass-conserving, of which two in five live on a film of 0.05 to 2 um; level 6
 * or 7, along the characteristic (two in three) or upstream2, steps as they
 * are left open.
 *
 * The start is of another discretization than steps in time, which changes thin
 * films by some per cent on these levels: a wave that has left the contact at T
 * = 2.  From T = 2.5 to 3 H_min and H_cen may change by 3e-3, P_max and the
 * largest rise by 2e-2.  No step may fail, one run in 50 may have marked steps,
 * one in 50 temperatures that the grid does not resolve (an energy balance
 * error above 5 %), and one in 50 at most has no start.
 */
void test_stays_survey(uint64_t seed, int runs);

#endif
