/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A text buffer for appending, in an arena. After a failed allocation further
 * text is dropped; ovr_text_status returns the error and needs to be called
 * only once, at the end.
 */
#ifndef OVR_PICTURES_GROWING_TEXT_H
#define OVR_PICTURES_GROWING_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

typedef struct ovr_text {
    ovr_arena *arena;
    char *data; /* not NUL-terminated */
    size_t length, capacity;
    bool failed;
    ovr_error why;
} ovr_text;

ovr_text ovr_text_make(ovr_arena *arena);
void ovr_text_add(ovr_text *text, const void *data, size_t bytes);
void ovr_text_put(ovr_text *text, const char *string);
void ovr_text_print(ovr_text *text, const char *format, ...) OVR_PRINTF(2, 3);
ovr_status ovr_text_status(const ovr_text *text, ovr_error *err);

/* Appends external text as one line. Control characters become blanks, invalid
 * UTF-8 becomes a question mark, and very long text is truncated. `put`
 * receives one character (1 to 4 bytes) at a time. */
typedef void ovr_text_rule(ovr_text *text, const char *character, int bytes);
void ovr_text_foreign(ovr_text *text, const char *foreign, ovr_text_rule *put);

/* Appends a string of gnuplot with quotes, in which nothing is expanded. */
void ovr_text_gnuplot(ovr_text *text, const char *foreign);

/* Writes the text as a file; a message names the path. */
ovr_status ovr_text_save(const ovr_text *text, const char *path,
                         ovr_error *err);

/* Writes a file whose name was not chosen by the user: always creates a new
 * file and follows no link. */
ovr_status ovr_text_save_anew(const ovr_text *text, const char *path,
                              ovr_error *err);

#endif
