/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The elastic influence of a pressure: what of the deformation is whose.
 *
 *     w_i = sum_j (K_ij + R_ij) P_j - c P_i,   H_i = H0 + gap_i - w_i
 *
 * K is the logarithm of two half-spaces.  R is a smooth remainder, of any
 * number of parts, which MLMI sums with it (deformation.h).  c is the
 * compliance of a Winkler foundation, which deforms only under the pressure,
 * such as a thin layer.  They are used by all modules that need the influence:
 * smoothers, the coarsest grids and the ghosts beyond the inlet.
 *
 * The line relaxation takes a distributed change to press in its neighbours
 * only.  For the logarithm what is left out damps; where R falls steeply over a
 * mesh or two and is flat behind, as that of a soft layer as thick as a mesh
 * does, its sum changes sign and long waves grow by up to 56 a sweep.  So the
 * steps g_d = k_(d+1) - k_d of the band alone are held at
 *     g_d >= c_d g_(d-1),  c = .05, .3, .5, .6
 * where those of the logarithm fall by .44, .57, .70 and .78; the film and the
 * coarsest grids have K + R as it is.
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

/* Another part of R; false: there is no space for it. */
bool ovr_influence_add(ovr_influence *influence, ovr_influence_part part);

/* The influence of a node on one d mesh sizes away: dw_i/dP_j; R alone. */
double ovr_influence_at(const ovr_influence *influence, double d, double D);
double ovr_influence_rest(const ovr_influence *influence, double d, double D);

/* The same at 0..5 mesh sizes, as the line relaxation has it. */
void ovr_influence_band(const ovr_influence *influence, double D, double k[6]);

/* True if fourth order knows all of it; C of fourth_order.h, by the waves that
 * the mesh takes for longer ones,
 *     C = (1/2 pi^3) sum_n (-1)^(n+1) A(2 pi n/D)/n^3,
 * of linear pressures (1/4 pi^3) sum_n A(2 pi n/D)/n^3. */
bool ovr_influence_corrected(const ovr_influence *influence);
double ovr_influence_local(const ovr_influence *influence, double D);

#endif
