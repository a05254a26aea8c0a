/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * External text: lines with any line end, fields with any separator, numbers.
 * Nothing is copied; a piece of text is a pointer and a size.
 */
#ifndef OVR_BASE_TEXT_H
#define OVR_BASE_TEXT_H

#include <locale.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Numbers in files have a decimal point in every locale. */

/* Makes printf use the C locale in this thread between begin and end; `end`
 * restores the value returned by begin. */
locale_t ovr_plain_begin(void);
void ovr_plain_end(locale_t before);

typedef struct ovr_bytes {
    const char *data;
    size_t size;
} ovr_bytes;

typedef struct ovr_line {
    const char *text;
    size_t size;
    long number; /* line number from 1 */
} ovr_line;

typedef struct ovr_lines {
    const char *at, *end;
    long number; /* number of the last line returned */
} ovr_lines;

/* Converts UTF-16 with a byte order mark to UTF-8 (in `arena`) and skips a
 * UTF-8 mark; other contents do not change. */
ovr_status ovr_decode(ovr_bytes *content, const char *file, ovr_arena *arena,
                      const char **encoding, ovr_error *err);

/* Iterate over lines, which end with LF, CR LF, CR CR LF or CR. */
ovr_lines ovr_lines_of(ovr_bytes content);
bool ovr_next_line(ovr_lines *lines, ovr_line *line);
/* Removes blanks at both ends. */
ovr_line ovr_trim(ovr_line line);
bool ovr_line_starts(ovr_line line, const char *word);
bool ovr_line_is(ovr_line line, const char *word); /* ignores case */

/* Removes the next word, separated by blanks or NULs, from `rest`. */
bool ovr_next_piece(ovr_line *rest, ovr_line *piece);

/* Reads a decimal number with a point, in every locale, at *text and moves
 * *text past it; false if there is none or it is out of range. */
bool ovr_read_number(const char **text, double *value);

/* Reads a piece that is a number as instruments write it: also with an exponent
 * 'd' and, if `comma`, a decimal comma. */
bool ovr_number(ovr_line piece, bool comma, double *value);
/* True if `piece` is a missing-value marker: NaN, BAD, --- or empty. */
bool ovr_is_missing(ovr_line piece);

/* Returns "an" before a vowel, otherwise "a". */
const char *ovr_article(const char *word);

/* Replaces "\302\265m" (in any encoding) by "um", in `buffer`. */
ovr_line ovr_spelled(ovr_line unit, char buffer[16]);

/* Returns the bytes of the control character at the start of s; 0 if there is
 * none, or a line end or tab, if `has_lines`. */
int ovr_control_bytes(const char *s, bool has_lines);

/* Copies a text and escapes control characters (\x1b), including the C1
 * controls of UTF-8 (0xc2 0x80 to 0xc2 0x9f). Line ends and tabs are kept if
 * `has_lines`. NULL without memory. */
char *ovr_escaped(const char *text, bool has_lines, ovr_arena *arena);

/* A piece for messages: printable UTF-8, shortened, NUL-terminated. */
typedef struct ovr_quoted {
    char text[48];
} ovr_quoted;
ovr_quoted ovr_quote(ovr_line piece);

#endif
