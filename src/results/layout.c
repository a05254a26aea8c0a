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

/* -------------------------------------------------------------- version 1 */

ovr_unit_kind ovr_layout_kind_1(const char *path)
{
    static const char *const names[OVR_KINDS] = {
        [OVR_KIND_COUNT] = " history/step history/pressure_maxima "
                           "history/cycles history/retries ",
        [OVR_KIND_FLAG] = " cavitated history/converged history/marked ",
        [OVR_KIND_LENGTH] =
            " x history/x_min_film_thickness history/x_max_pressure "
            "history/x_spike history/x_cavitation ",
        [OVR_KIND_HEIGHT] =
            " film_thickness roughness history/min_film_thickness "
            "history/central_film_thickness history/rigid_approach ",
        [OVR_KIND_PRESSURE] = " pressure history/central_pressure "
                              "history/max_pressure history/spike_pressure ",
        [OVR_KIND_TIME] = " time history/time history/time_step ",
        [OVR_KIND_VISCOSITY] = " viscosity ",
        [OVR_KIND_FLOW] = " mass_flow "};
    char word[160];
    snprintf(word, sizeof word, " %s ", path);
    for (ovr_unit_kind kind = OVR_KIND_COUNT; kind < OVR_KINDS; kind++)
        if (names[kind] && strstr(names[kind], word))
            return kind;
    return OVR_KIND_NUMBER;
}
