/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Controls a gnuplot process, which draws any number of pictures. A picture
 * file appears under its name only when it is complete.
 */
#ifndef OVR_PICTURES_GNUPLOT_H
#define OVR_PICTURES_GNUPLOT_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "overroll/error.h"
#include "pictures/growing_text.h"

/* A child process that is controlled through its standard input and whose
 * output and errors return through the same connection: no shell, no signals,
 * no temporary files. */

typedef struct ovr_process {
    pid_t pid; /* 0: none */
    int line;  /* socket to its stdin, stdout and stderr */
    char heard[1024];
    size_t from, to; /* received but not yet read */
} ovr_process;

/* Starts argv[0], found in PATH. For a missing program fails with OVR_BAD_INPUT
 * and a message with its Debian package. */
ovr_status ovr_process_start(ovr_process *process, const char *const *argv,
                             const char *package, ovr_error *err);

/* Sends data; false if the process no longer reads (it has then printed a
 * reason). */
bool ovr_process_send(ovr_process *process, const void *data, size_t bytes);

/* Closes its input and waits; true if it succeeded. `last` (may be NULL)
 * becomes the last nonempty line of its output. */
bool ovr_process_end(ovr_process *process, char *last, size_t size);

/* Terminates it at once. */
void ovr_process_kill(ovr_process *process);

enum { OVR_PATH_SIZE = 4096 };

typedef struct ovr_gnuplot {
    ovr_process process;
    /* Files of the requested picture: its name, the temporary file, the
     * script. */
    char path[OVR_PATH_SIZE], made[OVR_PATH_SIZE], script[OVR_PATH_SIZE];
} ovr_gnuplot;

ovr_status ovr_gnuplot_start(ovr_gnuplot *gnuplot, ovr_error *err);

/* Requests the picture drawn by a script and returns without waiting. The
 * script must not change `set output`. */
ovr_status ovr_gnuplot_ask(ovr_gnuplot *gnuplot, const ovr_text *script,
                           const char *path, ovr_error *err);

/* Waits until the requested picture is complete; returns at once if there is
 * none. */
ovr_status ovr_gnuplot_wait(ovr_gnuplot *gnuplot, ovr_error *err);

/* Stops gnuplot; an incomplete picture is deleted. */
void ovr_gnuplot_stop(ovr_gnuplot *gnuplot);

/* Creates an empty file FOLDER/.NAME.part, which becomes `path` once it is
 * complete. `part` has OVR_PATH_SIZE bytes. */
ovr_status ovr_part_make(char *part, const char *path, ovr_error *err);

/* Appends a path as a string of gnuplot; fails if a script cannot contain
 * it. */
ovr_status ovr_gnuplot_path(ovr_text *script, const char *path, ovr_error *err);

#endif
