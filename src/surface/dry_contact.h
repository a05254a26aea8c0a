/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dry contact of a rough surface with a smooth one, elastic, in plane strain,
 * one period of heights z at n equal distances:
 *
 *     gap = g0 + w - z,  w of a wave of pressure p cos(k x): 2 p/(E* k) cos(k
 * x) p >= 0,  gap >= 0,  p gap = 0,  mean of p given
 *
 * Lengths and heights may have units of their own, E* then the unit of pressure
 * over their slope: 2 where x is in b, z in b^2/R, p in ph.  Conjugate
 * gradients over the nodes that touch, which are found on the way; deformation
 * by FFT (Polonsky & Keer, Wear 231 (1999) 206).
 */
#ifndef OVR_SURFACE_DRY_CONTACT_H
#define OVR_SURFACE_DRY_CONTACT_H

#include "base/arena.h"

typedef struct ovr_dry_contact {
    size_t n;       /* a power of two */
    double length;  /* of the period */
    double modulus; /* E* */
    double enough;  /* gaps and pressures exclude each other to this, over the
                       range of heights; 0: 1e-9 */
    double *workspace; /* 3 n */
} ovr_dry_contact;

/* Memory for n nodes. */
ovr_status ovr_dry_contact_take(ovr_dry_contact *of, size_t n, ovr_arena *arena,
                                ovr_error *err);

typedef struct ovr_dry_state {
    double gap;  /* its mean */
    double area; /* the part of the nodes that touch */
    int steps;
    bool found; /* else the steps did not suffice */
} ovr_dry_state;

/* The pressure p of this mean, from the one that is in p, any with a mean above
 * zero. */
ovr_dry_state ovr_dry_contact_solve(const ovr_dry_contact *of, const double *z,
                                    double mean, double *p);

#endif
