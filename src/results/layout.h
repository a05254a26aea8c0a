/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Quantities of a result file and their units. A file is in SI if b, p_h, b^2/R
 * and b/u_m are all known. Otherwise all quantities scaled by them are
 * dimensionless with unit "1". stored = dimensionless * factor.
 */
#ifndef OVR_RESULTS_LAYOUT_H
#define OVR_RESULTS_LAYOUT_H

#include "overroll/results.h"

enum {
    OVR_FORMAT_VERSION = 2,
    OVR_FORMAT_STRIP = 3, /* fields are (time, y, x) */
    OVR_FIELDS_MAX = 32
};

/* Return the number of history columns for these physical models, or of fields
 * in a set, and store them in file order in `rows` unless it is NULL. */
size_t ovr_layout_columns(unsigned physics, const ovr_observable **rows);
size_t ovr_layout_fields(unsigned set, const ovr_observable **rows);

typedef struct ovr_scales {
    bool physical;
    ovr_contact contact;
} ovr_scales;

ovr_scales ovr_scales_of(const ovr_contact *contact);

/* Return the factor from dimensionless to stored numbers, and the unit of the
 * stored numbers. */
double ovr_factor(const ovr_scales *scales, ovr_unit_kind kind);
const char *ovr_unit(const ovr_scales *scales, ovr_unit_kind kind);

#endif
