/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dry elastic contact of a rough surface with a smooth one in plane strain. One
 * period of heights z is given at n equal distances:
 *
 *     gap = g0 + w - z,  w of a wave of pressure p cos(k x): 2 p/(E* k) cos(k
 * x) p >= 0,  gap >= 0,  p gap = 0,  mean of p given
 *
 * Lengths and heights may have different units; E* is then in units of pressure
 * per slope: 2 for x in b, z in b^2/R and p in p_h. Method: conjugate gradients
 * over the nodes in contact, which are determined during the iteration;
 * deformation by FFT (Polonsky & Keer, Wear 231 (1999) 206).
 */
#ifndef OVR_SURFACE_DRY_CONTACT_H
#define OVR_SURFACE_DRY_CONTACT_H

#include "base/arena.h"

typedef struct ovr_dry_contact {
    size_t n;          /* a power of two */
    double length;     /* length of the period */
    double modulus;    /* E* */
    double enough;     /* tolerance of complementarity of gaps and pressures,
                        * relative to the range of heights; 0: 1e-9 */
    double *workspace; /* 3 n elements */
} ovr_dry_contact;

/* Allocates memory for n nodes. */
ovr_status ovr_dry_contact_take(ovr_dry_contact *of, size_t n, ovr_arena *arena,
                                ovr_error *err);

typedef struct ovr_dry_state {
    double gap;  /* mean gap */
    double area; /* fraction of the nodes in contact */
    int steps;
    bool found; /* converged */
} ovr_dry_state;

/* Solves for the pressure p with this mean. On entry p is the initial guess;
 * its mean must be positive. */
ovr_dry_state ovr_dry_contact_solve(const ovr_dry_contact *of, const double *z,
                                    double mean, double *p);

#endif
