/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text from anywhere: lines of any ending, fields of any separator, numbers.
 * Nothing is copied; a piece of text is a pointer and a size.
 */
#ifndef OVR_BASE_TEXT_H
#define OVR_BASE_TEXT_H

#include <locale.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* Numbers in files have a point, whatever locale the program has chosen. */

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
    long number; /* from 1 */
} ovr_line;

typedef struct ovr_lines {
    const char *at, *end;
    long number; /* of the last line given */
} ovr_lines;

/* UTF-16 with a byte order mark becomes UTF-8 (in `arena`); a UTF-8 mark is
 * skipped; anything else stays as it is. */
ovr_status ovr_decode(ovr_bytes *content, const char *file, ovr_arena *arena,
                      const char **encoding, ovr_error *err);

/* Lines end with LF, CR LF, CR CR LF or CR. */
ovr_lines ovr_lines_of(ovr_bytes content);
bool ovr_next_line(ovr_lines *lines, ovr_line *line);
/* Blanks at both ends taken off. */
ovr_line ovr_trim(ovr_line line);
bool ovr_line_starts(ovr_line line, const char *word);
bool ovr_line_is(ovr_line line, const char *word); /* without case */

/* The next word between blanks or NULs, taken off `rest`. */
bool ovr_next_piece(ovr_line *rest, ovr_line *piece);

/* A decimal number with a point, whatever the locale, at *text, which moves
 * behind it; false when there is none or it is out of range. */
bool ovr_read_number(const char **text, double *value);

/* The same as a whole piece, as instruments write it: with an exponent of 'd'
 * too and, if `comma`, a comma for the point. */
bool ovr_number(ovr_line piece, bool comma, double *value);
/* The whole piece is a sign for no value: NaN, BAD, ---, nothing... */
bool ovr_is_missing(ovr_line piece);

/* "an" before a word that begins with a vowel, else "a". */
const char *ovr_article(const char *word);

/* "\302\265m" (of any encoding) becomes "um", in `buffer`. */
ovr_line ovr_spelled(ovr_line unit, char buffer[16]);

/* A copy in which the control characters that command a terminal are escaped
 * (\x1b), the C1 controls of UTF-8 (0xc2 0x80 to 0xc2 0x9f) among them.
 * Line ends and tabs stay if `has_lines`.  NULL: memory is out. */
char *ovr_escaped(const char *text, bool has_lines, ovr_arena *arena);

/* A piece fit for a message: printable UTF-8, shortened, NUL-ended. */
typedef struct ovr_quoted {
    char text[48];
} ovr_quoted;
ovr_quoted ovr_quote(ovr_line piece);

#endif
