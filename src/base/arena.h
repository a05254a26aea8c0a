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
    size_t bytes;                   /* asked of the allocator in all */
    size_t pieces;                  /* handed out */
    size_t releases;                /* how often it was emptied */
    bool blank;                     /* what the allocator gives is zero */
    bool starved;                   /* an allocation has failed, */
    size_t lacking;                 /* its size in bytes */
} ovr_arena;

/* An empty arena; `allocator` NULL means malloc and free. */
ovr_arena ovr_arena_make(const ovr_allocator *allocator);

/* One that counts: it gives addresses, behind which there is no memory before
 * something is written.  A set-up run through it, however large, tells by
 * `bytes` what it takes; only what it fills is really taken. */
ovr_arena ovr_arena_counting(void);

/* `count` zeroed elements of `size` bytes each, or NULL with *err filled.
 * A zero count gives a valid pointer.  Once an allocation has failed, every
 * further one fails until the arena is released: a function that allocates
 * several pieces checks ovr_arena_status once, before it uses any of them. */
void *ovr_arena_take(ovr_arena *arena, size_t count, size_t size,
                     ovr_error *err);

/* Returns OVR_NO_MEMORY if an allocation has failed. */
static inline ovr_status ovr_arena_status(const ovr_arena *arena)
{
    return arena->starved ? OVR_NO_MEMORY : OVR_OK;
}

/* Copy of a string, or NULL with *err filled. */
char *ovr_arena_text(ovr_arena *arena, const char *text, ovr_error *err);

/* Frees everything; the arena is empty and usable again. */
void ovr_arena_release(ovr_arena *arena);

/*
 * A self-owning object: allocates `size` zeroed bytes for a struct whose
 * arena is then moved into it by the caller, freed last by
 * ovr_arena_release on a copy:
 *     ovr_arena arena = ovr_arena_make(allocator);
 *     thing *t = ovr_arena_take(&arena, 1, sizeof *t, err);
 *     ...  t->arena = arena;                 (after the last take)
 *     void thing_free(thing *t)
 *     { if (t) { ovr_arena a = t->arena; ovr_arena_release(&a); } }
 */

#endif
