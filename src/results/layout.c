/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/layout.h"
#include "results/results.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ------------------------------------------------------------------- rows */

size_t ovr_layout_columns(unsigned physics, const ovr_observable **rows)
{
    const ovr_observable *o;
    size_t count = 0;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        if (!o->name || o->axes != OVR_AT_STEPS || (o->needs & ~physics))
            continue;
        if (rows)
            rows[count] = o;
        count++;
    }
    return count;
}

size_t ovr_layout_fields(unsigned set, const ovr_observable **rows)
{
    const ovr_observable *o;
    size_t count = 0;
    for (size_t k = 0; (o = ovr_observable_at(k)); k++) {
        if (o->axes == OVR_AT_STEPS)
            continue;
        if (set & 1 && rows)
            rows[count] = o;
        count += set & 1;
        set >>= 1;
    }
    return count;
}

unsigned ovr_field_bit(const char *name)
{
    if (!name)
        return 0;
    const ovr_observable *row[OVR_FIELDS_MAX];
    size_t count = ovr_layout_fields(~0u, row);
    for (size_t k = 0; k < count; k++)
        if (strcmp(row[k]->name, name) == 0)
            return 1u << k;
    return 0;
}

/* ------------------------------------------------------------------ units */

ovr_scales ovr_scales_of(const ovr_contact *contact)
{
    ovr_scales scales;
    scales.contact = *contact;
    scales.physical = isfinite(contact->b) && isfinite(contact->ph) &&
                      isfinite(contact->height) && isfinite(contact->time);
    return scales;
}

/* Known by itself: viscosity and speed may lack where the rest is known. */
double ovr_factor(const ovr_scales *scales, ovr_unit_kind kind)
{
    double scale = ovr_kind_scale(kind, &scales->contact);
    return scales->physical && isfinite(scale) ? scale : 1;
}

/* A number that nothing scales is in its unit in any file. */
const char *ovr_unit(const ovr_scales *scales, ovr_unit_kind kind)
{
    double scale = ovr_kind_scale(kind, &scales->contact);
    bool si = scale == 1 || (scales->physical && isfinite(scale));
    return si ? ovr_kind_about(kind)->si : "1";
}
