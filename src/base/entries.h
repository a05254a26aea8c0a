/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text of sections and values, as cases and studies are written:
 *
 *     [section]             # a comment; so is what follows a blank and ';'
 *     key = value
 *
 * Blanks around key, value and section do not count; a key may end with ':'
 * too.
 */
#ifndef OVR_BASE_ENTRIES_H
#define OVR_BASE_ENTRIES_H

#include <stdbool.h>

#include "base/arena.h"

typedef struct ovr_entry {
    long line;     /* from 1; 0: the end of the text */
    char *section; /* text in [ ]; NULL: a key and its value */
    char *key, *value;
} ovr_entry;

typedef struct ovr_entries {
    const char *file; /* in messages */
    const char *at;   /* next line */
    long line;        /* the one read last */
    size_t maximum;   /* characters a line */
    char *copy;       /* of that line */
    bool inside;      /* a section */
} ovr_entries;

/* Begins at `at` of `file` with lines of at most `maximum` characters, which
 * are given. */
ovr_status ovr_entries_open(ovr_entries *e, ovr_arena *arena, ovr_error *err);

/* The next section or key, valid until the one after it. */
ovr_status ovr_entries_next(ovr_entries *e, ovr_entry *entry, ovr_error *err);

/* Reads a text file of at most `maximum` bytes. `what` ("case") names the kind
 * of file in error messages. Returns NULL if the file cannot be read. */
const char *ovr_text_file(const char *path, const char *what, size_t maximum,
                          ovr_arena *arena, ovr_error *err);

#endif
