/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with all physical models in combination. */
#ifndef TESTS_SUPPORT_MIXED_H
#define TESTS_SUPPORT_MIXED_H

#include <stdint.h>

/* `runs` of 3 b/um from a seed on, on a level and the next in turn; printed.
 * Per seed: M 5 to 200 (logarithmic), L 2.5 to 14, only 0.4 to 2 GPa; SRR -2
 * to 2; Newtonian (1/4), Eyring, both forms of Carreau-Yasuda or a table of
 * points, 2 to 15 MPa; heat (1/2); flooded, mass-conserving or starved (a
 * third each); a dent, bump or ridge (0.7) and roughness (0.6) on each
 * surface; load (0.7 to 1.4), speed (0.5 to 2) and sliding along ramps, sines
 * and jumps; steps of D, of 0.02 or adaptive; stresses (1/5). No run may fail
 * unless surfaces touch, as its message must state, and at most 3 % may have
 * flagged steps. A tenth of the hot films whose load, speed or sliding varies
 * may have more, with the message that temperatures lag: the film changes much
 * within a step if load or sliding jumps or sliding passes through zero. */
void test_mixed_survey(uint64_t seed, int runs, int level);

#endif
