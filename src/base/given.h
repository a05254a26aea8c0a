/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Public functions check their arguments before use: a NULL that is not allowed
 * is reported as an error, and functions without an error argument return a
 * neutral value, NAN, 0 or NULL (tests/source/arguments.sh). */
#ifndef OVR_BASE_GIVEN_H
#define OVR_BASE_GIVEN_H

#include "overroll/error.h"

/* OVR_BAD_INPUT, naming the function: `return ovr_fail_null(err, __func__)`. */
ovr_status ovr_fail_null(ovr_error *err, const char *function);

/* The same of a constructor, which returns NULL. */
void *ovr_null(ovr_error *err, const char *function);

/* A copy of the struct that a caller gives; OVR_BAD_INPUT, "no NAME is given",
 * where he gives none: `to` stays as it is. */
ovr_status ovr_given(void *to, size_t size, const void *from, const char *name,
                     ovr_error *err);
#define OVR_TAKE(type, to, from, err)                                          \
    ovr_given(to, sizeof(type), from, #type, err)

/* Fails unless there is a struct to fill. */
ovr_status ovr_check_output_argument(const void *to, const char *name,
                                     ovr_error *err);

#endif
