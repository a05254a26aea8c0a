/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * An axis is drawn in a Hertzian scale, or in a unit whose prefix suits the
 * numbers.
 */
#ifndef OVR_PICTURES_AXIS_H
#define OVR_PICTURES_AXIS_H

#include "overroll/results.h"

typedef struct ovr_axis {
    double factor;     /* from the Hertzian number to the one drawn */
    const char *label; /* enhanced text of gnuplot: "time, {/:Italic t} (s)" */
    const char *plain; /* the same without markup: "time, t (s)" */
    const char *unit;  /* "mm"; "" when Hertzian */
} ovr_axis;

/* Kinds that have a symbol: length, pressure, height and time. */
bool ovr_axis_has(ovr_unit_kind kind);

/* Makes an axis of one of these.  `largest` is the largest Hertzian number that
 * the axis will show. */
ovr_status ovr_axis_make(ovr_unit_kind kind, ovr_result *result,
                         ovr_units units, double largest, ovr_axis *axis,
                         ovr_error *err);

/* The largest magnitude of n numbers, those that are NAN left out. */
double ovr_axis_reach(const double *values, size_t n);

/* The same for numbers in SI, or bare ones, as they are. */
void ovr_axis_as_is(ovr_unit_kind kind, bool si, double largest,
                    ovr_axis *axis);

#endif
