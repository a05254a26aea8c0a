/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Memory: one allocator hook.
 *
 * Every object of the library takes an optional `const ovr_allocator *`
 * (NULL: malloc and free), copies it, and gets all its memory through it:
 * a program can count, bound or fail the allocations.  `allocate` returns
 * NULL on failure, else memory aligned for any type; contents are undefined.
 */
#ifndef OVERROLL_MEMORY_H
#define OVERROLL_MEMORY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct ovr_allocator {
    void *(*allocate)(void *context, size_t bytes);
    void (*release)(void *context, void *memory);
    void *context;
} ovr_allocator;

#ifdef __cplusplus
}
#endif

#endif
