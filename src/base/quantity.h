/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Numbers with units, as people write them: "22 1/GPa", "40 mPa.s", "1.2 um".
 *
 * The whole text must be understood: a number in decimal notation with a
 * point (whatever the locale), then a unit of the dimension asked for or none.
 * NaN, infinities, hexadecimal, and numbers beyond the range of double are
 * refused.
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
    OVR_SHARE, /* a pure number, or in % */
    OVR_FORCE,
    OVR_LOAD, /* a line load, or a force that a width makes one */
    OVR_ROTATION,
    OVR_SURFACE_SPEED, /* a speed, or a rotation that a radius makes one */
    OVR_TEMPERATURE,
    OVR_KINEMATIC_VISCOSITY,
    OVR_MASS_DENSITY,
    OVR_KELVINS, /* a difference of temperatures */
    OVR_PER_KELVIN,
    OVR_CONDUCTIVITY,
    OVR_HEAT_CAPACITY,
    OVR_AREA,
    OVR_ANGLE,
    OVR_TORQUE,
    OVR_POWER,
    OVR_STIFFNESS, /* a force per way: in units of line loads */
    OVR_MASS,
    OVR_MESH_STIFFNESS, /* per width: N/(mm um) */
    OVR_SHEAR_RATE
} ovr_dimension;

typedef struct ovr_quantity {
    double value;     /* SI, or as written when there is no unit */
    const char *unit; /* as in the table of units; NULL: none */
} ovr_quantity;

/* Reads a whole text; `bare`: the unit may be missing.  The message states the
 * error and what is allowed, and is about "unit" when the unit is wrong or
 * missing. */
ovr_status ovr_quantity_read(const char *text, ovr_dimension dimension,
                             bool bare, ovr_quantity *quantity, ovr_error *err);

/* The dimension that a known unit measures; OVR_PURE: it is none. */
ovr_dimension ovr_unit_dimension(const char *unit);

/* SI value of 1 `unit`, if it is one of the dimension; else NAN. */
double ovr_unit_value(const char *unit, ovr_dimension dimension);

/* Metres in a unit of length as instruments write it, in small letters or
 * capitals ("um", "Microns", "inch", ...); 0: not one.  `bracketed` lets in
 * what is otherwise a word ("in"). */
double ovr_length_unit(ovr_line piece, bool bracketed);

/* The first unit of length of that size, "?" for none. */
const char *ovr_length_unit_name(double metres);

/* "Pa.s, mPa.s, cP", and the SI unit alone; "" for a pure number. */
const char *ovr_units_allowed(ovr_dimension dimension);
const char *ovr_unit_si(ovr_dimension dimension);

#endif
