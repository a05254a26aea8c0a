/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The flow that temperatures skew, q s with s = (V/2) m_1/m_0 (cross_film.h),
 * in Reynolds' equation.
 *
 * Under the contact d/dX(q (1 + s)) is nearly zero.  With the wedge of q s on
 * the right-hand side, by the film before, a cycle makes q_n = c - s q_{n-1}:
 * it diverges for s > 1, and goes round in two films below that if s follows
 * the pressure.  The wedge of q s is therefore a part of the row, with q
 * unknown, on all grids (multigrid/reynolds_row.h):
 *
 *     s = s_0 + s_1 P,  s_1 = max(0, ds/dP) at the temperatures `used`
 *     ds/dP = (V/2) [sum w r' zeta - (m_1/m_0) sum w r']/m_0 d ln eta/dP
 *     ln r_j = (th_m - th_j)(ln eta_0 + C),  r'_j = r_j (th_m - th_j)
 *
 * by Roelands' law; by other laws s does not depend on P.  Where s falls with P
 * an explicit s is stable.
 *
 * Short waves are taken out of s, by 2 M^4 - M^8 with M the mean (1, 2, 1)/4 of
 * neighbours: of waves of 4, 8, 16 and 32 mesh sizes .12, .78, .98 and .999 are
 * left; the error is O(D^4).  s follows P at once through the viscosities, and
 * P answers to s the more the shorter a wave is.  Along the characteristic
 * nothing else damps waves of four or five mesh sizes: with them a contact at a
 * slip of 1.55 and 1.2 GPa took 31 cycles a step and reached 2.2 GPa, without
 * them 5 and 1.18 GPa.
 *
 * Where surfaces move in opposite directions, surface 2 carries whatever
 * happens at the film's end upstream, and a last node that is wet in one
 * iteration and dry in the next keeps the iterations from ending.  s is then
 * constant from 2 mesh sizes before the end, x_e = x_i + D P_i/(P_{i-1} - 2
 * P_i) with i the last wet node, and the last node is heated by the share of
 * its mesh that the film covers (heat_film.c).  With mass-conserving
 * cavitation, s falls to zero over the last 0.005 p_h instead.
 *
 * Along the characteristic with the speed reversed, grids are not mirrored and
 * rows have no nodes upstream: there alone the wedge of q s remains on the
 * right-hand side, by the content of each cycle.
 */
#ifndef OVR_SIMULATION_HEAT_SKEW_H
#define OVR_SIMULATION_HEAT_SKEW_H

#include <stdbool.h>

#include "simulation/internal.h"

/* Takes memory for s on all grids. */
ovr_status ovr_heat_skew_take(ovr_simulation *sim, ovr_error *err);

/* s = 0 */
void ovr_heat_skew_forget(ovr_simulation *sim);

/* Computes s from (V/2) m_1/m_0 q of the film that was read last. */
void ovr_heat_skew_find(ovr_simulation *sim);

/* Writes s to all grids, and the right-hand side of the finest one. */
void ovr_heat_skew_give(ovr_simulation *sim);

/* Computes q s for the film that was read last; returns true if the right-hand
 * side changes by it. */
bool ovr_heat_skew_follow(ovr_simulation *sim);

/* Returns the share of the mesh behind the film's last wet node, *last, that
 * the film covers; a negative one if there is no such end within the grid. */
double ovr_heat_film_end(const ovr_simulation *sim, ptrdiff_t *last);

/* Returns true if the surfaces move in opposite directions. */
bool ovr_heat_opposed(const ovr_simulation *sim);

#endif
