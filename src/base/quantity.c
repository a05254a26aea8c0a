/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/quantity.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Factors are kept as times/over, one of them 1, so that 17 1/GPa is the
 * double nearest to 1.7e-8 and not a product of roundings. */
static const struct unit {
    const char *name;
    ovr_dimension dimension;
    double times, over;
} units[] = {
    {"m", OVR_LENGTH, 1, 1},
    {"mm", OVR_LENGTH, 1, 1e3},
    {"um", OVR_LENGTH, 1, 1e6},
    {"\302\265m", OVR_LENGTH, 1, 1e6}, /* micro sign, Greek mu, Latin-1 */
    {"\316\274m", OVR_LENGTH, 1, 1e6},
    {"\265m", OVR_LENGTH, 1, 1e6},
    {"nm", OVR_LENGTH, 1, 1e9},
    {"Pa", OVR_PRESSURE, 1, 1},
    {"kPa", OVR_PRESSURE, 1e3, 1},
    {"MPa", OVR_PRESSURE, 1e6, 1},
    {"GPa", OVR_PRESSURE, 1e9, 1},
    {"1/Pa", OVR_PER_PRESSURE, 1, 1},
    {"Pa^-1", OVR_PER_PRESSURE, 1, 1},
    {"1/MPa", OVR_PER_PRESSURE, 1, 1e6},
    {"MPa^-1", OVR_PER_PRESSURE, 1, 1e6},
    {"1/GPa", OVR_PER_PRESSURE, 1, 1e9},
    {"GPa^-1", OVR_PER_PRESSURE, 1, 1e9},
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
    {"\302\265s", OVR_DURATION, 1, 1e6},
    {"\316\274s", OVR_DURATION, 1, 1e6},
};
enum { UNITS = sizeof units / sizeof units[0] };

const char *ovr_units_allowed(ovr_dimension dimension)
{
    switch (dimension) {
    case OVR_PURE: break;
    case OVR_LENGTH: return "m, mm, um, nm";
    case OVR_PRESSURE: return "Pa, kPa, MPa, GPa";
    case OVR_PER_PRESSURE: return "1/Pa, 1/MPa, 1/GPa";
    case OVR_DYNAMIC_VISCOSITY: return "Pa.s, mPa.s, cP";
    case OVR_LINE_LOAD: return "N/m, kN/m, N/mm";
    case OVR_SPEED: return "m/s, mm/s";
    case OVR_DURATION: return "s, ms, us";
    }
    return "";
}

const char *ovr_unit_si(ovr_dimension dimension)
{
    for (int i = 0; i < UNITS; i++) /* SI comes first in each dimension */
        if (units[i].dimension == dimension)
            return units[i].name;
    return "";
}

static const struct unit *find_unit(const char *name)
{
    for (int i = 0; i < UNITS; i++)
        if (!strcmp(units[i].name, name))
            return &units[i];
    return NULL;
}

double ovr_unit_value(const char *unit, ovr_dimension dimension)
{
    const struct unit *u = find_unit(unit);
    return u && u->dimension == dimension ? u->times / u->over : NAN;
}

/* ---------------------------------------------------------------- numbers */

static const char *skip_digits(const char *s)
{
    while (*s >= '0' && *s <= '9')
        s++;
    return s;
}

/* End of [+-] digits [. digits] [e [+-] digits], or NULL. */
static const char *number_end(const char *s)
{
    const char *from, *point, *exponent;
    if (*s == '+' || *s == '-')
        s++;
    from = s;
    s = point = skip_digits(s);
    if (*s == '.')
        s = skip_digits(s + 1);
    if (s - from == (*point == '.')) /* no digit on either side */
        return NULL;
    if (*s != 'e' && *s != 'E')
        return s;
    exponent = s + 1 + (s[1] == '+' || s[1] == '-');
    return skip_digits(exponent) > exponent ? skip_digits(exponent) : s;
}

/* strtod, with a point for a point in every locale. */
static double convert(const char *s)
{
    locale_t plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    locale_t users;
    double value;
    if (plain == (locale_t)0)
        return NAN;
    users = uselocale(plain);
    value = strtod(s, NULL);
    uselocale(users);
    freelocale(plain);
    return value;
}

static bool has_digits(const char *s, const char *end)
{
    for (; s < end && *s != 'e' && *s != 'E'; s++)
        if (*s >= '1' && *s <= '9')
            return true;
    return false;
}

bool ovr_read_number(const char **text, double *value)
{
    char copy[64];
    const char *end = number_end(*text);
    size_t length = end ? (size_t)(end - *text) : 0;
    if (!end || length >= sizeof copy)
        return false;
    memcpy(copy, *text, length);
    copy[length] = '\0';
    *value = convert(copy);
    if (!isfinite(*value) || (*value == 0 && has_digits(copy, copy + length)))
        return false;
    *text = end;
    return true;
}

/* ------------------------------------------------------------- quantities */

static ovr_status no_number(const char *text, ovr_error *err)
{
    if (number_end(text))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' is beyond the range of numbers", text);
    return ovr_fail(err, OVR_BAD_INPUT, "'%.60s' is not a number", text);
}

static ovr_status wrong_unit(const char *text, const char *unit,
                             ovr_dimension dimension, ovr_error *err)
{
    if (*unit == ',')
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' is not a number: write a point, not a comma",
                        text);
    if (dimension == OVR_PURE)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.60s' must be a number without a unit", text);
    return ovr_fail_about(err, "unit", "'%.60s': %s unit '%.30s'; allowed: %s",
                          text, find_unit(unit) ? "wrong" : "unknown", unit,
                          ovr_units_allowed(dimension));
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
    if (!*at && (bare || dimension == OVR_PURE))
        return OVR_OK;
    if (!*at)
        return ovr_fail_about(err, "unit", "'%.60s' needs a unit; allowed: %s",
                              text, ovr_units_allowed(dimension));
    unit = find_unit(at);
    if (!unit || unit->dimension != dimension || dimension == OVR_PURE)
        return wrong_unit(text, at, dimension, err);
    quantity->value = value * unit->times / unit->over;
    quantity->unit = unit->name;
    if (isfinite(quantity->value))
        return OVR_OK;
    return no_number(text, err);
}
