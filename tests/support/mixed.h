/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random runs with all physical models in combination. */
#ifndef TESTS_SUPPORT_MIXED_H
#define TESTS_SUPPORT_MIXED_H

#include <stdint.h>

/* `runs` of 3 b/um from a seed on, on a level and the next in turns; printed.
 * From each seed: M 5 to 200 (logarithmic), L 2.5 to 14, of those with 0.4 to
 * 2 GPa; SRR -2 to 2; Newtonian (1/4), Eyring, Carreau-Yasuda in both forms or
 * a table of points, 2 to 15 MPa; heat (1/2); flooded, conserved or starved (a
 * third each); a dent, bump or ridge (0.7) and roughness (0.6) on each surface;
 * load (0.7 to 1.4), speed (0.5 to 2) and sliding along ramps, sines and
 * jumps; steps of a mesh, of 0.02 or adaptive; stresses (1/5).  No run may fail
 * but where surfaces touch, which is said, and 3 % at most may be marked;
 * beside them a tenth of the hot films whose load, speed or sliding varies, if
 * they say that their heat came late: where a load jumps, or sliding jumps or
 * passes through zero, it changes by much in a step. */
void test_mixed_survey(uint64_t seed, int runs, int level);

#endif
