/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reversal: a mean speed um below zero, Cu = um/um0 < 0.
 *
 *     d/dX(eps dP/dX) - Cu dq/dX - dq/dT = 0,  film and force balance as ever
 *
 * With X' = -X this is the same equation at |Cu|: the kernel of the
 * deformation and X^2/2 are even, and time does not see X.  So the grids hold
 * the mirror image while Cu < 0, node i' = n - 1 - i on a domain that is
 * symmetric, and the wedge is upwinded from the right by what upwinds it from
 * the left.  All else is in the order of the nodes along x: pressures and
 * contents of the past, surfaces, what is observed and written.  Nothing is
 * turned at the instant of reversal, where the wedge goes through zero; at
 * Cu = 0 the side stays that of the step before.
 *
 * Along the characteristic there is no wedge and nothing is mirrored: its
 * departure points lie on the other side.
 */
#ifndef OVR_SIMULATION_MIRROR_H
#define OVR_SIMULATION_MIRROR_H

#include "simulation/internal.h"

/* The grids' sliding speed at T. */
void ovr_slide(ovr_simulation *sim, double T);

/* n values along x to or from one of a grid's arrays. */
void ovr_nodes_read(const ovr_simulation *sim, const ovr_level *level,
                    const double *values, double *along_x);
void ovr_nodes_write(const ovr_simulation *sim, const ovr_level *level,
                     const double *along_x, double *values);

/* to[i] = from[n - 1 - i] */
void ovr_mirror(size_t n, const double *from, double *to);

#endif
