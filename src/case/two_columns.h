/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Text files of two columns of numbers: histories, lifts of cams, shares of
 * load, measured viscosities, densities and flow curves.  Columns are set apart
 * by blanks, commas or semicolons; "#" begins a comment; empty lines do not
 * count.  The first line may have to name the units, in the order of the
 * columns, whichever that is: "pressure [MPa], density [kg/m3]". */
#ifndef OVR_CASE_TWO_COLUMNS_H
#define OVR_CASE_TWO_COLUMNS_H

#include "base/arena.h"
#include "case/case.h"

typedef struct ovr_two_columns {
    const char *name[2];     /* "time", "value" */
    double minimum, maximum; /* range of the second column as written; 0, 0:
                              * any */
    const char *of;          /* unit of the range for messages, or "" */
    double unit[2];          /* factors of the numbers */
    /* Dimensions of the units in the header, and an example of a unit;
     * OVR_PURE, NULL: no header. */
    ovr_dimension header[2];
    const char *example;
    /* Lines before the numbers, including comments, may name the units;
     * otherwise `unit` is used. */
    bool optional;
    bool named;      /* units were named */
    size_t count;    /* rows read */
    double *x, *y;   /* in the arena */
    double rounding; /* smallest decimal of the second column as written, times
                      * its unit */
} ovr_two_columns;

/* Reads a file. `slot` is the key that names it. */
ovr_status ovr_two_columns_read(ovr_two_columns *columns, const char *file,
                                const ovr_slot *slot, ovr_arena *arena,
                                ovr_error *err);

#endif
