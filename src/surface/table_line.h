/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Splits a line of a table into fields; information from a table's header. */
#ifndef OVR_SURFACE_TABLE_LINE_H
#define OVR_SURFACE_TABLE_LINE_H

#include "base/text.h"

enum { OVR_HEADER_FIELDS_MAX = 64 };

typedef struct ovr_fields {
    size_t count;
    bool open; /* the line ends with a separator: one more, empty field */
    ovr_line field[OVR_HEADER_FIELDS_MAX];
} ovr_fields;

typedef struct ovr_layout {
    char separator; /* ';' ',' '\t', or ' ' for any blanks */
    bool comma;     /* decimal comma */
} ovr_layout;

ovr_layout ovr_layout_of(ovr_line line);
/* Removes the next field from `rest`, without quotation marks; false if none is
 * left. Initially `rest` is the whole line (trimmed for the separator ' '); its
 * text is NULL after the last field. */
bool ovr_next_field(ovr_line *rest, char separator, ovr_line *field);
/* Returns false if there are more fields than elements. */
bool ovr_split(ovr_line line, char separator, ovr_fields *fields);
/* Number of fields if all are numbers or missing values and at least one is a
 * number; 0 otherwise.  An empty field after the last separator is not
 * counted. */
size_t ovr_count_numbers(ovr_line line, ovr_layout layout);

/* Information from the header about one column. */
typedef struct ovr_column {
    char axis;        /* 'x', 'y', 'z', 'v' (valid), or 0 */
    bool scaled;      /* unit b (x) or b^2/R (z) */
    double metres;    /* unit of the column in metres; 0: unknown */
    ovr_line from;    /* text of the information */
    ovr_line unknown; /* unknown word where a unit is expected */
} ovr_column;

typedef struct ovr_header {
    size_t columns;
    ovr_column column[OVR_HEADER_FIELDS_MAX];
    bool stated; /* single column: unit given by "unit = um", not only by its
                  * heading */
    double spacing, spacing_metres; /* "spacing = 0.5 um"; 0: unknown */
    double width, height; /* "Width: 40 um": size of a map, m; 0: not stated */
    double value_metres;  /* "Value units: m"; 0: not stated */
} ovr_header;

/* Reads one line above the data. */
void ovr_header_line(ovr_header *header, ovr_line line, char separator);

#endif
