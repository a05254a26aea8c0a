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

/* The caller's struct itself where it is as long as the library's, else over
 * the defaults in `to`; NULL: its size was never set, or it is newer.  For
 * functions without an error to give, and called often. */
const void *ovr_sized_whole(void *to, size_t size, const void *from);

/* As much of `made` as the caller's struct holds; what he knows and the
 * library does not becomes zero, and his size the library's. */
void ovr_sized_give(void *to, void *made, size_t size);

/* The same over the defaults of a type. */
#define OVR_SIZED_TAKE(type, to, given, err)                                   \
    (*(to) = type##_default(),                                                 \
     ovr_sized_take(to, sizeof *(to), given, #type, err))

/* Whether the caller's struct, of any length, is one to fill. */
ovr_status ovr_sized_check(const void *to, const char *name, ovr_error *err);
#define OVR_SIZED_ROOM(type, to, err) ovr_sized_check(to, #type, err)

#endif
