/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Artificial surfaces written in every supported format and encoding; a reader
 * must return them within the rounding of the format. */
#ifndef TESTS_SUPPORT_GAUGES_H
#define TESTS_SUPPORT_GAUGES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { GAUGE_POINTS = 400, GAUGE_LINES = 4, GAUGE_BYTES = 1 << 20 };

/* Heights of some lines in metres; missing ones are NAN. */
typedef struct gauge {
    size_t n, lines;
    bool uniform;
    double dx; /* spacing of a uniform gauge */
    double x[GAUGE_POINTS];
    double z[GAUGE_LINES][GAUGE_POINTS];
} gauge;

/* Draws a random surface. With `gaps`, one in three has missing heights. */
void gauge_make(gauge *g, uint64_t *seed, bool uniform, size_t lines,
                bool gaps);

typedef enum gauge_encoding {
    GAUGE_UTF8,
    GAUGE_UTF8_MARK,
    GAUGE_LATIN1,
    GAUGE_UTF16_LITTLE,
    GAUGE_UTF16_BIG,
    GAUGE_ENCODINGS
} gauge_encoding;

typedef struct gauge_text {
    char separator; /* with ';' decimal points are commas */
    const char *newline;
    gauge_encoding encoding;
    bool trailing; /* separator at the end of each line */
    bool count;    /* a line with the number of points */
    bool index;    /* a first column of indices */
    bool backwards;
} gauge_text;

/* Write to `out`, of GAUGE_BYTES, and return the number of bytes. `type` is 0
 * to 7 as in SDF, and *step the height of one unit. */
size_t gauge_as_text(const gauge *g, const gauge_text *how, char *out);
size_t gauge_as_sdf_text(const gauge *g, char *out);
size_t gauge_as_sdf_binary(const gauge *g, int type, char *out, double *step);
size_t gauge_as_smd(const gauge *g, char *out);

typedef struct gauge_x3p {
    char type;        /* data type of z: I, L, F, D */
    bool stored_x;    /* absolute CX, as D */
    bool inline_data; /* DataList instead of a binary file */
    bool mask;        /* valid points in a bit mask instead of NaN */
    bool list;        /* ListDimension instead of MatrixDimension */
    bool prefix;      /* names in a namespace */
    bool deflate;
    const char *folder; /* "" or "FOLDER/" */
} gauge_x3p;

/* Writes a file with libzip. */
void gauge_to_x3p(const gauge *g, const gauge_x3p *how, const char *path,
                  double *step);

#endif
