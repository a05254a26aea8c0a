/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Local Newton solves at the few nodes where the initial guess of a time step
 * is poor.
 *
 * A pressure spike is one to four nodes wide.  If roughness moves it by a
 * fraction of D, or changes its height, the extrapolated pressure is wrong by
 * tenths of p_h.  Because eps ~ exp(-alphabar P), relaxation reduces such an
 * error only by a factor e per sweep.  Meanwhile the excess load at these nodes
 * changes the film thickness elsewhere by about one per cent and shifts the
 * cavitation boundary.
 *
 * Nodes are ranked by the estimated pressure error
 *     v_i = |r_i - (r_{i-3} + r_{i+3})/2| / (a0 |k(0)| + d_i),
 * where d_i is the outflow coefficient (reynolds.h).  Windows around the worst
 * nodes are solved one after another with the full discrete equation.  H0 and
 * the pressure outside the window are fixed; the film thickness inside follows
 * the pressure.  A window is rejected unless its residual falls by a factor of
 * five.
 *
 * Works with rheological models, with heat (temperatures are fixed during a
 * cycle) and with mass-conserving cavitation (only windows in the full film).
 */
#ifndef OVR_MULTIGRID_LOCAL_NEWTON_H
#define OVR_MULTIGRID_LOCAL_NEWTON_H

#include "multigrid/hierarchy.h"

/* Solves windows of a level. Film and residual must be up to date before the
 * call and are up to date after it. Returns true if any window was solved. */
bool ovr_local_newton(const ovr_hierarchy *grids, ovr_level *level);

#endif
