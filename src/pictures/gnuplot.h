/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * gnuplot at the other end of a line: one process draws any number of
 * pictures, each of which appears whole under its name or not at all.
 */
#ifndef OVR_PICTURES_GNUPLOT_H
#define OVR_PICTURES_GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "overroll/error.h"
#include "pictures/growing_text.h"

/*
 * A child process fed through its standard input, whose output and errors
 * come back on the same line: no shell, no signals, no temporary files.
 */

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

/* Ends its input, waits; true when it succeeded.  What it still says goes,
 * the last line that is not empty, into `last` (may be NULL). */
bool ovr_process_end(ovr_process *process, char *last, size_t size);

/* Makes it stop at once. */
void ovr_process_kill(ovr_process *process);

enum { OVR_PATH_SIZE = 4096 };

typedef struct ovr_gnuplot {
    ovr_process process;
    /* The picture asked for has these files: its name, the file being made, the
     * script. */
    char path[OVR_PATH_SIZE], made[OVR_PATH_SIZE], script[OVR_PATH_SIZE];
} ovr_gnuplot;

ovr_status ovr_gnuplot_start(ovr_gnuplot *gnuplot, ovr_error *err);

/* Asks for the picture that a script draws; returns without waiting.  The
 * script leaves `set output` alone. */
ovr_status ovr_gnuplot_ask(ovr_gnuplot *gnuplot, const ovr_text *script,
                           const char *path, ovr_error *err);

/* Waits until the requested picture is complete; returns at once if there is
 * none. */
ovr_status ovr_gnuplot_wait(ovr_gnuplot *gnuplot, ovr_error *err);

/* Stops gnuplot; an incomplete picture is discarded. */
void ovr_gnuplot_stop(ovr_gnuplot *gnuplot);

/* FOLDER/.NAME.part, created empty: what becomes `path` once it is whole.
 * `part` has OVR_PATH_SIZE bytes. */
ovr_status ovr_part_make(char *part, const char *path, ovr_error *err);

/* A path as a string of gnuplot; fails on one that cannot be in a script. */
ovr_status ovr_gnuplot_path(ovr_text *script, const char *path, ovr_error *err);

#endif
