/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Flow skewed by temperatures in the Reynolds equation: q s with s = (V/2)
 * m_1/m_0 (cross_film.h).
 *
 * Under the contact d/dX(q (1 + s)) is nearly zero.  If the wedge of q s is
 * computed from the previous film, a cycle computes q_n = c - s q_{n-1}.  The
 * iteration diverges for s > 1.  It oscillates for smaller s if s depends on P.
 * The wedge of q s is therefore part of the row on all grids, with q unknown
 * (multigrid/reynolds_row.h):
 *
 *     s = s_0 + s_1 P,  s_1 = max(0, ds/dP) at the temperatures `used`
 *     ds/dP = [s(ln eta_0(P + 1e-4)) - s(ln eta_0(P))]/1e-4
 *
 * by Roelands' law, where the ratios of viscosities depend on P.  With other
 * laws s does not depend on P.  An explicit s is stable where s falls with P.
 *
 * Short waves are filtered from s by 2 M^4 - M^8, where M is the mean (1, 2,
 * 1)/4 of neighbours.  Waves of 4, 8, 16 and 32 mesh sizes keep .12, .78, .98
 * and .999 of their amplitude, and the error is O(D^4).  The pressure response
 * to s is strongest for short waves, and s responds to the pressure
 * immediately. In the characteristic scheme nothing else damps waves of four
 * mesh sizes. Without the filter, a contact with slide-to-roll ratio 1.55 and
 * 1.2 GPa reached 2.2 GPa.
 *
 * With opposite sliding, one surface carries temperature changes at the film
 * end upstream. If the phase of the last node alternates, the iteration does
 * not converge.  The ratio s is therefore constant from 2 mesh sizes before the
 * end x_e = x_i + D P_i/(P_{i-1} - 2 P_i) on, with i the last pressurized node.
 * The heat source of that node is multiplied by the fraction of its grid
 * interval that is inside the film (columns.c). With mass-conserving
 * cavitation, s falls to zero over the last 0.005 p_h instead.
 *
 * In the characteristic scheme with reversed speed, the grids are not mirrored
 * and rows contain no upstream nodes. Only in this case the wedge of q s is a
 * right-hand side, computed from the content after each cycle.
 */
#ifndef OVR_PHYSICS_HEAT_SKEW_H
#define OVR_PHYSICS_HEAT_SKEW_H

#include <stdbool.h>

#include "simulation/internal.h"

/* Allocates s on all grids. */
ovr_status ovr_heat_skew_take(ovr_simulation *sim, ovr_error *err);

/* Sets s = 0. */
void ovr_heat_skew_forget(ovr_simulation *sim);

/* Computes s from (V/2) m_1/m_0 q of the film last read. */
void ovr_heat_skew_find(ovr_simulation *sim);

/* Writes s to all grids, and the right-hand side to the finest one. */
void ovr_heat_skew_give(ovr_simulation *sim);

/* Computes q s for the film last read. Returns true if the right-hand side
 * changes. */
bool ovr_heat_skew_follow(ovr_simulation *sim);

/* Finds the last node with P > 0. Returns the fraction of the grid interval
 * downstream of it that is within the film, or -1 if no film ends inside the
 * grid. */
double ovr_heat_film_end(const ovr_simulation *sim, ptrdiff_t *last);

/* Returns true if the surfaces move in opposite directions. */
bool ovr_heat_opposed(const ovr_simulation *sim);

#endif
