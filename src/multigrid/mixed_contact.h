/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Mixed lubrication: the sum of fluid and asperity pressure, P = P_f + A(H).
 *
 *     H = H0 + gap - w(P)      the solids deform under the sum P
 *     Reynolds' equation for P_f, with lubricant properties at P_f
 *     P_f > 0: pressurized node; otherwise P_f = 0, and the row of the node is
 *              P - A(H) = 0 (dry contact)
 *     D sum P = force
 *
 * The law A(H) >= 0 decreases with H. It is the pressure carried, at the mean
 * gap H, by asperities finer than the grid or by a boundary layer. Field P of a
 * level contains P_f, and `asperity_P` contains P - P_f: A(H) at a pressurized
 * node, the result of the last correction at a cavitated node (A(H) when
 * solved).
 *
 * Newton's method with all derivatives, g = -dA/dH, k the elastic influence:
 *     dH = dH0 - k dP,   dP_f = dP + g dH in pressurized nodes, 0 elsewhere
 *     pressurized row i:  t_e = dN_i/dP_f of node e at fixed film; the entry
 *                 for -dN_i/dH_e is reduced by t_e g_e. A node that has just
 *                 become pressurized has P < P_f + A because of its former
 *                 state: the right-hand side is reduced by
 *                 t_e (P - A - P_f)_e, otherwise several steps are needed
 *     cavitated row i:  dP_i + g_i (dH0 - sum_j k dP_j) = A_i - P_i, divided
 *                 by 1 + g_i |k(0)| n
 *
 * During the iteration the film thickness is an additional unknown. In one step
 * it falls at most to a fifth, and A(H), which is nearly exponential, at most
 * doubles or grows to 0.05 p_h. The excess of the film thickness over H0 + gap
 * - w is called lift and is removed by the next step: dH = dH0 - k dP - lift. A
 * step that increases the residual much is reduced to a quarter, which can be
 * necessary with Eyring's sinh. A cavitated node stays cavitated until the
 * residual of its Reynolds equation with P_f = 0 would make P_f positive; the
 * sign of P - A would be decided by rounding.
 *
 * The finest grid is solved by Newton's method only (coarsest.h, tripoles.h),
 * in O(n log n) per step. The initial guess is the full-film solution of full
 * multigrid. At the ends of the film nodes become pressurized one by one. After
 * three such steps, 2, 4, ... 128 nodes on either side are assumed pressurized;
 * those with a negative result are cavitated, and the step is repeated.
 *
 * If the film ends far from where the initial guess ends it, Newton's method
 * may not converge, by chance of mesh size and data. Coarser grids then provide
 * the initial guess (physics/mixed/nested.h).
 */
#ifndef OVR_MULTIGRID_MIXED_CONTACT_H
#define OVR_MULTIGRID_MIXED_CONTACT_H

#include "multigrid/tripoles.h"

/* Asperity pressures below this value are set to zero, because an exponential
 * has no end. */
#define OVR_TOUCH_MIN 1e-9

/* Computes the deformation of a level from the total pressure; splits the
 * pressure into P_f and asperity pressure for the resulting film. */
void ovr_asperity_deform(const ovr_hierarchy *grids, const ovr_level *level);
void ovr_asperity_split(const ovr_hierarchy *grids, const ovr_level *level);

/* Returns the undeformed gap of a level plus lift, and resets the lift to zero.
 */
const double *ovr_asperity_gap(const ovr_hierarchy *grids,
                               const ovr_level *level);
void ovr_asperity_settle(ovr_hierarchy *grids);

/* D sum of |P - A| at cavitated nodes plus D sum of |lift|/H. */
double ovr_asperity_defect(const ovr_hierarchy *grids, const ovr_level *level);

/* Fraction of the load carried by the fluid; 1 without asperity contact model.
 */
double ovr_asperity_oil_share(const ovr_hierarchy *grids,
                              const ovr_level *level);

/* Prepares Newton's method, in the order of the nodes: computes A, g and the
 * total pressure of a level whose film is up to date. */
void ovr_asperity_prepare(const ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f);

/* Subtracts t_e and l_m of a pressurized row from e_m, m = -2..1, and removes
 * them from the columns of cavitated nodes. Adds to the right-hand side t_e
 * times the missing pressure of nodes that have just become pressurized. */
void ovr_asperity_pressurized_row(const ovr_hierarchy *grids,
                                  const ovr_level *level, size_t i,
                                  ovr_newton_row *row);

/* Assumes up to 128 nodes on either side of the film to be pressurized, if
 * cavitated nodes should have become pressurized in several consecutive steps.
 */
void ovr_asperity_open(ovr_hierarchy *grids, const ovr_level *level,
                       const ovr_fields *f);

/* Marks nodes as cavitated whose pressure the step would make negative. Returns
 * true if there were any; the step must then be computed again. */
bool ovr_asperity_close(const ovr_hierarchy *grids, const ovr_level *level,
                        const double *step);

/* The row of a cavitated node. */
ovr_newton_row ovr_asperity_cavitated_row(const ovr_hierarchy *grids,
                                          const ovr_level *level, size_t i);

/* Limits the pressure changes of the step. */
void ovr_asperity_limit(const ovr_asperity *touch, size_t n, double limit);

/* Applies a part of the step to the pressures, and computes w and lift from
 * them for the H0 already set. f is the state before the step. */
void ovr_asperity_advance(ovr_hierarchy *grids, const ovr_level *level,
                          const ovr_fields *f, double part);

/* Makes level l, the finest or one with memory for asperity contact, the finest
 * of the hierarchy. Coarser levels then have no asperity contact. */
void ovr_asperity_move(ovr_hierarchy *grids, int l);

/* Sets the asperity pressure of a level, and its deformation, to zero. */
void ovr_asperity_clear(const ovr_level *level);

/* Interpolates fluid and asperity pressure linearly; or, if `smooth`, by
 * cubics, except for the fluid pressure at the ends of the film. A new node is
 * pressurized if both neighbours are. */
void ovr_asperity_refine(ovr_hierarchy *grids, const ovr_level *coarse,
                         const ovr_level *fine, bool smooth);

#endif
