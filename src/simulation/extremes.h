/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds where a curve is smallest and largest between its nodes, and which of
 * its maxima stand out. */
#ifndef OVR_SIMULATION_EXTREMES_H
#define OVR_SIMULATION_EXTREMES_H

#include <stdbool.h>
#include <stddef.h>

/* A maximum stands out when it is more than this above the lowest value
 * between it and the maximum before it (in ph). */
#define OVR_PROMINENCE 1e-3

/* The vertex of the parabola through nodes i-1, i, i+1, node i being an
 * extreme: its place, and *value.  Where the vertex
 * would be further than a mesh away, or differ from the node by more than 5 %
 * of the node's value, the mesh does not carry it: the node itself. */
double ovr_vertex(const double *X, const double *v, size_t i, double *value);

/* Returns whether the mesh resolves the maximum of v at node i: on average, the
 * values two nodes away are at least two thirds of it.  The pressure of a
 * Newtonian film at a surface feature is singular like the logarithm of the
 * distance; there, the ratio is about a half on any mesh. */
bool ovr_maximum_is_resolved(size_t n, const double *v, size_t i);

/* The number of maxima that stand out; *last is the last of them.  Of those
 * that do not stand out from each other the highest is taken. */
int ovr_prominent_maxima(size_t n, const double *P, size_t *last);

#endif
