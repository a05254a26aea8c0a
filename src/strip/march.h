/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Time steps of the strip.
 *
 *     a0 q_i - F_i = d(rho H)/dT + d(rho H)/dX
 *     characteristic:  a0 q(X, T) + a1 q(X - s1, T - t1) + a2 q(X - s2, T - t2)
 *     upstream2:       a0 q + a1 q(X, T - t1) + a2 q(X, T - t2), the wedge at T
 *     a0 = (1 + 2 r)/(1 + r)/t1,  a1 = -(1 + r)/t1,  a2 = r^2/(1 + r)/t1
 *     r = t1/(t2 - t1)
 *
 * These are the weights of BDF2. In the times t1 and t2 the film moves by s1
 * and s2 with the entrainment speed.
 *
 * The film has no pressure upstream of the inlet.  There H0 - w is extrapolated
 * by a parabola through three rows.  Cubics interpolate q between rows.
 *
 * The initial guess of a step is extrapolated in time (march.c). The settings
 * of march.c are tried in turn until R is below the tolerance.
 */
#ifndef OVR_STRIP_MARCH_H
#define OVR_STRIP_MARCH_H

#include "strip/strip.h"

enum { OVR_STRIP_PAST = 4, OVR_STRIP_GUESSES = 5, OVR_STRIP_ATTEMPTS = 6 };

typedef struct ovr_strip_march {
    ovr_strip *strip;
    ovr_strip_gap *gap;
    void *data;
    bool characteristic;
    double speed; /* entrainment speed at the next time, for upstream2 */
    /* Distance moved by the film since T[0], T[1] for the characteristic
     * scheme; NAN: at the reference speed */
    double travel[2];
    double force;     /* required value at the next time */
    double carried;   /* speed of the features; NAN if unknown */
    double tolerance; /* tolerance of the imbalance R */
    /* R may also be `share` times R of the guess, up to `loosest` */
    double share, loosest;
    double load; /* maximum relative load error; 0: 10 tolerances */
    /* The past; index 0 is the last completed time. */
    double T[OVR_STRIP_PAST + 1];
    size_t known; /* number of known times that differ */
    long steps;   /* number of steps since the start */
    double *P[OVR_STRIP_PAST], H0[OVR_STRIP_PAST];
    double *q[2];          /* from row -ghosts on */
    size_t ghosts;         /* rows upstream of the inlet */
    int formula, coupling; /* formula and coupling for the next step */
    double nearness[OVR_STRIP_GUESSES];
    double next; /* time of the attempt */
    int first;   /* setting of the first attempt */
} ovr_strip_march;

typedef struct ovr_strip_step {
    int cycles, attempts, last; /* last: setting of the last attempt */
    double imbalance;
    bool solved;
} ovr_strip_step;

/* Creates the time stepping of an existing strip. `longest`: maximum step
 * length in mesh sizes. */
ovr_status ovr_strip_march_create(ovr_strip_march *march, ovr_strip *strip,
                                  double longest, ovr_arena *arena,
                                  ovr_error *err);

/* Starts at T from the strip's film, which is assumed to have been steady
 * before. */
void ovr_strip_march_begin(ovr_strip_march *march, double T);

/* Solves the film at the time `next`; the past does not change. */
ovr_strip_step ovr_strip_march_attempt(ovr_strip_march *march, double next);

/* Makes the attempt the last completed time, or restores the last completed
 * time. */
void ovr_strip_march_accept(ovr_strip_march *march);
void ovr_strip_march_back(ovr_strip_march *march);

#endif
