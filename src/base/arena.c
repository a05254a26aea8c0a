/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS, MAP_NORESERVE */
#include "base/arena.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum { ALIGNMENT = 64, BLOCK = 1 << 16 };

struct ovr_arena_block {
    struct ovr_arena_block *older;
    size_t used; /* bytes from start_of() */
    size_t size; /* bytes, including this header and padding */
};

enum { OVERHEAD = sizeof(struct ovr_arena_block) + ALIGNMENT };

static void *from_malloc(void *context, size_t bytes)
{
    (void)context;
    return malloc(bytes);
}

static void to_free(void *context, void *memory)
{
    (void)context;
    free(memory);
}

ovr_arena ovr_arena_make(const ovr_allocator *allocator)
{
    ovr_arena arena = {.allocator = {from_malloc, to_free, NULL}};
    if (allocator)
        arena.allocator = *allocator;
    return arena;
}

static void *reserve(void *context, size_t bytes)
{
    void *at = mmap(NULL, bytes, PROT_READ | PROT_WRITE,
                    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    (void)context;
    return at == MAP_FAILED ? NULL : at;
}

static void unmap_block(void *context, void *block)
{
    (void)context;
    munmap(block, ((struct ovr_arena_block *)block)->size);
}

ovr_arena ovr_arena_counting(void)
{
    return (ovr_arena){.allocator = {reserve, unmap_block, NULL},
                       .blank = true};
}

/* Returns the first aligned address after the header. Offsets are counted from
 * it, so that alignment does not depend on the allocator. */
static char *start_of(struct ovr_arena_block *block)
{
    uintptr_t at = (uintptr_t)(block + 1);
    return (char *)(block + 1) + (-at & (ALIGNMENT - 1));
}

static size_t aligned(size_t bytes)
{
    return (bytes + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
}

/* Adds a block to the list. Large blocks are inserted after the newest one,
 * which still has space for small pieces. */
static void add_to_list(ovr_arena *arena, struct ovr_arena_block *block)
{
    struct ovr_arena_block *newest = arena->blocks;
    bool own = newest && block->size != BLOCK;
    block->older = own ? newest->older : newest;
    if (own)
        newest->older = block;
    else
        arena->blocks = block;
}

static struct ovr_arena_block *add_block(ovr_arena *arena, size_t bytes)
{
    size_t size = OVERHEAD + bytes;
    struct ovr_arena_block *block;
    if (size < BLOCK / 8)
        size = BLOCK;
    block = arena->allocator.allocate(arena->allocator.context, size);
    if (!block)
        return NULL;
    block->used = 0;
    block->size = size;
    add_to_list(arena, block);
    arena->bytes += size;
    return block;
}

static void *fail(ovr_arena *arena, size_t bytes, ovr_error *err)
{
    arena->starved = true;
    arena->lacking = bytes;
    ovr_fail(err, OVR_NO_MEMORY, "out of memory: %zu bytes needed", bytes);
    return NULL;
}

void *ovr_arena_take(ovr_arena *arena, size_t count, size_t size,
                     ovr_error *err)
{
    struct ovr_arena_block *block = arena->blocks;
    size_t bytes = count * size, at;
    if (arena->starved)
        return fail(arena, arena->lacking, err);
    if (size && count > (SIZE_MAX / 2) / size)
        return fail(arena, SIZE_MAX, err);
    if (!block || aligned(block->used) + bytes > block->size - OVERHEAD)
        block = add_block(arena, bytes);
    if (!block)
        return fail(arena, bytes, err);
    at = aligned(block->used);
    block->used = at + bytes;
    arena->pieces++;
    if (!arena->blank)
        memset(start_of(block) + at, 0, bytes);
    return start_of(block) + at;
}

char *ovr_arena_text(ovr_arena *arena, const char *text, ovr_error *err)
{
    size_t bytes = strlen(text) + 1;
    char *copy = ovr_arena_take(arena, bytes, 1, err);
    return copy ? memcpy(copy, text, bytes) : NULL;
}

void ovr_arena_release(ovr_arena *arena)
{
    struct ovr_arena_block *block = arena->blocks;
    ovr_arena emptied = *arena;
    arena->blocks = NULL;
    arena->bytes = arena->pieces = 0;
    arena->starved = false;
    arena->releases++;
    while (block) {
        struct ovr_arena_block *older = block->older;
        emptied.allocator.release(emptied.allocator.context, block);
        block = older;
    }
}
