/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parser for numbers with units: "22 1/GPa", "40 mPa.s", "1.2 um".
 *
 * The whole text must be valid: a number in decimal notation with a point (in
 * every locale), then a unit of the required dimension or none. NaN,
 * infinities, hexadecimal numbers and numbers outside the range of double are
 * rejected.
 */
#ifndef OVR_BASE_QUANTITY_H
#define OVR_BASE_QUANTITY_H

#include <stdbool.h>
#include <stddef.h>

#include "base/text.h"

typedef enum ovr_dimension {
    OVR_PURE, /* no unit */
    OVR_LENGTH,
    OVR_PRESSURE,
    OVR_PER_PRESSURE,
    OVR_DYNAMIC_VISCOSITY,
    OVR_LINE_LOAD,
    OVR_SPEED,
    OVR_DURATION,
    OVR_SHARE, /* a number without unit, or in % */
    OVR_FORCE,
    OVR_LOAD, /* line load, or a force to be divided by the width */
    OVR_ROTATION,
    OVR_SURFACE_SPEED, /* speed, or a rotational speed to be multiplied by a
                        * radius */
    OVR_TEMPERATURE,
    OVR_KINEMATIC_VISCOSITY,
    OVR_MASS_DENSITY,
    OVR_KELVINS, /* temperature difference */
    OVR_PER_KELVIN,
    OVR_CONDUCTIVITY,
    OVR_HEAT_CAPACITY,
    OVR_AREA,
    OVR_ANGLE,
    OVR_TORQUE,
    OVR_POWER,
    OVR_STIFFNESS, /* force per displacement; units of line loads */
    OVR_MASS,
    OVR_MESH_STIFFNESS, /* stiffness per width, N/(mm um) */
    OVR_SHEAR_RATE
} ovr_dimension;

typedef struct ovr_quantity {
    double value;     /* SI, or as written if there is no unit */
    const char *unit; /* as in the table of units; NULL: none */
} ovr_quantity;

/* Parses a complete text; `bare`: the unit may be missing. The message states
 * the error and the allowed units, and is about "unit" if the unit is wrong or
 * missing. */
ovr_status ovr_quantity_read(const char *text, ovr_dimension dimension,
                             bool bare, ovr_quantity *quantity, ovr_error *err);

/* Returns the dimension of `unit`, or OVR_PURE if the unit is unknown. */
ovr_dimension ovr_unit_dimension(const char *unit);

/* Returns the SI value of 1 `unit` if it has this dimension; otherwise NAN. */
double ovr_unit_value(const char *unit, ovr_dimension dimension);

/* Returns a unit of length, as written by instruments in any case ("um",
 * "Microns", "inch", ...), in metres; 0 if unknown. `bracketed`: also accepts
 * units that are usual words ("in"). */
double ovr_length_unit(ovr_line piece, bool bracketed);

/* Returns the first unit of length of this size, or "?". */
const char *ovr_length_unit_name(double metres);

/* Return "Pa.s, mPa.s, cP", and only the SI unit; "" for a number without a
 * unit. */
const char *ovr_units_allowed(ovr_dimension dimension);
const char *ovr_unit_si(ovr_dimension dimension);

#endif
