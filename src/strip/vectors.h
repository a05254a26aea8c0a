/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vectors across lines. */
#ifndef OVR_STRIP_VECTORS_H
#define OVR_STRIP_VECTORS_H

#include "multigrid/vector.h"
#include "strip/kernels.h"

/* Rows of a part without the first and the last of the grid. */
static inline ovr_part between_ends(const ovr_strip_grid *g, ovr_part rows)
{
    return (ovr_part){rows.from ? rows.from : 1,
                      rows.to < g->n ? rows.to : g->n - 1};
}

/* Mask of the elements of the vector at line j that are lines of the period. */
static inline ivec lines_before(size_t j, size_t lines)
{
    ivec lane;
    for (int l = 0; l < VEC; l++)
        lane[l] = (int64_t)j + l;
    return lane < (int64_t)lines - (ivec){0};
}

/* Elements 0, 2, 4 .. and 1, 3, 5 .. of two consecutive vectors. */
static inline vec evens(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
#elif VEC == 4
    return SHUFFLE(a, b, 0, 2, 4, 6);
#else
    return SHUFFLE(a, b, 0, 2);
#endif
}

static inline vec odds(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 1, 3, 5, 7, 9, 11, 13, 15);
#elif VEC == 4
    return SHUFFLE(a, b, 1, 3, 5, 7);
#else
    return SHUFFLE(a, b, 1, 3);
#endif
}

/* {a_0, b_0, a_1, b_1, ...}: the first and the second vector of it */
static inline vec woven_first(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
#elif VEC == 4
    return SHUFFLE(a, b, 0, 4, 1, 5);
#else
    return SHUFFLE(a, b, 0, 2);
#endif
}

static inline vec woven_second(vec a, vec b)
{
#if VEC == 8
    return SHUFFLE(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
#elif VEC == 4
    return SHUFFLE(a, b, 2, 6, 3, 7);
#else
    return SHUFFLE(a, b, 1, 3);
#endif
}

#endif
