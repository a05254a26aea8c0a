/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mass-conserving cavitation: film rupture, transport of lubricant in the
 * cavitated region and film reformation (Jakobsson, Floberg and Olsson).
 *
 *     d/dX(eps dP/dX) - Cu dq/dX - dq/dT = 0,   q = theta rho H,
 *     P >= 0,   0 <= theta <= 1,   P (1 - theta) = 0
 *
 * A node has one unknown: P if it is pressurized (theta = 1), the lubricant
 * content q if it is cavitated (P = 0). Rows of cavitated nodes are part of the
 * banded system of the line relaxation, which solves the transport by marching
 * downstream.
 *
 * Outflow of cell i by Cu, and content in time, kappa = s/(1 + s), s =
 * dT/dT_old:
 *     Q_{i+1/2} = 1.5 q_i - 0.5 q_{i-1}      A_i = (1 + kappa) q_i - kappa
 *                                                  q_i^{k-1}
 * which is the wedge scheme upstream2 with BDF2, written as fluxes. In
 * cavitated cells they are limited, because q would otherwise become negative
 * downstream of a withdrawing meniscus:
 *     Q = max(Q, q_i/2),   A = max(A, q_i/2)
 * Both are continuous and increasing in q_i, and no flow leaves an empty cell.
 * With backward Euler and upstream1 nothing is limited.  Then
 *     N_i = (diffusion) - a0 q_i - a1 q_{i-1} - a2 q_{i-2},  in row 1 + source
 *     a0 = c o0_i + (cT, or 1/(2 dT)),  a1 = c (o1_i - o0_{i-1}),
 *     a2 = -c o1_{i-1},   c = Cu/D,  (o0, o1) = (1.5, -0.5), limited (0.5, 0)
 *     r = F - N = 0,  in rows that are limited in time F + kappa q^{k-1}/dT
 *
 * Inlet.  Open (flooded): q_0 = rho H_0, row 1 of first order as in reynolds.h.
 * Closed (limited supply): a0 = c o0 + cT, a1 = c o1, source = Cu q_f/D, and no
 * Poiseuille flow in its first face (eps_0 = -eps_1): with Poiseuille flow in
 * that face, the boundary condition P_0 = 0 would flood the contact whatever
 * the supply.  The inlet of a coarse level is closed if its node 1 is cavitated
 * at the start of a cycle.
 *
 * Conservation is an identity: the sum of D times rows 1..n-2 telescopes to
 * inflow - outflow - D sum (A - B)/dT, so that the mass error of a step is D
 * times the sum of its residuals, and R = D sum |r_i|/H_cen measures it.
 *
 * Line relaxation.  Columns of pressurized nodes are those of line.h, but the q
 * of cavitated nodes does not follow their film, and changes are not
 * distributed to a cavitated neighbour; column j of a cavitated node is -a0,
 * -a1, -a2 in rows j, j + 1, j + 2.  Then a pressurized node whose P falls to
 * zero becomes cavitated, with q = rho H after the film update; a cavitated
 * node with q > rho H becomes pressurized. The sign of the residual decides the
 * phase of nodes with P = 0 and q = rho H.
 *
 * Between grids: states, q of cavitated nodes and limits are injected;
 * residuals are restricted by full weighting, also at cavitated nodes;
 * corrections are added at pressurized nodes only.
 *
 * Source: Jakobsson and Floberg 1957, Olsson 1965; one unknown a node after
 * Elrod 1981, but without compressibility of the full film.
 */
#ifndef OVR_MULTIGRID_CONTENT_H
#define OVR_MULTIGRID_CONTENT_H

#include "multigrid/hierarchy.h"

/* Halo of node sets in vectors: the half width of the band. */
enum { OVR_CONTENT_HALO = 3 };

/* Sets the phases from the pressure alone: pressurized where P > 0. Other nodes
 * are cavitated and keep their content. */
void ovr_content_by_pressure(const ovr_hierarchy *grids, ovr_level *level);

/* Opens or closes the inlet of a level. A closed inlet has the source term
 * `source` = Cu q_f/D and q_0 = supply. */
void ovr_content_open(ovr_level *level);
void ovr_content_close(ovr_level *level, double source, double supply);

/* Updates content and phase of the nodes after a change of the film. On the
 * finest level of a run, also opens the inlet if its first node is pressurized,
 * and sets the flux limiters again. */
void ovr_content_settle(const ovr_hierarchy *grids, ovr_level *level);

/* Restricts contents, phases and the weighted residual of the next finer level.
 */
void ovr_content_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                          ovr_level *coarse, double *residual);

/* Interpolates contents and phases to the next finer level in full multigrid,
 * where P has already been interpolated. */
void ovr_content_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                        ovr_level *fine);

/* Marks nodes with P > 0 as pressurized (P in the order of the nodes). No node
 * is marked as cavitated. */
void ovr_content_wet(ovr_level *level, const double *P);

/* Sets of nodes: sets one node, or copies a level's set to the order of the
 * nodes.
 */
void ovr_content_mark(const ovr_level *level, unsigned char *set, size_t i,
                      bool in);
void ovr_content_read(const ovr_level *level, const unsigned char *set,
                      unsigned char *ordered);

/* One sweep of the line relaxation. */
void ovr_content_relax(ovr_hierarchy *grids, ovr_level *level, double limit);

#endif
