/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A line of a table cut into fields, and what a table's header says. */
#ifndef OVR_SURFACE_TABLE_LINE_H
#define OVR_SURFACE_TABLE_LINE_H

#include "base/text.h"

enum { OVR_HEADER_FIELDS_MAX = 64 };

typedef struct ovr_fields {
    size_t count;
    bool open; /* the line ended with a separator: one more, empty */
    ovr_line field[OVR_HEADER_FIELDS_MAX];
} ovr_fields;

typedef struct ovr_layout {
    char separator; /* ';' ',' '\t', or ' ' for any blanks */
    bool comma;     /* decimal comma */
} ovr_layout;

ovr_layout ovr_layout_of(ovr_line line);
/* false: more fields than there is space for. */
bool ovr_split(ovr_line line, char separator, ovr_fields *fields);
/* All fields are numbers or missing values, at least one is a number. */
bool ovr_all_numbers(const ovr_fields *fields, bool comma);

/* The header says this of one column. */
typedef struct ovr_column {
    char axis;        /* 'x', 'y', 'z', or 0 */
    bool scaled;      /* unit b (x) or b^2/R (z) */
    double metres;    /* its unit; 0: not said */
    ovr_line from;    /* where it is said, or what else is */
    ovr_line unknown; /* a word in the place of the unit that is none */
} ovr_column;

typedef struct ovr_header {
    size_t columns;
    ovr_column column[OVR_HEADER_FIELDS_MAX];
    bool stated; /* of a single column: by "unit = um", not only named */
    double spacing, spacing_metres; /* "spacing = 0.5 um"; 0: not said */
} ovr_header;

/* Takes in one line above the data. */
void ovr_header_line(ovr_header *header, ovr_line line, char separator);

#endif
