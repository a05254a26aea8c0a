/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Did you mean ...: the nearest known name to a mistyped one. */
#ifndef OVR_BASE_SUGGEST_H
#define OVR_BASE_SUGGEST_H

#include <stddef.h>

/* The nearest of `n` names, or NULL when none is near: at most a third of the
 * letters wrong (capital letters do not count as wrong). */
const char *ovr_suggest(const char *wrong, const char *const *names, size_t n);

#endif
