/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random pairs of ground surfaces in random steel contacts: whether runs are
 * complete although the film is thinner than the roughness. */
#ifndef TESTS_SUPPORT_GROUND_H
#define TESTS_SUPPORT_GROUND_H

#include "overroll/run.h"

typedef struct test_ground {
    bool hot, inside;                   /* at T = 0 under the whole film */
    double ph, slide, stress, lambda;   /* GPa, SRR, MPa or 0, film over Rq */
    double Rq[2], slope[2], longest[2]; /* um, 1, um */
    double H_min, P_max, T;             /* of the run, where it ended */
    double layer, share;                /* nm, 0: none; of the load, the mean */
    int level, steps, cycles, retries, marked;
    ovr_status status;
    ovr_error err;
} test_ground;

/*
 * R = 6.84 mm, steel, an oil of 11 mPa s and 16 1/GPa; lambda of the smooth
 * central film, `from` to `to`; SRR -1 to 1; both surfaces with an Rq of 0.05
 * to 0.4 um and slopes of 0.01 to 0.08, self-affine, Hurst 0.8, waves from 2.5
 * to 10 um, as profiles are filtered, up to what gives that slope.  Even seeds
 * are Newtonian at 0.4 to 0.7 GPa, odd ones thin by Eyring's law with 3 to 8
 * MPa at 0.5 to 1.5 GPa, those that end in 9 with heat.  To where the slower
 * surface has filled the contact.
 */
test_ground test_ground_run(uint64_t seed, double from, double to, int level);

/* The same pairs under the whole film of the steady start, and a step. */
test_ground test_ground_start(uint64_t seed, double from, double to, int level);

/* Those by Eyring's law, with a layer of so many nm that falls by e in a third
 * of them. */
test_ground test_ground_touching(uint64_t seed, double from, double to,
                                 int level, double layer);

/* What becomes of many of them, printed run by run. */
typedef struct test_ground_tally {
    int broken;        /* off before their end */
    int max_retries;   /* of a run */
    double cycles;     /* Newton's steps a time step, the mean of all */
    double max_cycles; /* of a run, the mean of its steps */
} test_ground_tally;
test_ground_tally test_ground_survey(uint64_t seed, int runs, double from,
                                     double to, int level, double layer);

/* The mean of the contact share of a run of lambda 1, a film of 194 nm over
 * surfaces of 137 nm each, waves of 0.15 to 1 b, by amplitude exp(-h/decay);
 * nm. */
double test_ground_share(double amplitude, double decay, int level);

#endif
