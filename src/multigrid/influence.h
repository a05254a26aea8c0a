/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Elastic deformation as a sum of contributions:
 *
 *     w_i = sum_j (K_ij + R_ij) P_j - c P_i,   H_i = H0 + gap_i - w_i
 *
 * K is the logarithm of two half-spaces.  R is a smooth remainder, the sum of
 * any number of parts, which MLMI adds to K (deformation.h).  c is the
 * compliance of a Winkler foundation, which deforms only under the pressure,
 * such as a thin layer. K, R and c are used by all modules that need the
 * influence: smoothers, the coarsest grids and the ghosts beyond the inlet.
 *
 * The line relaxation assumes that a distributed change deforms neighbouring
 * nodes only. With the logarithmic kernel, the neglected part has a damping
 * effect. If R falls steeply within one or two mesh sizes and is flat beyond (a
 * soft layer as thick as a mesh size), the sum of the neglected part changes
 * sign, and long waves grow by up to 56 per sweep. Therefore the differences
 * g_d = k_(d+1) - k_d of the band (only) are bounded:
 *     g_d >= c_d g_(d-1),  c = .05, .3, .5, .6
 * The differences of the logarithmic kernel fall by .44, .57, .70 and .78. Film
 * and coarsest grids use K + R unchanged.
 */
#ifndef OVR_MULTIGRID_INFLUENCE_H
#define OVR_MULTIGRID_INFLUENCE_H

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"

enum { OVR_INFLUENCE_PARTS = 4 };

typedef struct ovr_influence {
    bool linear; /* pressure between nodes (deformation.h), else constant */
    double
        compliance; /* c, local compliance, H per P; sum over all such layers */
    ovr_influence_part part[OVR_INFLUENCE_PARTS]; /* R */
    int parts;
} ovr_influence;

/* Adds a part to R. Returns false if there is no space for it. */
bool ovr_influence_add(ovr_influence *influence, ovr_influence_part part);

/* Deformation at a distance of d mesh sizes, dw_i/dP_j; and that of R alone. */
double ovr_influence_at(const ovr_influence *influence, double d, double D);
double ovr_influence_rest(const ovr_influence *influence, double d, double D);

/* Deformation at distances of 0 to 5 mesh sizes, bounded for the line
 * relaxation. */
void ovr_influence_band(const ovr_influence *influence, double D, double k[6]);

/* True if the fourth-order correction is known for all parts; C of
 * fourth_order.h, a sum over the aliases of the grid,
 *     C = (1/2 pi^3) sum_n (-1)^(n+1) A(2 pi n/D)/n^3,
 * for linear pressures (1/4 pi^3) sum_n A(2 pi n/D)/n^3. */
bool ovr_influence_corrected(const ovr_influence *influence);
double ovr_influence_local(const ovr_influence *influence, double D);

#endif
