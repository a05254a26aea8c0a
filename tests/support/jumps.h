/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random load jumps with mass-conserving cavitation. */
#ifndef TESTS_SUPPORT_JUMPS_H
#define TESTS_SUPPORT_JUMPS_H

#include <stdint.h>

/* `runs` of 0.8 b/um from a seed on; prints the cases that fail. Per seed: M 5
 * to 200 (logarithmic), L 2.5 to 14, only 0.4 to 2 GPa; levels 6 to 8; steps
 * of 0.5 to 4 D; mass-conserving cavitation, supplied with 0.3 to 1.2 times
 * the flooded flow rate; one jump of the load by half or less, up or down; SRR
 * -2 to 2; flow laws (1/2) and heat (0.3); features and roughness on half of
 * the surfaces. No step may fail unless surfaces touch, and none may be
 * flagged except for the heat of the jump, in that step and the next two, with
 * the given step or a quarter of it. A start that is not found is not counted
 * as a jump; it is rare. */
void test_jumps_survey(uint64_t seed, int runs);

#endif
