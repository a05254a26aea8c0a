/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the columns of a text file that contain x and z, and their units. */
#ifndef OVR_SURFACE_COLUMNS_H
#define OVR_SURFACE_COLUMNS_H

#include "base/quantity.h"
#include "surface/profile.h"
#include "surface/table_line.h"

typedef struct ovr_text_table {
    ovr_profile *profile;
    const ovr_profile_source *source;
    ovr_bytes content; /* decoded content */
    ovr_lines data;    /* positioned at the first row */
    ovr_layout layout;
    ovr_header header;
    int x, z;       /* column numbers from 0; x = -1: spacing, or unknown */
    int valid;      /* column of validity flags (0: missing height); -1: none */
    double counted; /* number of rows announced by the file; NAN: none */
    long *number;   /* line number of each point */
} ovr_text_table;

/* Reads areal text: a matrix of heights, or points x y z on a regular grid
 * (read_map.c). The header has been read. If the text is neither, *found is
 * false and nothing changes. */
ovr_status ovr_read_text_map(ovr_text_table *table, bool *found,
                             ovr_error *err);

/* Returns the next data line, skipping comments and empty lines; false at the
 * end. */
bool ovr_next_row(ovr_lines *lines, ovr_line *line);

/* Sets the columns of x and z by name, by position, or from the caller's
 * options. */
ovr_status ovr_find_columns(ovr_text_table *table, ovr_error *err);

/* Reports all missing information in one error: columns, spacing, units. */
ovr_status ovr_check_given(const ovr_text_table *table, ovr_error *err);

/* Returns the caller's unit in metres; 0 if it is unknown. For b of 'x' and
 * b^2/R of 'z', returns 1 and sets *scaled. */
double ovr_unit_given(char axis, const char *asked, bool *scaled);

/* Determines the unit of axis 'x' or 'z', which must be known: the caller's,
 * otherwise the header's. Adds a note. */
void ovr_find_unit(ovr_text_table *table, char axis, const char *asked,
                   double *metres, bool *scaled);

#endif
