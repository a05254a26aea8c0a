/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Two surfaces as their own profiles have them, and what they bear when they
 * touch dry: the law of a mean film that has none of them on its mesh.
 *
 * A period of each, of the length of the shorter one, its ends blended; where
 * both are rough, in several positions along each other, the means of which
 * count.  At pressures p_j, from full contact down to single summits,
 *
 *     H_j = mean gap,  area_j = part that touches  (dry_contact.h)
 *     P_sj(x) = pressure on surface s at its own x, mean p_j
 *
 * X in b, z and H in b^2/R, p in ph.  Pressures of the contact wear each
 * surface (Archard, J. Appl. Phys. 24 (1953) 981): over a contact that bears
 * A(X) the mean of the depth that surface s loses in a pass is
 * c_s int A dX; where it loses it,
 *
 *     dz_s(x) = -c_s sum_j w_j P_sj(x),  sum_j w_j p_j = int A dX
 *
 * with w_j from A = sum of its two neighbours in the p_j: the volume is kept to
 * rounding.
 */
#ifndef OVR_SURFACE_ROUGH_PAIR_H
#define OVR_SURFACE_ROUGH_PAIR_H

#include "contact/touch_law.h"
#include "overroll/surface.h"

typedef struct ovr_rough_pair {
    size_t n;       /* a power of two */
    double length;  /* of the period */
    double *z[2];   /* NULL: smooth */
    double modulus; /* E* in its units */
    bool cut;       /* one was longer than the other */

    /* Numbers of both together, which ovr_rough_pair_law fills. */
    double Rq, slope;
    size_t points;
    double *p;           /* rising */
    double *pressure[2]; /* P_sj, j by j; NULL: smooth */
    double *workspace;   /* 5 n */
} ovr_rough_pair;

/* Contact of features that are profiles or random roughness, one a surface and
 * at least one. */
ovr_status ovr_rough_pair_make(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               const ovr_contact *contact, ovr_arena *arena,
                               ovr_error *err);

/* Computes the roughness finer than a grid of that mesh size (resample.h), on a
 * stretch of both that has points enough for it. */
ovr_status ovr_rough_pair_rest(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               double mesh, const ovr_contact *contact,
                               ovr_arena *arena, ovr_error *err);

/* The same of n heights that are there, a period; copied. */
ovr_status ovr_rough_pair_take(ovr_rough_pair *pair, size_t n, double length,
                               const double *const z[2], ovr_arena *arena,
                               ovr_error *err);

/* Space for its laws and their table, unless it has it. */
ovr_status ovr_rough_pair_reserve(ovr_rough_pair *pair,
                                  ovr_asperity_table *table, ovr_arena *arena,
                                  ovr_error *err);

/* The law of its heights as they are; takes space where there is none. */
ovr_status ovr_rough_pair_law(ovr_rough_pair *pair, ovr_asperity_table *table,
                              ovr_arena *arena, ovr_error *err);

/* Adds to w[points] what a stretch dX that bears A is. */
void ovr_rough_pair_weigh(const ovr_rough_pair *pair, double A, double dX,
                          double *w);

/* Removes c_s w from each surface; the largest depth over c. */
void ovr_rough_pair_wear(ovr_rough_pair *pair, const double c[2],
                         const double *w);
double ovr_rough_pair_deepest(const ovr_rough_pair *pair, const double c[2],
                              const double *w);

#endif
