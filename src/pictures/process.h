/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A child process fed through its standard input, whose output and errors
 * come back on the same line: no shell, no signals, no temporary files.
 */
#ifndef OVR_PICTURES_PROCESS_H
#define OVR_PICTURES_PROCESS_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "overroll/error.h"

typedef struct ovr_process {
    pid_t pid; /* 0: none */
    int line;  /* socket to its stdin, stdout and stderr */
    char heard[1024];
    size_t from, to; /* what has been received but not yet read */
} ovr_process;

/* Starts argv[0], found in PATH.  A missing program fails with OVR_BAD_INPUT
 * and a message with its Debian package. */
ovr_status ovr_process_start(ovr_process *process, const char *const *argv,
                             const char *package, ovr_error *err);

/* False: it no longer listens (and will have said why). */
bool ovr_process_send(ovr_process *process, const void *data, size_t bytes);

/* The next line it says, without its end, cut to fit; false: it has ended. */
bool ovr_process_line(ovr_process *process, char *line, size_t size);

/* Ends its input, waits; true when it succeeded.  What it still says goes,
 * the last line that is not empty, into `last` (may be NULL). */
bool ovr_process_end(ovr_process *process, char *last, size_t size);

/* Makes it stop at once. */
void ovr_process_kill(ovr_process *process);

#endif
