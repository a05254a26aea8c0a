/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What stands in a result file: the fields, what scales each kind of
 * quantity, and its unit.
 *
 * Kinds are those of ovr_observable, and two more:
 *     'X' b    'H' b^2/R    'P' ph    'T' b/um    '1' pure number
 *     'E' viscosity, eta0   'Q' flow per unit width, um b^2/R
 *     'i' integer           'b' flag
 * A file is in SI when b, ph, b^2/R and b/um are all known, else everything
 * is dimensionless with unit "1".  stored = dimensionless * factor.
 */
#ifndef OVR_RESULTS_LAYOUT_H
#define OVR_RESULTS_LAYOUT_H

#include <stdbool.h>
#include <stddef.h>

#include "overroll/contact.h"

enum { OVR_FORMAT_VERSION = 1, OVR_FIELD_COUNT = 7 };

typedef struct ovr_field {
    const char *name, *long_name;
    char kind;
    unsigned bit; /* OVR_FIELD_... */
} ovr_field;

/* All fields, in the order in which they are written. */
extern const ovr_field ovr_field_table[OVR_FIELD_COUNT];

typedef struct ovr_scales {
    bool physical;
    ovr_contact contact;
} ovr_scales;

ovr_scales ovr_scales_of(const ovr_contact *contact);

/* SI value of the dimensionless 1, NAN where unknown, 1 for pure numbers. */
double ovr_scale(const ovr_scales *scales, char kind);

/* What the stored number is the dimensionless one times, and its unit. */
double ovr_factor(const ovr_scales *scales, char kind);
const char *ovr_unit(const ovr_scales *scales, char kind);

#endif
