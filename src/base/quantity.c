/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/quantity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "overroll/text.h"

/* Factors are stored as numerator `times` and denominator `over`, one of which
 * is 1. Thus 17 1/GPa is the double nearest to 1.7e-8, without the rounding
 * errors of a product. */
static const struct unit {
    const char *name;
    ovr_dimension dimension;
    double times, over;
} units[] = {
    {"m", OVR_LENGTH, 1, 1},
    {"metre", OVR_LENGTH, 1, 1},
    {"metres", OVR_LENGTH, 1, 1},
    {"meter", OVR_LENGTH, 1, 1},
    {"meters", OVR_LENGTH, 1, 1},
    {"cm", OVR_LENGTH, 1, 1e2},
    {"mm", OVR_LENGTH, 1, 1e3},
    {"millimetre", OVR_LENGTH, 1, 1e3},
    {"millimetres", OVR_LENGTH, 1, 1e3},
    {"millimeter", OVR_LENGTH, 1, 1e3},
    {"millimeters", OVR_LENGTH, 1, 1e3},
    {"um", OVR_LENGTH, 1, 1e6},
    {"mum", OVR_LENGTH, 1, 1e6},
    {"micron", OVR_LENGTH, 1, 1e6},
    {"microns", OVR_LENGTH, 1, 1e6},
    {"micrometre", OVR_LENGTH, 1, 1e6},
    {"micrometres", OVR_LENGTH, 1, 1e6},
    {"micrometer", OVR_LENGTH, 1, 1e6},
    {"micrometers", OVR_LENGTH, 1, 1e6},
    {"nm", OVR_LENGTH, 1, 1e9},
    {"nanometre", OVR_LENGTH, 1, 1e9},
    {"nanometres", OVR_LENGTH, 1, 1e9},
    {"nanometer", OVR_LENGTH, 1, 1e9},
    {"nanometers", OVR_LENGTH, 1, 1e9},
    {"pm", OVR_LENGTH, 1, 1e12},
    {"angstrom", OVR_LENGTH, 1, 1e10},
    {"angstroms", OVR_LENGTH, 1, 1e10},
    {"inch", OVR_LENGTH, 0.0254, 1},
    {"inches", OVR_LENGTH, 0.0254, 1},
    {"mil", OVR_LENGTH, 2.54e-5, 1},
    {"mils", OVR_LENGTH, 2.54e-5, 1},
    {"uin", OVR_LENGTH, 2.54e-8, 1},
    {"microinch", OVR_LENGTH, 2.54e-8, 1},
    {"microinches", OVR_LENGTH, 2.54e-8, 1},
    {"Pa", OVR_PRESSURE, 1, 1},
    {"kPa", OVR_PRESSURE, 1e3, 1},
    {"MPa", OVR_PRESSURE, 1e6, 1},
    {"GPa", OVR_PRESSURE, 1e9, 1},
    {"N/mm2", OVR_PRESSURE, 1e6, 1},
    {"N/mm^2", OVR_PRESSURE, 1e6, 1},
    {"N/mm\302\262", OVR_PRESSURE, 1e6, 1}, /* superscript two */
    {"kN/mm2", OVR_PRESSURE, 1e9, 1},
    {"kN/mm^2", OVR_PRESSURE, 1e9, 1},
    {"kN/mm\302\262", OVR_PRESSURE, 1e9, 1},
    {"1/Pa", OVR_PER_PRESSURE, 1, 1},
    {"Pa^-1", OVR_PER_PRESSURE, 1, 1},
    {"1/MPa", OVR_PER_PRESSURE, 1, 1e6},
    {"MPa^-1", OVR_PER_PRESSURE, 1, 1e6},
    {"1/GPa", OVR_PER_PRESSURE, 1, 1e9},
    {"GPa^-1", OVR_PER_PRESSURE, 1, 1e9},
    {"mm2/N", OVR_PER_PRESSURE, 1, 1e6},
    {"mm^2/N", OVR_PER_PRESSURE, 1, 1e6},
    {"mm\302\262/N", OVR_PER_PRESSURE, 1, 1e6},
    {"mm3/Nm", OVR_PER_PRESSURE, 1, 1e9}, /* wear */
    {"mm3/N.m", OVR_PER_PRESSURE, 1, 1e9},
    {"mm^3/Nm", OVR_PER_PRESSURE, 1, 1e9},
    {"Pa.s", OVR_DYNAMIC_VISCOSITY, 1, 1},
    {"Pa s", OVR_DYNAMIC_VISCOSITY, 1, 1},
    {"Pa*s", OVR_DYNAMIC_VISCOSITY, 1, 1},
    {"mPa.s", OVR_DYNAMIC_VISCOSITY, 1, 1e3},
    {"mPa s", OVR_DYNAMIC_VISCOSITY, 1, 1e3},
    {"mPa*s", OVR_DYNAMIC_VISCOSITY, 1, 1e3},
    {"cP", OVR_DYNAMIC_VISCOSITY, 1, 1e3},
    {"N/m", OVR_LINE_LOAD, 1, 1},
    {"kN/m", OVR_LINE_LOAD, 1e3, 1},
    {"N/mm", OVR_LINE_LOAD, 1e3, 1},
    {"m/s", OVR_SPEED, 1, 1},
    {"mm/s", OVR_SPEED, 1, 1e3},
    {"s", OVR_DURATION, 1, 1},
    {"ms", OVR_DURATION, 1, 1e3},
    {"us", OVR_DURATION, 1, 1e6},
    {"%", OVR_SHARE, 1, 1e2},
    {"N", OVR_FORCE, 1, 1},
    {"kN", OVR_FORCE, 1e3, 1},
    {"rad/s", OVR_ROTATION, 1, 1},
    {"rpm", OVR_ROTATION, 0.10471975511965977, 1}, /* 2 pi/60 */
    {"1/min", OVR_ROTATION, 0.10471975511965977, 1},
    {"K", OVR_TEMPERATURE, 1, 1},
    {"degC", OVR_TEMPERATURE, 1, 1}, /* above the melting point of ice */
    {"\302\260C", OVR_TEMPERATURE, 1, 1},
    {"m2/s", OVR_KINEMATIC_VISCOSITY, 1, 1},
    {"mm2/s", OVR_KINEMATIC_VISCOSITY, 1, 1e6},
    {"mm^2/s", OVR_KINEMATIC_VISCOSITY, 1, 1e6},
    {"mm\302\262/s", OVR_KINEMATIC_VISCOSITY, 1, 1e6},
    {"cSt", OVR_KINEMATIC_VISCOSITY, 1, 1e6},
    {"kg/m3", OVR_MASS_DENSITY, 1, 1},
    {"kg/m^3", OVR_MASS_DENSITY, 1, 1},
    {"g/cm3", OVR_MASS_DENSITY, 1e3, 1},
    {"g/cm^3", OVR_MASS_DENSITY, 1e3, 1},
    {"g/ml", OVR_MASS_DENSITY, 1e3, 1},
    {"1/K", OVR_PER_KELVIN, 1, 1},
    {"W/m.K", OVR_CONDUCTIVITY, 1, 1},
    {"W/(m.K)", OVR_CONDUCTIVITY, 1, 1},
    {"J/kg.K", OVR_HEAT_CAPACITY, 1, 1},
    {"J/(kg.K)", OVR_HEAT_CAPACITY, 1, 1},
    {"kJ/kg.K", OVR_HEAT_CAPACITY, 1e3, 1},
    {"m2", OVR_AREA, 1, 1},
    {"m^2", OVR_AREA, 1, 1},
    {"mm2", OVR_AREA, 1, 1e6},
    {"mm^2", OVR_AREA, 1, 1e6},
    {"um2", OVR_AREA, 1, 1e12},
    {"um^2", OVR_AREA, 1, 1e12},
    {"rad", OVR_ANGLE, 1, 1},
    {"deg", OVR_ANGLE, 0.017453292519943295, 1},
    {"\302\260", OVR_ANGLE, 0.017453292519943295, 1},
    {"N.m", OVR_TORQUE, 1, 1},
    {"Nm", OVR_TORQUE, 1, 1},
    {"kN.m", OVR_TORQUE, 1e3, 1},
    {"kNm", OVR_TORQUE, 1e3, 1},
    {"W", OVR_POWER, 1, 1},
    {"kW", OVR_POWER, 1e3, 1},
    {"kg", OVR_MASS, 1, 1},
    {"g", OVR_MASS, 1, 1e3},
    {"N/m2", OVR_MESH_STIFFNESS, 1, 1},
    {"N/mm.um", OVR_MESH_STIFFNESS, 1e9, 1},
    {"N/(mm.um)", OVR_MESH_STIFFNESS, 1e9, 1},
    {"1/s", OVR_SHEAR_RATE, 1, 1},
    {"s^-1", OVR_SHEAR_RATE, 1, 1},
};
enum { UNITS = sizeof units / sizeof units[0] };

const char *ovr_units_allowed(ovr_dimension dimension)
{
    switch (dimension) {
    case OVR_PURE:
    case OVR_SHARE: break;
    case OVR_LENGTH: return "m, mm, um, nm";
    case OVR_PRESSURE: return "Pa, kPa, MPa, GPa, N/mm2";
    case OVR_PER_PRESSURE: return "1/Pa, 1/MPa, 1/GPa, mm2/N, mm3/Nm";
    case OVR_DYNAMIC_VISCOSITY: return "Pa.s, mPa.s, cP";
    case OVR_LINE_LOAD: return "N/m, kN/m, N/mm";
    case OVR_LOAD: return "N/m, kN/m, N/mm; N, kN with a width";
    case OVR_SPEED: return "m/s, mm/s";
    case OVR_SURFACE_SPEED: return "m/s, mm/s; rpm with the body's radius";
    case OVR_FORCE: return "N, kN";
    case OVR_ROTATION: return "rad/s, rpm";
    case OVR_TEMPERATURE: return "K, degC";
    case OVR_KINEMATIC_VISCOSITY: return "m2/s, mm2/s, cSt";
    case OVR_MASS_DENSITY: return "kg/m3, g/cm3";
    case OVR_KELVINS: return "K";
    case OVR_PER_KELVIN: return "1/K";
    case OVR_CONDUCTIVITY: return "W/m.K";
    case OVR_HEAT_CAPACITY: return "J/kg.K, kJ/kg.K";
    case OVR_AREA: return "m2, mm2, um2";
    case OVR_DURATION: return "s, ms, us";
    case OVR_ANGLE: return "rad, deg";
    case OVR_TORQUE: return "N.m, kN.m";
    case OVR_POWER: return "W, kW";
    case OVR_STIFFNESS: return "N/m, kN/m, N/mm";
    case OVR_MASS: return "kg, g";
    case OVR_MESH_STIFFNESS: return "N/m2, N/mm.um";
    case OVR_SHEAR_RATE: return "1/s";
    }
    return "";
}

/* True if a quantity with this unit can be converted to the target: loads and
 * speeds may be given by other quantities. */
static bool leads_to(const struct unit *unit, ovr_dimension target)
{
    ovr_dimension is = unit->dimension;
    if (target == OVR_LOAD)
        return is == OVR_LINE_LOAD || is == OVR_FORCE;
    if (target == OVR_SURFACE_SPEED)
        return is == OVR_SPEED || is == OVR_ROTATION;
    if (target == OVR_STIFFNESS)
        return is == OVR_LINE_LOAD; /* has the same units */
    if (target == OVR_KELVINS)
        return is == OVR_TEMPERATURE && !strcmp(unit->name, "K");
    return is == target;
}

const char *ovr_unit_si(ovr_dimension dimension)
{
    if (dimension == OVR_LOAD || dimension == OVR_STIFFNESS)
        dimension = OVR_LINE_LOAD;
    if (dimension == OVR_SURFACE_SPEED)
        dimension = OVR_SPEED;
    if (dimension == OVR_KELVINS)
        dimension = OVR_TEMPERATURE;
    for (int i = 0; i < UNITS; i++) /* SI comes first in each dimension */
        if (units[i].dimension == dimension && dimension != OVR_SHARE)
            return units[i].name;
    return "";
}

const char *ovr_unit_name(size_t k, const char **si)
{
    if (!si)
        return NULL;
    if (k >= UNITS)
        return NULL;
    *si = ovr_unit_si(units[k].dimension);
    if (!**si)
        *si = units[k].name;
    return units[k].name;
}

static const struct unit *find_unit(const char *name)
{
    char buffer[16];
    ovr_line u = ovr_spelled((ovr_line){name, strlen(name), 0}, buffer);
    for (int i = 0; i < UNITS; i++)
        if (strlen(units[i].name) == u.size &&
            ovr_line_starts(u, units[i].name))
            return &units[i];
    return NULL;
}

ovr_dimension ovr_unit_dimension(const char *unit)
{
    const struct unit *u = find_unit(unit);
    return u ? u->dimension : OVR_PURE;
}

double ovr_unit_value(const char *unit, ovr_dimension dimension)
{
    const struct unit *u = find_unit(unit);
    return u && u->dimension == dimension ? u->times / u->over : NAN;
}

double ovr_length_unit(ovr_line piece, bool bracketed)
{
    char buffer[16];
    piece = ovr_spelled(piece, buffer);
    if (piece.size == 1 && piece.text[0] != 'm')
        return 0; /* M means mega */
    if (bracketed && ovr_line_is(piece, "in"))
        return 0.0254;
    for (int k = 0; k < UNITS; k++)
        if (units[k].dimension == OVR_LENGTH &&
            ovr_line_is(piece, units[k].name))
            return units[k].times / units[k].over;
    return 0;
}

const char *ovr_length_unit_name(double metres)
{
    for (int k = 0; k < UNITS; k++)
        if (units[k].dimension == OVR_LENGTH &&
            units[k].times / units[k].over == metres)
            return units[k].name;
    return "?";
}

/* ------------------------------------------------------------- quantities */

static ovr_status no_number(const char *text, ovr_error *err)
{
    const char *digit = text + (*text == '+' || *text == '-');
    digit += *digit == '.';
    if (*digit >= '0' && *digit <= '9')
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' is beyond the range of numbers", text);
    return ovr_fail(err, OVR_BAD_INPUT, "'%.60s' is not a number", text);
}

/* Returns the unit with the same end as the given one: degC for C. */
static const char *with_ending(const char *unit, const char *const *names,
                               size_t n)
{
    size_t size = strlen(unit);
    for (size_t k = 0; k < n; k++) {
        size_t length = strlen(names[k]);
        if (size && length > size && !strcmp(names[k] + length - size, unit))
            return names[k];
    }
    return NULL;
}

/* Writes " did you mean 'MPa'?" and returns the unit; nothing and NULL if no
 * unit is similar. */
static const char *write_hint(const char *unit, ovr_dimension dimension,
                              char *hint, size_t capacity)
{
    const char *names[UNITS], *meant;
    size_t n = 0;
    for (int i = 0; i < UNITS; i++)
        if (leads_to(&units[i], dimension))
            names[n++] = units[i].name;
    meant = ovr_suggest(unit, names, n);
    if (!meant && dimension == OVR_TEMPERATURE)
        meant = with_ending(unit, names, n);
    *hint = '\0';
    if (meant)
        snprintf(hint, capacity, " did you mean '%s'?", meant);
    return meant;
}

static ovr_status wrong_unit(const char *text, const char *unit,
                             ovr_dimension dimension, ovr_error *err)
{
    char hint[60];
    const char *meant;
    if (*unit == ',' && unit[1] == ' ')
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' is a list; one number is expected", text);
    if (*unit == ',')
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' is not a number: write a point, not a comma",
                        text);
    if (dimension == OVR_PURE || dimension == OVR_SHARE)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' must be a number without a unit%s", text,
                        dimension == OVR_SHARE ? ", or in %" : "");
    meant = write_hint(unit, dimension, hint, sizeof hint);
    ovr_fail_about(err, "unit", "'%.60s': %s unit '%.30s';%s allowed: %s", text,
                   find_unit(unit) ? "wrong" : "unknown", unit, hint,
                   ovr_units_allowed(dimension));
    return ovr_fail_meant(err, OVR_BAD_INPUT, meant);
}

ovr_status ovr_quantity_read(const char *text, ovr_dimension dimension,
                             bool bare, ovr_quantity *quantity, ovr_error *err)
{
    const char *at = text;
    const struct unit *unit;
    double value;
    if (!*text)
        return ovr_fail(err, OVR_BAD_INPUT, "a number is missing");
    if (!ovr_read_number(&at, &value))
        return no_number(text, err);
    while (*at == ' ' || *at == '\t')
        at++;
    quantity->value = value;
    quantity->unit = NULL;
    if (!*at && (bare || dimension == OVR_PURE || dimension == OVR_SHARE))
        return OVR_OK;
    if (!*at)
        return ovr_fail_about(err, "unit", "'%.60s' needs a unit; allowed: %s",
                              text, ovr_units_allowed(dimension));
    unit = find_unit(at);
    if (!unit || !leads_to(unit, dimension) || dimension == OVR_PURE)
        return wrong_unit(text, at, dimension, err);
    quantity->value = value * unit->times / unit->over;
    if (dimension == OVR_TEMPERATURE && strcmp(unit->name, "K") != 0)
        quantity->value = value + 273.15;
    quantity->unit = dimension == OVR_SHARE ? NULL : unit->name;
    if (isfinite(quantity->value))
        return OVR_OK;
    return no_number(text, err);
}
