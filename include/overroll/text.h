/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Suggestions for mistyped names, names of units, and UTF-8. */
#ifndef OVERROLL_TEXT_H
#define OVERROLL_TEXT_H

#include <stddef.h>

#include "overroll/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the name most similar to a mistyped one if at most a third of the
 * letters are wrong (ignoring case). Otherwise returns the first name that
 * contains it, as iso_vg contains vg, or NULL. */
OVR_API const char *ovr_suggest(const char *wrong, const char *const *names,
                                size_t n);

/* Returns unit k of numbers in a case, ordered by quantity, and in *si the SI
 * unit of the quantity; NULL past the last. */
OVR_API const char *ovr_unit_name(size_t k, const char **si);

/* Returns the length of the UTF-8 sequence at s (RFC 3629), or 0 if it is
 * invalid. The terminating NUL is a sequence of length 1. */
OVR_API int ovr_utf8_sequence(const unsigned char *s);

#ifdef __cplusplus
}
#endif

#endif
