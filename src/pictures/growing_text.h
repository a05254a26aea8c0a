/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A text that grows, in an arena.  A failed allocation is remembered, and
 * what follows is dropped: ask once, at the end, with ovr_text_status.
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

/* Text from outside as one line: control characters become blanks, what is
 * not UTF-8 a question mark, and the end of a very long one is left out.
 * `put` receives one character (1 to 4 bytes) at a time. */
typedef void ovr_text_rule(ovr_text *text, const char *character, int bytes);
void ovr_text_foreign(ovr_text *text, const char *foreign, ovr_text_rule *put);

/* Writes a string of gnuplot, quotes included, in which nothing is expanded. */
void ovr_text_gnuplot(ovr_text *text, const char *foreign);

/* Writes the text as a file; a message names the path. */
ovr_status ovr_text_save(const ovr_text *text, const char *path,
                         ovr_error *err);

/* The same for names that nobody chose: a file of our own, never one that
 * somebody has put there, nor what a link leads to. */
ovr_status ovr_text_save_anew(const ovr_text *text, const char *path,
                              ovr_error *err);

#endif
