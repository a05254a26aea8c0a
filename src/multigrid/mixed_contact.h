/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Surfaces in asperity contact through their film: P = P_f + A(H).
 *
 *     H = H0 + gap - w(P)      the solids feel the whole pressure P
 *     Reynolds' equation in P_f, its oil's properties those of P_f
 *     P_f > 0: wet; else P_f = 0, and the row is P - A(H) = 0: dry contact
 *     D sum P = force
 *
 * A law A(H) >= 0 falls with H: the pressure carried, at the mean gap H, by
 * asperities finer than the grid or by a boundary layer.  A level has P_f in
 * its field P, and P - P_f in `borne`: in a pressurized node A(H), in a dry one
 * what the last correction left there, A(H) when it is solved.
 *
 * Newton's method with all derivatives, g = -dA/dH, k the elastic influence:
 *     dH = dH0 - k dP,   dP_f = dP + g dH in pressurized nodes, 0 in dry ones
 *     wet row i:  t_e = dN_i/dP_f of node e at fixed film; the entry
 *                 for -dN_i/dH_e is less by t_e g_e
 *                 a node that has just turned wet has P < P_f + A, as its
 *                 state was another: the right-hand side is less by t_e
 *                 (P - A - P_f)_e, otherwise several steps are needed
 *     dry row i:  dP_i + g_i (dH0 - sum_j k dP_j) = A_i - P_i, divided by
 *                 1 + g_i |k(0)| n
 * In the iteration a film is an unknown of its own: it falls at most to a
 * fifth in a step, nor so far that its A, an exponential that a tangent does
 * not represent, grows beyond twice itself, or a twentieth of ph where
 * it was less.  What it is then above H0 + gap - w is its lift, which the next
 * step takes back: dH = dH0 - k dP - lift.  A step that makes much more of the
 * residual is taken to a quarter, as those of Eyring's sinh may.  A node that
 * is dry stays so until its row of Reynolds' equation, with P_f = 0, wants to
 * rise: judged by the sign of P - A it would flip by rounding.
 *
 * The finest grid is solved by Newton's method alone (coarsest.h, tripoles.h),
 * in O(n log n) a step; its film begins with that of surfaces apart, by full
 * multigrid.  At the ends of the film nodes become pressurized one by one.
 * After three such steps, 2, 4, ... 128 nodes on either side are assumed
 * pressurized; those with a negative result are cavitated, and the step is
 * repeated.
 */
#ifndef OVR_MULTIGRID_MIXED_CONTACT_H
#define OVR_MULTIGRID_MIXED_CONTACT_H

#include "multigrid/tripoles.h"

/* Pressures below this are none: an exponential never ends. */
#define OVR_TOUCH_MIN 1e-9

/* The deformation of a level by the whole pressure; P_f and what is borne
 * beside it by the film that this makes. */
void ovr_asperity_deform(const ovr_hierarchy *grids, const ovr_level *level);
void ovr_asperity_split(const ovr_hierarchy *grids, const ovr_level *level);

/* The undeformed gap of a level with its films' lift; no lift from now on. */
const double *ovr_asperity_gap(const ovr_hierarchy *grids,
                               const ovr_level *level);
void ovr_asperity_settle(ovr_hierarchy *grids);

/* D sum |P - A| of cavitated nodes, and of |lift|/H. */
double ovr_asperity_defect(const ovr_hierarchy *grids, const ovr_level *level);

/* Computes the share of the load that the oil carries; 1 without a law. */
double ovr_asperity_oil_share(const ovr_hierarchy *grids,
                              const ovr_level *level);

/* Prepares for Newton's method, in the order of the nodes: A, g and the whole
 * pressure of a level whose film is up to date. */
void ovr_asperity_prepare(const ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f);

/* Subtracts t_e and l_m of a pressurized row from e_m, m = -2..1, and out of
 * the columns of cavitated nodes; its right-hand side gets t_e times what nodes
 * that have just turned wet lack. */
void ovr_asperity_pressurized_row(const ovr_hierarchy *grids,
                                  const ovr_level *level, size_t i,
                                  ovr_newton_row *row);

/* Where cavitated nodes want to rise in step after step, as the film ends
 * elsewhere: up to 128 on either side of them are taken for wet. */
void ovr_asperity_open(ovr_hierarchy *grids, const ovr_level *level,
                       const ovr_fields *f);

/* Those that a step would press below zero are dry; whether there were any, so
 * that the step is to be found again. */
bool ovr_asperity_close(const ovr_hierarchy *grids, const ovr_level *level,
                        const double *step);

/* A cavitated node's row. */
ovr_newton_row ovr_asperity_cavitated_row(const ovr_hierarchy *grids,
                                          const ovr_level *level, size_t i);

/* No change of a pressure in the step beyond a limit. */
void ovr_asperity_limit(const ovr_asperity *touch, size_t n, double limit);

/* The pressures after a part of the step, and by them, its H0 being set, w and
 * lift; f as it was before the step. */
void ovr_asperity_advance(ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f, double part);

#endif
