/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "12 um", "0.3 b" or a bare number: a length of a profile. */
#include <string.h>

#include "base/given.h"
#include "base/quantity.h"
#include "overroll/profile.h"

static bool is_scaled(const char *unit, const char *scaled)
{
    return !strcmp(unit, scaled) ||
           (!strcmp(scaled, "b^2/R") && !strcmp(unit, "b2/R"));
}

ovr_status ovr_length_read(const char *text, const char *scaled,
                           ovr_length *length, ovr_error *err)
{
    if (!text)
        return ovr_fail_null(err, __func__);
    size_t digits = strspn(text, " +-0123456789.");
    ovr_line unit;
    double metres;
    if (text[digits] == 'e' || text[digits] == 'E')
        digits += strspn(text + digits, "eE+-0123456789");
    unit = ovr_trim((ovr_line){text + digits, strlen(text + digits), 0});
    metres = ovr_length_unit(unit, true);
    if (!ovr_number(ovr_trim((ovr_line){text, digits, 0}), false,
                    &length->value))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "must be a length with a unit, such as '12 um'");
    length->unit = !unit.size                     ? OVR_LENGTH_BARE
                   : is_scaled(unit.text, scaled) ? OVR_LENGTH_SCALED
                                                  : OVR_LENGTH_METRES;
    if (length->unit == OVR_LENGTH_METRES && !(metres > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "unknown unit '%s'; must be m, mm, um, nm, inch, "
                        "..., or %s",
                        ovr_quote(unit).text, scaled);
    if (length->unit == OVR_LENGTH_METRES)
        length->value *= metres;
    return OVR_OK;
}
