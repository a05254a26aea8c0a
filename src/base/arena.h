/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * An arena: all the memory of one object, freed by one call.
 *
 * Blocks come from the allocator hook; pieces are zeroed and aligned to 64
 * bytes (a cache line, a vector register of AVX-512).  Nothing is freed or
 * resized piece by piece: for a list that grows, take a piece twice as large
 * and copy.
 */
#ifndef OVR_BASE_ARENA_H
#define OVR_BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/error.h"
#include "overroll/memory.h"

typedef struct ovr_arena {
    ovr_allocator allocator;
    struct ovr_arena_block *blocks; /* newest first */
    size_t bytes;                   /* total bytes requested from the
                                     * allocator */
    size_t pieces;                  /* pieces allocated */
    size_t releases;                /* number of releases */
    bool blank;                     /* the allocator's memory is zeroed */
    bool starved;                   /* an allocation has failed */
    size_t lacking;                 /* size in bytes of the failed request */
} ovr_arena;

/* Returns an empty arena; `allocator` NULL means malloc and free. */
ovr_arena ovr_arena_make(const ovr_allocator *allocator);

/* Returns an arena for measuring memory: its pages become real only when
 * written. `bytes` of a setup created with it is the memory that the setup
 * needs. */
ovr_arena ovr_arena_counting(void);

/* Allocates `count` zeroed elements of `size` bytes; NULL with *err filled on
 * failure. A zero count returns a valid pointer. After a failure all further
 * allocations fail until the arena is released, so a function with several
 * allocations can check ovr_arena_status once. */
void *ovr_arena_take(ovr_arena *arena, size_t count, size_t size,
                     ovr_error *err);

/* Returns OVR_NO_MEMORY if an allocation has failed. */
static inline ovr_status ovr_arena_status(const ovr_arena *arena)
{
    return arena->starved ? OVR_NO_MEMORY : OVR_OK;
}

/* Copies a string; NULL with *err filled on failure. */
char *ovr_arena_text(ovr_arena *arena, const char *text, ovr_error *err);

/* Frees everything; the arena is empty and usable again. */
void ovr_arena_release(ovr_arena *arena);

/*
 * A self-owning object: allocates `size` zeroed bytes for a struct. The caller
 * moves the arena into the struct and frees both by ovr_arena_release on a
 * copy:
 *
 *     ovr_arena arena = ovr_arena_make(allocator);
 *     thing *t = ovr_arena_take(&arena, 1, sizeof *t, err);
 *     ...
 *     t->arena = arena;                 (after the last take)
 *
 *     void thing_free(thing *t)
 *     {
 *         if (t) {
 *             ovr_arena a = t->arena;
 *             ovr_arena_release(&a);
 *         }
 *     }
 */

#endif
