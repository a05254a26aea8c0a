/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The nodes of a grid lie in memory in lanes, one for each element of the
 * machine's vectors. With V lanes of S nodes node i = s S + J is element s of
 * vector J, at J V + s:
 *
 *     vector   -2 -1 | 0    1    ... S-1  | S    S+1
 *     lane 0    .  . | 0    1    ... S-1  | S    S+1
 *     lane 1         | S    S+1  ... 2S-1 | 2S
 *     lane V-1       |               VS-1 | VS = n - 1
 *
 * A neighbour in space is the same element of the next vector, so stencils are
 * whole aligned vectors, coarsening stays within a lane, and the lanes are the
 * partitions of the band solver. Vectors before 0 and from S on (the halo) are
 * copies of values in the neighbouring lanes. In the first and last lane they
 * contain the values beyond the ends of the grid, and node n - 1.
 *
 * If V does not divide the grid, there are additional nodes after the last one,
 * where P = 0 and nothing is relaxed.  In one lane (V = 1, plain.h) node i is
 * at i.
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

/* OVR_HALO: number of halo vectors that are kept up to date on each side.
 * OVR_MAX_LANES: maximum number of lanes on any machine. */
enum { OVR_HALO = 2, OVR_MAX_LANES = 8 };

/* Index of node i in an array. */
static inline size_t ovr_lanes_place(const ovr_lanes *lanes, size_t i)
{
    /* NOLINTNEXTLINE(clang-analyzer-core.DivideZero): no lane is empty */
    size_t lane = i / lanes->S;
    if (lane == lanes->V) /* node n - 1, in the halo */
        lane--;
    return (i - lane * lanes->S) * lanes->V + lane;
}

/* True if node i is in a set of nodes. Bit s of byte J represents element s of
 * vector J. */
static inline bool ovr_lanes_has(const ovr_lanes *lanes,
                                 const unsigned char *set, size_t i)
{
    size_t place = ovr_lanes_place(lanes, i);
    return set[place / lanes->V] >> place % lanes->V & 1;
}

#endif
