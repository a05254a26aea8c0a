/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A movie from pictures, one after the other, by ffmpeg. */
#ifndef OVR_PICTURES_MOVIE_H
#define OVR_PICTURES_MOVIE_H

#include "pictures/gnuplot.h"

typedef struct ovr_movie {
    ovr_process process;
    const char *path;
    char made[OVR_PATH_SIZE];
} ovr_movie;

/* The form is by the path's suffix. */
ovr_status ovr_movie_start(ovr_movie *movie, const char *path, double rate,
                           ovr_error *err);

/* Adds a PNG file. */
ovr_status ovr_movie_add(ovr_movie *movie, const char *picture, ovr_error *err);

/* The movie appears under its name. */
ovr_status ovr_movie_finish(ovr_movie *movie, ovr_error *err);

/* Cancels the movie unless it is finished or was never started. */
void ovr_movie_stop(ovr_movie *movie);

#endif
