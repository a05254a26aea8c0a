/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The conditions under which a key has an effect (base/parameter.h), as text.
 */
#ifndef OVR_CASE_WHEN_H
#define OVR_CASE_WHEN_H

#include "base/parameter.h"
#include "overroll/error.h"

enum { OVR_CONDITION_MAX = 256 };

/* Stands between where a condition is asked for and what it asks for. */
#define OVR_ONLY_WHERE " => "

/* The text up to a separator, which moves on behind it; false at its end. */
bool ovr_condition_next(const char **text, const char *separator, char *piece,
                        size_t capacity);

/* Appends to a text. */
void ovr_condition_add(char *text, size_t capacity, const char *format, ...)
    OVR_PRINTF(3, 4);

/* "[heat] model = lobatto or history = ramp, step or sine", behind a text. */
void ovr_condition_text(const char *condition, char *text, size_t capacity);

/* All conditions of a row in words; "" for none. */
void ovr_when_text(const ovr_parameter *row, char *text, size_t capacity);

#endif
