/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Public functions check their arguments before use: a NULL that is not allowed
 * is reported as an error, and functions without an error argument return a
 * neutral value, NAN, 0 or NULL (tests/source/arguments.sh). */
#ifndef OVR_BASE_GIVEN_H
#define OVR_BASE_GIVEN_H

#include "overroll/error.h"

/* Reports OVR_BAD_INPUT with the name of the function: `return
 * ovr_fail_null(err, __func__)`. */
ovr_status ovr_fail_null(ovr_error *err, const char *function);

/* Reports OVR_BAD_INPUT for a constructor, which returns NULL. */
void *ovr_null(ovr_error *err, const char *function);

/* Copies a struct passed by the caller. Without one, fails with OVR_BAD_INPUT,
 * "no NAME is given", and `to` does not change. */
ovr_status ovr_given(void *to, size_t size, const void *from, const char *name,
                     ovr_error *err);
#define OVR_TAKE(type, to, from, err)                                          \
    ovr_given(to, sizeof(type), from, #type, err)

/* Fails if the pointer to an output struct is NULL. */
ovr_status ovr_check_output_argument(const void *to, const char *name,
                                     ovr_error *err);

#endif
