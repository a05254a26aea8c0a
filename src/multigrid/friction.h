/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Shear stress across the film, at half nodes, and friction: its integrals.
 *
 * Stresses in units ph b/R, u in um, z from surface 1 to surface 2, s = -1..1.
 * With V = (u1 - u2)/um and t the mean over the film,
 *     tau(s) = t + s H P_X/2
 *     Newtonian: t = -(lambda/12) V eta/H = -(V/12) rho H^2/eps
 *     Eyring (flow.h): t = -sgn(V) Sigma0 asinh(B(g) c/eps)
 *     at a limit: |t| <= max(0, Lambda P/(b/R) - |H P_X|/2)
 *
 *     at i + 1/2:  D P_X = P_{i+1} - P_i
 *                  H, rho: means of the nodes i and i + 1; rho H^2/eps by
 *                  their sums, or by the gap (faces.h)
 *
 * Force on a surface per unit width (ph b^2/R), power (um ph b^2/R):
 *     F_slide = int t dX,  F_roll = int H P_X/2 dX
 *     F_1 = F_slide - F_roll,  F_2 = -F_slide - F_roll
 *     dissipation of the Poiseuille flow = int (E/rho) P_X^2 dX, E of
 *         the flow law, Newtonian eps: 2 F_roll in any steady film
 * The integrals include half nodes next to a pressurized node; the drag of
 * streamers in the cavitated film is below 1e-4 of the total. Second order in
 * D.
 */
#ifndef OVR_MULTIGRID_FRICTION_H
#define OVR_MULTIGRID_FRICTION_H

#include <stddef.h>

/* Values of a film, in the order of the nodes. */
typedef struct ovr_sheared {
    size_t n;
    const double *X, *P, *H, *q;
    const double *eps, *flow; /* 2 E at half nodes; NULL: Newtonian */
} ovr_sheared;

typedef struct ovr_friction {
    double slide, roll; /* F_slide, F_roll */
    double poiseuille;  /* power dissipated by the Poiseuille flow */
} ovr_friction;

#endif
