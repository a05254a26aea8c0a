/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Memory: one allocator hook.
 *
 * A constructor with an argument `const ovr_allocator *` copies it (NULL:
 * malloc and free), and its object allocates through it, so that a program can
 * count, bound or fail the allocations.  Memory that HDF5, FFTW, GSL, expat and
 * nettle allocate is not included.  `allocate` returns NULL on failure,
 * otherwise memory aligned for any type with undefined contents.
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
