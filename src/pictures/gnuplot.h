/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * gnuplot at the other end of a line: one process draws any number of
 * pictures, each of which appears whole under its name or not at all.
 */
#ifndef OVR_PICTURES_GNUPLOT_H
#define OVR_PICTURES_GNUPLOT_H

#include "pictures/growing_text.h"
#include "pictures/process.h"

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

/* Waits until the picture asked for is there (at once when none is). */
ovr_status ovr_gnuplot_wait(ovr_gnuplot *gnuplot, ovr_error *err);

/* Ends it; a picture that is not yet there is given up. */
void ovr_gnuplot_stop(ovr_gnuplot *gnuplot);

/* FOLDER/.NAME.part, created empty: what becomes `path` once it is whole.
 * `part` has OVR_PATH_SIZE bytes. */
ovr_status ovr_part_make(char *part, const char *path, ovr_error *err);

/* A path as a string of gnuplot; fails on one that cannot be in a script. */
ovr_status ovr_gnuplot_path(ovr_text *script, const char *path, ovr_error *err);

#endif
