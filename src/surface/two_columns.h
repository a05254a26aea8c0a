/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Text files of two columns of numbers, the first of which increases: time
 * histories, cam lifts, load shares, lubricant laws, asperity contact laws, and
 * stresses or fatigue limits as functions of depth.
 *
 * Separators, decimal commas and encodings are those of profiles
 * (table_line.h); the form of the first row applies to all rows. "#" begins a
 * comment; empty lines are ignored. Lines before the numbers, including
 * comments, may name the units in the order of the columns, for example
 * "pressure [MPa], density [kg/m3]".
 */
#ifndef OVR_SURFACE_TWO_COLUMNS_H
#define OVR_SURFACE_TWO_COLUMNS_H

#include "base/quantity.h"

typedef struct ovr_two_columns {
    const char *name[2];     /* "time", "value" */
    double minimum, maximum; /* range of the second column; 0, 0: any */
    const char *of;          /* unit of the range for messages */
    double unit[2];          /* factors of the numbers */
    /* Dimensions of the units in the header, and an example of a header;
     * OVR_PURE, NULL: no header. */
    ovr_dimension header[2];
    const char *example;
    bool optional;   /* without units in a header, `unit` is used */
    bool named;      /* the header names units */
    size_t count;    /* rows read */
    double *x, *y;   /* in the arena */
    long *line;      /* line number of each row */
    double rounding; /* smallest decimal of the second column as written, times
                      * its unit */
} ovr_two_columns;

ovr_status ovr_two_columns_read(ovr_two_columns *columns, const char *file,
                                ovr_bytes content, ovr_arena *arena,
                                ovr_error *err);

#endif
