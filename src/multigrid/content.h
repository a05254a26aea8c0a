/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mass-conserving cavitation: the film that ruptures, carries what is left of
 * it, and closes again (Jakobsson, Floberg and Olsson).
 *
 *     d/dX(eps dP/dX) - Cu dq/dX - dq/dT = 0,   q = theta rho H,
 *     P >= 0,   0 <= theta <= 1,   P (1 - theta) = 0
 *
 * A node has one unknown: P where it is wet (theta = 1), the oil content q
 * where it is dry (P = 0).  Dry rows are rows as all others, and the band
 * solver of the line relaxation marches the transport in them.
 *
 * Outflow of cell i by Cu, and content in time, kappa = s/(1 + s), s =
 * dT/dT_old:
 *     Q_{i+1/2} = 1.5 q_i - 0.5 q_{i-1}      A_i = (1 + kappa) q_i - kappa
 *                                                  q_i^{k-1}
 * which is the wedge upstream2 with BDF2, written as fluxes.  In dry cells
 * they are limited, or q would be negative behind a meniscus that withdraws:
 *     Q = max(Q, q_i/2),   A = max(A, q_i/2)
 * Either is continuous and increasing in q_i and takes nothing from where
 * nothing is.  With backward Euler and upstream1 nothing is limited.  Then
 *     N_i = (diffusion) - a0 q_i - a1 q_{i-1} - a2 q_{i-2},  in row 1 + source
 *     a0 = c o0_i + (cT, or 1/(2 dT)),  a1 = c (o1_i - o0_{i-1}),
 *     a2 = -c o1_{i-1},   c = Cu/D,  (o0, o1) = (1.5, -0.5), limited (0.5, 0)
 *     r = F - N = 0,  in rows that are limited in time F + kappa q^{k-1}/dT
 *
 * Inlet.  Open (flooded): q_0 = rho H_0, row 1 of first order as in
 * reynolds.h.  Closed (a film arrives): a0 = c o0 + cT, a1 = c o1, source =
 * Cu q_f/D, and no Poiseuille flow in its first face (eps_0 = -eps_1): with it
 * a contact is flooded through P_0 = 0 whatever arrives.  The inlet of a coarse
 * level is closed if its node 1 is cavitated at the start of a cycle.
 *
 * Conservation is an identity: the sum of D times rows 1..n-2 telescopes to
 * inflow - outflow - D sum (A - B)/dT, so that the loss in a step is D times
 * the sum of its residuals, and R = D sum |r_i|/H_cen measures it.
 *
 * Line relaxation.  Columns of pressurized nodes are those of line.h, but the
 * q of cavitated nodes does not follow their film, and nothing is shared with
 * a cavitated neighbour; column j of a cavitated node is -a0, -a1, -a2 in rows
 * j, j + 1, j + 2.  Then a pressurized node whose P falls to zero is dried,
 * with q = rho H once the film is made; a dry one with q > rho H becomes wet.
 * Nodes on the kink (P = 0, q = rho H) take the side that their residual asks
 * for.
 *
 * Between grids: states, q of cavitated nodes and limits are injected;
 * residuals are weighted fully, dry ones too; corrections enter pressurized
 * nodes only.
 *
 * Source: Jakobsson and Floberg 1957, Olsson 1965; one unknown a node after
 * Elrod 1981, without his compressible film.
 */
#ifndef OVR_MULTIGRID_CONTENT_H
#define OVR_MULTIGRID_CONTENT_H

#include "multigrid/hierarchy.h"

/* Halo of sets, in vectors: what the band reaches. */
enum { OVR_CONTENT_HALO = 3 };

/* Decides states by the pressure alone: wet where P > 0, elsewhere dry with the
 * content that is there. */
void ovr_content_by_pressure(const ovr_hierarchy *grids, ovr_level *level);

/* Opens or closes the inlet of a level; a closed one takes `source` = Cu q_f/D
 * in and has q_0 = supply. */
void ovr_content_open(ovr_level *level);
void ovr_content_close(ovr_level *level, double source, double supply);

/* Follows the film: content and state of the nodes; on the finest level of a
 * run an inlet opens when its first node is pressurized, and limits are set
 * again. */
void ovr_content_settle(const ovr_hierarchy *grids, ovr_level *level);

/* Contents, states and the weighted residual of the level above. */
void ovr_content_restrict(ovr_hierarchy *grids, const ovr_level *fine,
                          ovr_level *coarse, double *residual);

/* Contents and states of the next finer level in full multigrid, whose P has
 * been interpolated. */
void ovr_content_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                        ovr_level *fine);

/* Wet where P > 0, P in the order of the nodes; nothing is dried. */
void ovr_content_wet(ovr_level *level, const double *P);

/* Sets of nodes: one node, all of a level to the order of the nodes. */
void ovr_content_mark(const ovr_level *level, unsigned char *set, size_t i,
                      bool in);
void ovr_content_read(const ovr_level *level, const unsigned char *set,
                      unsigned char *ordered);

/* One sweep of the line relaxation. */
void ovr_content_relax(ovr_hierarchy *grids, ovr_level *level, double limit);

#endif
