/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Copies from the order of the nodes to lanes (lanes.h) and back: tiles of V x
 * V values are transposed in registers. */
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Start of the tile at J; the last tile overlaps the one before. Lanes shorter
 * than a vector have one tile, of which a part is used. */
static inline size_t tile_start(size_t J, size_t S)
{
    return J + VEC <= S || S < VEC ? J : S - VEC;
}

/* Copies nodes 0..V S-1 to lanes. */
static void pack_tiles(size_t S, const double *from, double *to)
{
    size_t used = S < VEC ? S : VEC;
    for (size_t J = 0; J < S; J += VEC) {
        size_t start = tile_start(J, S);
        vec tile[VEC];
        for (size_t l = 0; l < VEC; l++)
            tile[l] = load(from + l * S + start);
        transpose(tile);
        for (size_t k = 0; k < used; k++)
            store(to + (start + k) * VEC, tile[k]);
    }
}

/* Copies lanes in order: values written beyond the end of a lane are
 * overwritten by the next lane. */
static void unpack_tiles(size_t S, const double *from, double *to)
{
    for (size_t J = 0; J < S; J += VEC) {
        size_t start = tile_start(J, S);
        vec tile[VEC];
        for (size_t k = 0; k < VEC; k++)
            tile[k] = load(from + (start + k) * VEC);
        transpose(tile);
        for (size_t l = 0; l < VEC; l++)
            store(to + l * S + start, tile[l]);
    }
}

/* True if tiles can be used: the last one extends at most one node beyond the
 * lanes. */
static bool has_tiles(const ovr_lanes *g)
{
    return g->S + 1 >= VEC && g->S * VEC + 1 == g->n;
}

void OVR_KERNEL(pack)(const ovr_lanes *g, const double *from, double *to)
{
    size_t last = g->n - 1;
    if (has_tiles(g))
        pack_tiles(g->S, from, to);
    for (size_t i = has_tiles(g) ? last : 0; i <= last; i++)
        to[ovr_lanes_place(g, i)] = from[i];
    repeat_ends(to, (ptrdiff_t)g->S, OVR_HALO);
}

void OVR_KERNEL(unpack)(const ovr_lanes *g, const double *from, double *to)
{
    size_t last = g->n - 1;
    if (has_tiles(g))
        unpack_tiles(g->S, from, to);
    for (size_t i = has_tiles(g) ? last : 0; i <= last; i++)
        to[i] = from[ovr_lanes_place(g, i)];
}
