/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * gnuplot at the other end of a line: one process draws any number of
 * pictures, each of which appears whole under its name or not at all.
 */
#ifndef OVR_PICTURES_GNUPLOT_H
#define OVR_PICTURES_GNUPLOT_H

#include "pictures/process.h"
#include "pictures/text.h"

enum { OVR_PATH_SIZE = 4096 };

typedef struct ovr_gnuplot {
    ovr_process process;
    char path[OVR_PATH_SIZE], made[OVR_PATH_SIZE]; /* of the picture asked */
} ovr_gnuplot;

ovr_status ovr_gnuplot_start(ovr_gnuplot *gnuplot, ovr_error *err);

/* Asks for the picture that a script draws; returns without waiting.  The
 * script leaves `set output` alone. */
ovr_status ovr_gnuplot_ask(ovr_gnuplot *gnuplot, const ovr_text *script,
                           const char *path, ovr_error *err);

/* Waits until the picture asked for is there (at once when none is). */
ovr_status ovr_gnuplot_wait(ovr_gnuplot *gnuplot, ovr_error *err);

/* Ends it; a picture that is not yet there is given up. */
void ovr_gnuplot_stop(ovr_gnuplot *gnuplot);

/* The line that makes gnuplot write to a path; fails on a path that cannot
 * be written in a script. */
ovr_status ovr_gnuplot_output(ovr_text *script, const char *path,
                              ovr_error *err);

#endif
