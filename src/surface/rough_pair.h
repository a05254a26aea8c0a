/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dry contact of two surfaces with measured profiles. Computes the asperity
 * contact law for a mean film whose grid does not contain the profiles.
 *
 * One period of each profile is used, with blended ends and the length of the
 * shorter profile. If both surfaces are rough, results are averaged over
 * several relative positions. At mean pressures p_j, from full contact down to
 * single summits, the results are
 *
 *     H_j     mean gap
 *     area_j  contact area fraction (dry_contact.h)
 *     P_sj(x) pressure on surface s at its own x, with mean p_j
 *
 * X is in b, z and H in b^2/R, p in p_h.
 *
 * Wear of surface s in a pass (Archard, J. Appl. Phys. 24 (1953) 981): in a
 * contact with the asperity pressure A(X) the mean worn depth is c_s int A dX,
 * with the distribution
 *
 *     dz_s(x) = -c_s sum_j w_j P_sj(x),  sum_j w_j p_j = int A dX.
 *
 * The weights w_j interpolate A linearly between neighbouring p_j, so that the
 * worn volume is correct to rounding.
 */
#ifndef OVR_SURFACE_ROUGH_PAIR_H
#define OVR_SURFACE_ROUGH_PAIR_H

#include "contact/touch_law.h"
#include "overroll/surface.h"

typedef struct ovr_rough_pair {
    size_t n;       /* a power of two */
    double length;  /* length of the period */
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
