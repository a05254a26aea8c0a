/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Structs that cross the library's border by value begin with their size as
 * the caller knows it, so that a program or binding made before a field was
 * added goes on working: what it does not know has its default.
 */
#ifndef OVR_BASE_SIZED_H
#define OVR_BASE_SIZED_H

#include <stddef.h>

#include "overroll/error.h"

/* Fills the caller's struct, of the size it says, with defaults of `size`. */
void ovr_sized_fill(void *to, const void *defaults, size_t size);

/* The caller's struct over defaults of `size` in `to`.  OVR_BAD_INPUT: its size
 * was never set, or it is newer than the library. */
ovr_status ovr_sized_take(void *to, size_t size, const void *from,
                          const char *name, ovr_error *err);

/* The same over the defaults of a type. */
#define OVR_SIZED_TAKE(type, to, given, err)                                   \
    (*(to) = type##_default(),                                                 \
     ovr_sized_take(to, sizeof *(to), given, #type, err))

#endif
