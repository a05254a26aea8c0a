/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/physical.h"

#include <math.h>
#include <stdio.h>

#include "overroll/profile.h"

void cli_physical(double value, ovr_unit_kind kind, const ovr_contact *contact,
                  char text[CLI_PHYSICAL_SIZE])
{
    double si = value * ovr_kind_scale(kind, contact);
    text[0] = '\0';
    if (kind == OVR_KIND_NUMBER || !isfinite(si))
        return;
    if (kind == OVR_KIND_HEIGHT)
        snprintf(text, CLI_PHYSICAL_SIZE, "%.4g um", si * 1e6);
    else if (kind == OVR_KIND_PRESSURE)
        snprintf(text, CLI_PHYSICAL_SIZE, "%.4g GPa", si * 1e-9);
    else if (kind == OVR_KIND_TIME)
        snprintf(text, CLI_PHYSICAL_SIZE, "%.4g ms", si * 1e3);
    else if (kind == OVR_KIND_LENGTH)
        snprintf(text, CLI_PHYSICAL_SIZE, "%s", ovr_metres(si).text);
}

void cli_put_place(const char *name, double value, ovr_unit_kind kind,
                   const ovr_contact *contact)
{
    char text[CLI_PHYSICAL_SIZE];
    cli_physical(value, kind, contact, text);
    printf("%s = %.4g", name, value);
    if (*text)
        printf(" (%s)", text);
}
