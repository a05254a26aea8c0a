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
 * BDF2 has these weights.  In the times t1 and t2 the mean speed moves the film
 * by the lengths s1 and s2 respectively.
 *
 * The film has no pressure upstream of the inlet.  A parabola through three
 * rows extrapolates H0 - w to there.  Cubics interpolate q between rows.
 *
 * A step starts from a guess extrapolated in time (march.c).  The settings of
 * march.c are attempted in turn until R is below the tolerance.
 */
#ifndef OVR_STRIP_MARCH_H
#define OVR_STRIP_MARCH_H

#include "strip/strip.h"

enum { OVR_STRIP_PAST = 4, OVR_STRIP_GUESSES = 5, OVR_STRIP_ATTEMPTS = 5 };

typedef struct ovr_strip_march {
    ovr_strip *strip;
    ovr_strip_gap *gap;
    void *data;
    bool characteristic;
    double speed; /* mean speed at the next time, of upstream2 */
    /* Way of the film since T[0], T[1] for the characteristic scheme; NAN: at
     * the nominal speed */
    double travel[2];
    double force;     /* target at the next time */
    double carried;   /* speed of the features; NAN if unknown */
    double tolerance; /* of R */
    /* R may also be that share of R at the guess, up to `loosest` */
    double share, loosest;
    double load; /* largest relative error of the load; 0: 10 tolerances */
    /* The past: 0 is the last time that was reached. */
    double T[OVR_STRIP_PAST + 1];
    size_t known; /* times of it that differ */
    long steps;   /* since the begin */
    double *P[OVR_STRIP_PAST], H0[OVR_STRIP_PAST];
    double *q[2];          /* from row -ghosts on */
    size_t ghosts;         /* rows upstream of the inlet */
    int formula, coupling; /* that begin the next step */
    double nearness[OVR_STRIP_GUESSES];
    double next; /* time of the attempt */
} ovr_strip_march;

typedef struct ovr_strip_step {
    int cycles, attempts;
    double imbalance;
    bool solved;
} ovr_strip_step;

/* `longest`: the longest step in mesh sizes.  The strip is there already. */
ovr_status ovr_strip_march_create(ovr_strip_march *march, ovr_strip *strip,
                                  double longest, ovr_arena *arena,
                                  ovr_error *err);

/* Begins at T from the strip's film, as if it had always been so. */
void ovr_strip_march_begin(ovr_strip_march *march, double T);

/* Solves the film at the time `next`; the past stays. */
ovr_strip_step ovr_strip_march_attempt(ovr_strip_march *march, double next);

/* Makes the attempt the last time that was reached, or returns to that. */
void ovr_strip_march_accept(ovr_strip_march *march);
void ovr_strip_march_back(ovr_strip_march *march);

#endif
