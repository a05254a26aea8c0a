/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reporting of errors about a line of a file or a key, within the library. */
#ifndef OVR_BASE_ERROR_H
#define OVR_BASE_ERROR_H

#include "overroll/error.h"

/* Reports an error in a text file: the message starts with "file:line: " (line
 * <= 0: "file: "). */
ovr_status ovr_fail_at(ovr_error *err, ovr_status status, const char *file,
                       long line, const char *format, ...) OVR_PRINTF(5, 6);

/* Reports OVR_BAD_INPUT about a key, which the message names. */
ovr_status ovr_fail_about(ovr_error *err, const char *about, const char *format,
                          ...) OVR_PRINTF(3, 4);

/* Stores the word that the message suggests; returns `status`. */
ovr_status ovr_fail_meant(ovr_error *err, ovr_status status, const char *meant);

/* Reports the error `why` with its place in front (file NULL: none). */
ovr_status ovr_fail_from(ovr_error *err, const ovr_error *why, const char *file,
                         long line);

#endif
