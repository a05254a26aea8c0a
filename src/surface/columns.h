/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds the columns of a text that hold x and z, and their units. */
#ifndef OVR_SURFACE_COLUMNS_H
#define OVR_SURFACE_COLUMNS_H

#include "base/quantity.h"
#include "surface/profile.h"
#include "surface/table_line.h"

typedef struct ovr_text_table {
    ovr_profile *profile;
    const ovr_profile_source *source;
    ovr_bytes content; /* decoded */
    ovr_lines data;    /* at the first row */
    ovr_layout layout;
    ovr_header header;
    int x, z;       /* columns from 0; x = -1: spacing, or not known */
    int valid;      /* column of 1 and 0, 0: the height is missing; -1: none */
    double counted; /* a count line's number; NAN: none */
    long *number;   /* line of each point */
} ovr_text_table;

/* Areal text: a matrix of heights, or points x y z on a regular grid
 * (read_map.c).  The data and the header are known; *found is false, and
 * nothing done, if it is neither. */
ovr_status ovr_read_text_map(ovr_text_table *table, bool *found,
                             ovr_error *err);

/* The next line of data, without comments and empty lines; false: none. */
bool ovr_next_row(ovr_lines *lines, ovr_line *line);

/* Sets x and z by name, by place, or as the caller says. */
ovr_status ovr_find_columns(ovr_text_table *table, ovr_error *err);

/* Reports all missing information in one error: columns, spacing, units. */
ovr_status ovr_check_given(const ovr_text_table *table, ovr_error *err);

/* Metres in the unit named by the caller (1 for b of 'x' and b^2/R of 'z',
 * which set *scaled); 0: unknown. */
double ovr_unit_given(char axis, const char *asked, bool *scaled);

/* The unit of axis 'x' or 'z', which is known: that of the caller, otherwise of
 * the header; the choice is noted. */
void ovr_find_unit(ovr_text_table *table, char axis, const char *asked,
                   double *metres, bool *scaled);

#endif
