/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Values at the departure points of paths: the material at a node was several
 * mesh sizes upstream one step ago.
 *
 * All points of a surface move alike: Lagrange's cubic through four nodes is
 * used, which is exact for shifts by whole mesh sizes.  Each layer of the film
 * has its own speed: linear interpolation between two nodes, which makes no new
 * extremes.  At the inlet zero enters (a rise of 0); beyond the outlet values
 * are those at the end.
 */
#ifndef OVR_MULTIGRID_DEPARTURES_H
#define OVR_MULTIGRID_DEPARTURES_H

#include <stddef.h>

/* The departure points of a surface: node i takes c[0..3] of the nodes from i +
 * first on, all of them there for `from` <= i < `to`. */
typedef struct ovr_departures {
    size_t n, from, to;
    ptrdiff_t first;
    double meshes, c[4];
} ovr_departures;

ovr_departures ovr_departures_of(size_t n, double meshes);

/* v at the departure point of node i, wherever that is. */
double ovr_departures_at(const ovr_departures *departures, const double *v,
                         size_t i);

/* Interpolates v at the departure points of all nodes. */
void ovr_carry_along(const ovr_departures *departures, const double *v,
                     double *to);

/* Interpolates v at i - meshes (in mesh sizes) for all nodes i. */
void ovr_departures_cubic(size_t n, const double *v, double meshes,
                          double *at_departures);

/* Interpolates v at i - meshes for one node. */
double ovr_departure_linear(size_t n, const double *v, size_t i, double meshes);

/* Interpolates v at i - meshes u_i for all nodes i of a layer of the film. The
 * value beyond both ends is 0. */
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
