/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dry contact of two surfaces with measured profiles. Computes the asperity
 * contact law for a mean film whose grid does not contain the profiles.
 *
 * One period of each profile, of the length of the shorter one and with blended
 * ends, is used. If both are rough, results are averaged over several relative
 * positions. At pressures p_j, from full contact down to single summits,
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
    double *z[2];   /* heights; NULL: smooth */
    double modulus; /* E* in units of the pair */
    bool cut;       /* the longer profile was shortened */

    /* Results for both surfaces together, computed by ovr_rough_pair_law. */
    double Rq, slope;
    size_t points;
    double *p;           /* mean pressures, increasing */
    double *pressure[2]; /* P_sj, one row per j; NULL: smooth */
    double *workspace;   /* 5 n elements */
} ovr_rough_pair;

/* Makes the contact of features that are profiles or random roughness, at most
 * one per surface. */
ovr_status ovr_rough_pair_make(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               const ovr_contact *contact, ovr_arena *arena,
                               ovr_error *err);

/* Computes the roughness that is too fine for a grid of this mesh size
 * (resample.h). Both profiles are shortened to a length with enough points for
 * it. */
ovr_status ovr_rough_pair_rest(ovr_rough_pair *pair,
                               const ovr_feature_form *const form[2],
                               double mesh, const ovr_contact *contact,
                               ovr_arena *arena, ovr_error *err);

/* Makes the contact from one period of n heights per surface, which are
 * copied. */
ovr_status ovr_rough_pair_take(ovr_rough_pair *pair, size_t n, double length,
                               const double *const z[2], ovr_arena *arena,
                               ovr_error *err);

/* Allocates memory for the contact law and its table, unless allocated. */
ovr_status ovr_rough_pair_reserve(ovr_rough_pair *pair,
                                  ovr_asperity_table *table, ovr_arena *arena,
                                  ovr_error *err);

/* Computes the contact law of the present heights; allocates memory if
 * necessary. */
ovr_status ovr_rough_pair_law(ovr_rough_pair *pair, ovr_asperity_table *table,
                              ovr_arena *arena, ovr_error *err);

/* Adds to w[points] the weights of a length dX that carries the asperity
 * pressure A. */
void ovr_rough_pair_weigh(const ovr_rough_pair *pair, double A, double dX,
                          double *w);

/* Removes the wear depth c_s sum_j w_j P_sj from the heights of each surface s.
 * The second function returns the largest of these depths. */
void ovr_rough_pair_wear(ovr_rough_pair *pair, const double c[2],
                         const double *w);
double ovr_rough_pair_deepest(const ovr_rough_pair *pair, const double c[2],
                              const double *w);

#endif
