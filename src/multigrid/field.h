/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays over the nodes of a grid: aligned, zero, with OVR_FIELD_PAD zeros
 * before the first and after the last, so that stencils and whole vectors may
 * reach over the ends. */
#ifndef OVR_MULTIGRID_FIELD_H
#define OVR_MULTIGRID_FIELD_H

#include <stdbool.h>
#include <stdint.h>

#include "base/arena.h"

enum { OVR_FIELD_PAD = 64, OVR_FIELD_PAGE = 512 };

/*
 * A kernel walks through some twenty arrays at once.  Where element i of them
 * all lies at nearly the same place of a 4 kB page they evict each other from
 * the cache and loads wait for stores they have nothing to do with (three
 * times slower on large grids).  So each array starts 11 cache lines further
 * into its page than the one before.  Small arrays lie one behind the other:
 * each is some quarters of a page and three lines long.
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

/* Several of them, to where the pointers point; NULL behind the last. */
static inline ovr_status ovr_fields_take(ovr_arena *arena, size_t n,
                                         ovr_error *err, double **const to[])
{
    for (; *to; to++)
        **to = ovr_field(arena, n, err);
    return ovr_arena_status(arena);
}
#define OVR_TAKE_FIELDS(arena, n, err, ...)                                    \
    ovr_fields_take(arena, n, err, (double **const[]){__VA_ARGS__, NULL})

/* A set of nodes (lanes.h) for any number of lanes, halos included. */
static inline unsigned char *ovr_set(ovr_arena *arena, size_t n, ovr_error *err)
{
    unsigned char *all = ovr_arena_take(arena, n + 2 * OVR_FIELD_PAD, 1, err);
    return all ? all + OVR_FIELD_PAD : NULL;
}

#endif
