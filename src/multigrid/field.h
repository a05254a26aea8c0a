/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays over the nodes of a grid: aligned, initialized to zero, with
 * OVR_FIELD_PAD zeros before the first and after the last node, so that
 * stencils and whole vectors may read beyond the ends. */
#ifndef OVR_MULTIGRID_FIELD_H
#define OVR_MULTIGRID_FIELD_H

#include <stdbool.h>
#include <stdint.h>

#include "base/arena.h"

enum { OVR_FIELD_PAD = 64, OVR_FIELD_PAGE = 512 };

/*
 * Offsets that avoid cache conflicts. A kernel reads about twenty arrays at
 * once. If element i of all of them has nearly the same address within a 4 kB
 * page, the arrays evict each other from the cache, and loads wait for
 * unrelated stores (three times slower on large grids). Therefore each array
 * starts 11 cache lines later in its page than the previous one. Small arrays
 * follow each other directly; each has a length of a multiple of a quarter page
 * plus three lines.
 */
static inline double *ovr_field(ovr_arena *arena, size_t n, ovr_error *err)
{
    bool large = n > 2 * OVR_FIELD_PAGE;
    size_t quarter = OVR_FIELD_PAGE / 4, minimum = n + 2 * OVR_FIELD_PAD;
    size_t capacity = large
                          ? minimum + OVR_FIELD_PAGE
                          : (minimum + quarter - 1) / quarter * quarter + 3 * 8;
    size_t target = arena->pieces * 11 * 8, page = OVR_FIELD_PAGE;
    double *all = ovr_arena_take(arena, capacity, sizeof(double), err);
    if (!all)
        return NULL;
    if (large)
        all += (target - (uintptr_t)all / sizeof(double)) % page;
    return all + OVR_FIELD_PAD;
}

/* Allocates several fields and stores them in the pointers of the list `to`,
 * which ends with NULL. */
static inline ovr_status ovr_fields_take(ovr_arena *arena, size_t n,
                                         ovr_error *err, double **const to[])
{
    for (; *to; to++)
        **to = ovr_field(arena, n, err);
    return ovr_arena_status(arena);
}
#define OVR_TAKE_FIELDS(arena, n, err, ...)                                    \
    ovr_fields_take(arena, n, err, (double **const[]){__VA_ARGS__, NULL})

/* Allocates a set of nodes (lanes.h) for any number of lanes, with halos. */
static inline unsigned char *ovr_set(ovr_arena *arena, size_t n, ovr_error *err)
{
    unsigned char *all = ovr_arena_take(arena, n + 2 * OVR_FIELD_PAD, 1, err);
    return all ? all + OVR_FIELD_PAD : NULL;
}

#endif
