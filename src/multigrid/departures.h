/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Interpolation at departure points: where the material that is at a node now
 * was one time step ago, several mesh sizes upstream.
 *
 * All points of a surface have the same speed: Lagrange's cubic interpolation
 * is used, which is exact for shifts by whole mesh sizes. Layers of the film
 * have different speeds: interpolation between two nodes is linear and creates
 * no new extrema. Values upstream of the inlet are 0 (temperature rise); values
 * beyond the outlet are those at the outlet.
 */
#ifndef OVR_MULTIGRID_DEPARTURES_H
#define OVR_MULTIGRID_DEPARTURES_H

#include <stddef.h>

/* Departure points of a surface: the value for node i is the sum of c[0..3]
 * times the values of the nodes i + first to i + first + 3. All these nodes
 * exist for `from` <= i < `to`. */
typedef struct ovr_departures {
    size_t n, from, to;
    ptrdiff_t first;
    double meshes, c[4];
} ovr_departures;

ovr_departures ovr_departures_of(size_t n, double meshes);

/* v at the departure point of node i, also outside the grid. */
double ovr_departures_at(const ovr_departures *departures, const double *v,
                         size_t i);

/* Interpolates v at the departure points of all nodes. */
void ovr_carry_along(const ovr_departures *f, const double *v, double *to);

/* Interpolates v at the departure points of a layer of the film: u_i times a
 * number of mesh sizes upstream of each node i. Beyond both ends v is 0. */
void ovr_film_departures(size_t n, double meshes, const double *u,
                         const double *v, double *at_departures);

/* Lagrange's cubic at s in [0, 1) of the middle of four nodes. */
static inline void ovr_cubic_weights(double s, double c[4])
{
    c[0] = -s * (s - 1) * (s - 2) / 6;
    c[1] = (s + 1) * (s - 1) * (s - 2) / 2;
    c[2] = -(s + 1) * s * (s - 2) / 2;
    c[3] = (s + 1) * s * (s - 1) / 6;
}

#endif
