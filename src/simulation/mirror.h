/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Reversal of rolling: entrainment speed um < 0, Cu = um/um0 < 0.
 *
 *     d/dX(eps dP/dX) - Cu dq/dX - dq/dT = 0,  film and force balance unchanged
 *
 * With X' = -X this is the same equation at |Cu|: the deformation kernel and
 * X^2/2 are even, and time is not affected. Therefore the grids contain the
 * mirror image while Cu < 0, node i' = n - 1 - i on a symmetric domain, and the
 * same scheme upwinds the wedge from the right. All other data are in the order
 * of the nodes along x: pressures and contents of the past, surfaces,
 * observations, output. At the time of reversal, where the wedge is zero, no
 * data are reordered; at Cu = 0 the orientation of the previous step is kept.
 *
 * The characteristic scheme has no wedge and does not use the mirror image: its
 * departure points are on the other side.
 */
#ifndef OVR_SIMULATION_MIRROR_H
#define OVR_SIMULATION_MIRROR_H

#include "simulation/internal.h"

/* Sets the sliding speed of the grids at T. */
void ovr_slide(ovr_simulation *sim, double T);

/* Copies n values along x from or to an array of a grid. */
void ovr_nodes_read(const ovr_simulation *sim, const ovr_level *level,
                    const double *values, double *along_x);
void ovr_nodes_write(const ovr_simulation *sim, const ovr_level *level,
                     const double *along_x, double *values);

/* to[i] = from[n - 1 - i] */
void ovr_mirror(size_t n, const double *from, double *to);

#endif
