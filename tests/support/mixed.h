/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with all physical models in combination. */
#ifndef TESTS_SUPPORT_MIXED_H
#define TESTS_SUPPORT_MIXED_H

#include <stdint.h>

/*
 * Runs and prints `runs` random cases of 3 b/um, on `level` and the next level
 * in turn.
 *
 *   contact    M 5 to 200 (logarithmic), L 2.5 to 14, p_h 0.4 to 2 GPa, SRR -2
 *              to 2
 *   lubricant  Newtonian (1/4), Eyring, Carreau-Yasuda in both forms or a table
 *              of points, 2 to 15 MPa; heat in half of the cases
 *   supply     flooded, mass-conserving or starved, a third each
 *   features   on each surface a dent, bump or ridge (0.7) and roughness (0.6)
 *   histories  load (0.7 to 1.4), speed (0.5 to 2) and sliding: ramps, sines
 *              and jumps
 *   steps      D, 0.02 or adaptive
 *   stresses   in a fifth of the cases
 *
 * No run may fail, except with the message that surfaces touch. The number of
 * flagged steps may be 3 % of the number of runs. In addition, temperatures may
 * lag in a tenth of the hot runs with a varying load, speed or sliding: the
 * film changes much within a step if load or sliding jumps or if the sliding
 * passes through zero.
 */
void test_mixed_survey(uint64_t seed, int runs, int level);

#endif
