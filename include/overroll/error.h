/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Errors: one convention for the whole library.
 *
 * A function that can fail returns an ovr_status (or NULL for a constructor)
 * and has an `ovr_error *` as its last argument. The message is one line
 * without a trailing newline. It states the place (file, line, key), the error
 * and the allowed values. The other members contain the same for programs. The
 * library never prints, exits or aborts. Every function accepts a NULL error if
 * only the status is of interest.
 */
#ifndef OVERROLL_ERROR_H
#define OVERROLL_ERROR_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define OVR_PRINTF(form, first)                                                \
    __attribute__((__format__(__printf__, form, first)))
#define OVR_API __attribute__((visibility("default")))
#else
#define OVR_PRINTF(form, first)
#define OVR_API
#endif

/* Structs of options must be initialized as {0} or, where it is declared, with
 * NAME_default(); members that are not set have their defaults. Minor versions
 * may add members and change the soname, so that programs must be compiled
 * again. */

typedef enum ovr_status {
    OVR_OK = 0,
    OVR_BAD_INPUT,     /* input is wrong or missing: exit code 2 */
    OVR_NOT_CONVERGED, /* a solve or step did not reach its tolerance: 1 */
    OVR_IMPOSSIBLE,    /* the requested model has no solution here: 1 */
    OVR_NO_MEMORY,     /* an allocation failed: 1 */
    OVR_IO,            /* reading or writing failed: 1 */
    OVR_STOPPED        /* stopped by an observer: 3 */
} ovr_status;

enum { OVR_MESSAGE_SIZE = 1024 };

typedef struct ovr_error {
    ovr_status status;
    char message[OVR_MESSAGE_SIZE];
    const char *about; /* key of the case or member of a struct that is wrong or
                          missing: static, or NULL */
    const char *meant; /* word that the message proposes ("did you mean"):
                          static, or NULL */
    size_t file; /* length in bytes of the file name (or other origin) at the
                    start of the message; 0: no name */
    long line;   /* line in that file; 0: none */
} ovr_error;

/* Returns the name of a status ("bad input", ...), a static string. */
OVR_API const char *ovr_status_name(ovr_status status);

/* Fills *err (unless NULL) and returns `status`, so that a failing function
 * ends in `return ovr_fail(err, OVR_..., "...", ...)`. */
OVR_API ovr_status ovr_fail(ovr_error *err, ovr_status status,
                            const char *format, ...) OVR_PRINTF(3, 4);

#ifdef __cplusplus
}
#endif

#endif
