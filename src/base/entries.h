/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parser for sections and values, the syntax of cases and studies:
 *
 *     [section]             # a comment; so is what follows a blank and ';'
 *     key = value
 *
 * Blanks around key, value and section are ignored; a key may also end with
 * ':'.
 */
#ifndef OVR_BASE_ENTRIES_H
#define OVR_BASE_ENTRIES_H

#include <stdbool.h>

#include "base/arena.h"

typedef struct ovr_entry {
    long line;     /* line number from 1; 0: end of the text */
    char *section; /* text in [ ]; NULL: the entry is a key with a value */
    char *key, *value;
} ovr_entry;

typedef struct ovr_entries {
    const char *file; /* for messages */
    const char *at;   /* next line */
    long line;        /* number of the last line read */
    size_t maximum;   /* maximum characters per line */
    char *copy;       /* copy of the line */
    bool inside;      /* within a section */
} ovr_entries;

/* Starts reading the text at `at` of `file`, with at most `maximum` characters
 * per line. */
ovr_status ovr_entries_open(ovr_entries *e, ovr_arena *arena, ovr_error *err);

/* Reads the next section or key, which is valid until the next call. */
ovr_status ovr_entries_next(ovr_entries *e, ovr_entry *entry, ovr_error *err);

/* Reads a text file of at most `maximum` bytes. `what` ("case") names the kind
 * of file in error messages. Returns NULL if the file cannot be read. */
const char *ovr_text_file(const char *path, const char *what, size_t maximum,
                          ovr_arena *arena, ovr_error *err);

#endif
