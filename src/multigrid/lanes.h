/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The nodes of a grid lie in memory in lanes, one for each element of the
 * machine's vectors.
 * With V lanes of S nodes node i = s S + J is element s of vector J, at J V +
 * s:
 *
 *     vector   -2 -1 | 0    1    ... S-1  | S    S+1
 *     lane 0    .  . | 0    1    ... S-1  | S    S+1
 *     lane 1         | S    S+1  ... 2S-1 | 2S
 *     lane V-1       |               VS-1 | VS = n - 1
 *
 * A neighbour in space is the same element of the next vector, so stencils
 * are whole aligned vectors, coarsening stays within a lane, and the band
 * solver finds its partitions ready.  Vectors before 0 and from S on, the
 * halo, repeat what the neighbouring lanes hold; the first and the last lane
 * have there what lies beyond the ends of the grid, and node n - 1.
 *
 * A grid that V does not divide has lanes that are longer in sum, and nodes
 * beyond its last one, where P = 0 and nothing is relaxed.  In one lane (V = 1,
 * plain.h) node i is at i.
 */
#ifndef OVR_MULTIGRID_LANES_H
#define OVR_MULTIGRID_LANES_H

#include <stdbool.h>
#include <stddef.h>

typedef struct ovr_lanes {
    size_t n; /* nodes */
    size_t S; /* nodes a lane */
    size_t V; /* lanes */
} ovr_lanes;

/* OVR_HALO: vectors of a field's halo that are kept up to date on both sides.
 * OVR_MAX_LANES: of any machine. */
enum { OVR_HALO = 2, OVR_MAX_LANES = 8 };

/* The place of node i. */
static inline size_t ovr_lanes_place(const ovr_lanes *lanes, size_t i)
{
    /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): no lane is empty */
    size_t lane = i / lanes->S;
    if (lane == lanes->V) /* node n - 1, in the halo */
        lane--;
    return (i - lane * lanes->S) * lanes->V + lane;
}

/* True if node i is in a set of nodes: bit s of byte J is element s of vector
 * J. */
static inline bool ovr_lanes_has(const ovr_lanes *lanes,
                                 const unsigned char *set, size_t i)
{
    size_t place = ovr_lanes_place(lanes, i);
    return set[place / lanes->V] >> place % lanes->V & 1;
}

#endif
