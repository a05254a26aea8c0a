/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Local Newton windows: Newton's method on the few nodes where the guess of a
 * step is far off.
 *
 * A pressure spike is one to four nodes wide.  Where roughness moves it by part
 * of a mesh, or lets it rise and fall where it stands, the extrapolated
 * pressure is off by tenths of p_h there.  eps goes with exp(-alphabar P), so
 * that sweeps gain a factor of e each; meanwhile the load that such nodes carry
 * too much shifts the film of all others by a per cent, and the end of the film
 * with it.
 *
 * A node stands out by the pressure that it lacks, about
 *     v_i = |r_i - (r_{i-3} + r_{i+3})/2| / (a0 |k(0)| + d_i),
 * d_i its outflow (reynolds.h).  Windows about the nodes that stand out most
 * are solved one after the other: all of the discrete equation, with the
 * pressure outside and H0 as they are and the film within following.  A window
 * is rejected unless its residual falls by a factor of five.
 */
#ifndef OVR_MULTIGRID_LOCAL_NEWTON_H
#define OVR_MULTIGRID_LOCAL_NEWTON_H

#include "multigrid/hierarchy.h"

/* Solves windows of a level whose film and residual are up to date; so they are
 * when it returns.  True if any window was solved. */
bool ovr_local_newton(const ovr_hierarchy *grids, ovr_level *level);

#endif
