/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that people ask a result for, with a unit or bare. */
#include <math.h>

#include "base/given.h"
#include "base/quantity.h"
#include "base/text.h"
#include "results/results.h"

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
