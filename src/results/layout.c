/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/layout.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/quantity.h"
#include "base/text.h"
#include "results/results.h"

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

/* Returns the scale of a kind, 1 if it is unknown. Each kind is checked,
 * because viscosity and speed may be unknown when other scales are known. */
double ovr_factor(const ovr_scales *scales, ovr_unit_kind kind)
{
    double scale = ovr_kind_scale(kind, &scales->contact);
    return scales->physical && isfinite(scale) ? scale : 1;
}

/* Returns the unit of a kind. Kinds without a scale have their unit in any
 * file. */
const char *ovr_unit(const ovr_scales *scales, ovr_unit_kind kind)
{
    double scale = ovr_kind_scale(kind, &scales->contact);
    bool si = scale == 1 || (scales->physical && isfinite(scale));
    return si ? ovr_kind_about(kind)->si : "1";
}

/* ------------------------------------------------------ requested numbers */

/* Numbers given by users, with a unit or dimensionless. */

static ovr_dimension dimension_of(ovr_unit_kind kind)
{
    switch (kind) {
    case OVR_KIND_LENGTH:
    case OVR_KIND_HEIGHT: return OVR_LENGTH;
    case OVR_KIND_PRESSURE: return OVR_PRESSURE;
    case OVR_KIND_TIME: return OVR_DURATION;
    default: return OVR_PURE;
    }
}

bool ovr_bare_number(const char *text, double *value)
{
    if (!text)
        return false;
    return ovr_read_number(&text, value) && *text == '\0';
}

double ovr_result_scale(const ovr_result_info *info, ovr_unit_kind kind)
{
    const ovr_contact scales = {.b = info->b,
                                .ph = info->ph,
                                .height = info->height,
                                .time = info->time};
    return ovr_kind_scale(kind, &scales);
}

ovr_status ovr_result_number(const ovr_result *result, ovr_unit_kind kind,
                             const char *text, double *value, ovr_error *err)
{
    if (!result || !text)
        return ovr_fail_null(err, __func__);
    double scale = ovr_result_scale(ovr_result_get_info(result), kind);
    ovr_quantity given;
    ovr_status status = ovr_quantity_read(text, dimension_of(kind), true,
                                          &given, err);
    if (status)
        return status;
    *value = given.value;
    if (!given.unit)
        return OVR_OK;
    if (!(scale > 0 && isfinite(scale)))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%s': the file has no physical scales; without a "
                        "unit the number is in %s",
                        text, ovr_kind_about(kind)->hertzian);
    *value /= scale;
    return OVR_OK;
}
