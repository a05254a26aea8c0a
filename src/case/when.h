/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The conditions under which a key has an effect (base/parameter.h), as text.
 */
#ifndef OVR_CASE_WHEN_H
#define OVR_CASE_WHEN_H

#include "base/parameter.h"
#include "overroll/error.h"

enum { OVR_CONDITION_MAX = 256 };

/* Separates the premise of a condition from the required condition. */
#define OVR_ONLY_WHERE " => "

/* Returns the text up to a separator and moves past it; false at the end. */
bool ovr_condition_next(const char **text, const char *separator, char *piece,
                        size_t capacity);

/* Writes all conditions of a row as text; "" if there are none. */
void ovr_when_text(const ovr_parameter *row, char *text, size_t capacity);

#endif
