/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random pairs of ground surfaces in random steel contacts whose film thickness
 * is below the roughness: number of complete runs and their cost. */
#ifndef TESTS_SUPPORT_GROUND_H
#define TESTS_SUPPORT_GROUND_H

#include "overroll/run.h"

typedef struct test_ground {
    bool hot, inside; /* inside: roughness is in the whole film at T = 0 */
    double ph, slide; /* GPa; slide-to-roll ratio */
    double stress;    /* Eyring stress, MPa; 0: Newtonian */
    double lambda;    /* film thickness of smooth surfaces relative to Rq */
    double Rq[2], slope[2], longest[2]; /* um, 1, um */
    double H_min, P_max, T;             /* extremes of the run; its last T */
    double layer; /* thickness of the boundary layer, nm; 0: none */
    double share; /* mean asperity load share */
    int level, steps, cycles, retries, marked;
    ovr_status status;
    ovr_error err;
} test_ground;

/*
 * Runs a random pair until the slower surface has passed the contact.
 *
 *   contact   steel, R = 6.84 mm, SRR -1 to 1, 11 mPa s, 16 1/GPa; the smooth
 *             central film thickness is lambda Rq, lambda = `from` to `to`
 *   surfaces  self-affine, Hurst exponent 0.8, each with an Rq of 0.05 to 0.4
 *             um and an rms slope of 0.01 to 0.08; the shortest wavelength is
 *             2.5 to 10 um, and the longest follows from the slope
 *   lubricant even seeds: Newtonian at 0.4 to 0.7 GPa; odd seeds: Eyring
 *             model, 3 to 8 MPa, at 0.5 to 1.5 GPa; with heat if the seed ends
 *             in 9
 */
test_ground test_ground_run(uint64_t seed, double from, double to, int level);

/* Solves the steady start with these surfaces in the whole film, and a step. */
test_ground test_ground_start(uint64_t seed, double from, double to, int level);

/* Runs a random pair with the Eyring model and asperity contact of a boundary
 * layer of thickness `layer` (nm), which decays within a third of it. */
test_ground test_ground_touching(uint64_t seed, double from, double to,
                                 int level, double layer);

/* Runs `runs` pairs by test_ground_touching and prints them. */
typedef struct test_ground_tally {
    int failed;        /* number of incomplete runs */
    int max_retries;   /* maximum of all runs */
    double cycles;     /* Newton steps per time step, mean of all runs */
    double max_cycles; /* maximum of the means of the runs */
} test_ground_tally;
test_ground_tally test_ground_survey(uint64_t seed, int runs, double from,
                                     double to, int level, double layer);

/* Returns the mean asperity load share of a run with lambda = 1. The asperity
 * pressure is amplitude exp(-h/decay), decay in nm. The film thickness is 194
 * nm, and both surfaces have an Rq of 137 nm and wavelengths of 0.15 to 1 b. */
double test_ground_share(double amplitude, double decay, int level);

#endif
