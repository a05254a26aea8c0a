/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Words and bytes of people, for programs that talk to them as this one. */
#ifndef OVERROLL_TEXT_H
#define OVERROLL_TEXT_H

#include <stddef.h>

#include "overroll/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Did you mean ...: the nearest of `n` names to a mistyped one, with at most a
 * third of the letters wrong (capital letters do not count as wrong); else the
 * first of which it is a word, as vg of iso_vg; or NULL. */
OVR_API const char *ovr_suggest(const char *wrong, const char *const *names,
                                size_t n);

/* The k-th unit that a number may have, those of one quantity together, and the
 * SI unit of what it measures; NULL behind the last. */
OVR_API const char *ovr_unit_name(size_t k, const char **si);

/* Length of the UTF-8 sequence at s (RFC 3629), 0 when it is none; the NUL at
 * the end is a sequence of length 1. */
OVR_API int ovr_utf8_sequence(const unsigned char *s);

#ifdef __cplusplus
}
#endif

#endif
