/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The elastic influence of a pressure: what of the deformation is whose.
 *
 *     w_i = sum_j (K_ij + R_ij) P_j - c P_i,   H_i = H0 + gap_i - w_i
 *
 * K is the logarithm of two half-spaces.  R is a smooth remainder, of any
 * number of parts, which MLMI sums with it (deformation.h).  c is the
 * compliance of what gives way only where it is pressed, a thin layer on a
 * foundation (Winkler).  They stand here for all who need a number of the
 * influence: smoothers, the coarsest grids and the ghosts beyond the inlet.
 */
#ifndef OVR_MULTIGRID_INFLUENCE_H
#define OVR_MULTIGRID_INFLUENCE_H

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"

enum { OVR_INFLUENCE_PARTS = 4 };

typedef struct ovr_influence {
    bool linear; /* pressure between nodes (deformation.h), else constant */
    double compliance; /* c, of H over P; the sum of all that give way so */
    ovr_influence_part part[OVR_INFLUENCE_PARTS]; /* R */
    int parts;
} ovr_influence;

/* Another part of R; false: there is no room for it. */
bool ovr_influence_add(ovr_influence *influence, ovr_influence_part part);

/* Whether there is more than the half-spaces. */
bool ovr_influence_more(const ovr_influence *influence);

/* Of a node on one d meshes away: dw_i/dP_j. */
double ovr_influence_at(const ovr_influence *influence, double d, double D);

/* w for the P of a level, in its lanes. */
void ovr_influence_deform(const ovr_influence *influence,
                          const ovr_kernels *run, const ovr_lanes *lanes,
                          const ovr_mlmi *mlmi, double *P, double *w);

#endif
