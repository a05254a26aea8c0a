/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random load jumps with mass-conserving cavitation. */
#ifndef TESTS_SUPPORT_JUMPS_H
#define TESTS_SUPPORT_JUMPS_H

#include <stdint.h>

/* `runs` of 0.8 b/um from a seed on; printed, with the cases that fail.  From
 * each seed: M 5 to 200 (logarithmic), L 2.5 to 14, of those with 0.4 to 2 GPa,
 * level 6 to 8, steps of half a mesh to four; mass-conserving cavitation, of
 * which 0.3 to 1.2 of the flow arrives that a flooded film takes; the load
 * jumps once by half or less, up or down; SRR -2 to 2, flow laws (1/2) and heat
 * (0.3); dents, bumps, ridges and roughness on half of them.  No step may fail
 * except where surfaces touch, and none may be marked except for the heat of a
 * jump.  Its heat is late in that step and the two after it, in runs with the
 * step or a quarter of it.  A start that is not found is no jump, and rare. */
void test_jumps_survey(uint64_t seed, int runs);

#endif
