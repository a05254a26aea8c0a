/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "elements/needed.h"
#include "base/error.h"

#include <math.h>

ovr_status ovr_check_needed(const ovr_needed *all, size_t count, ovr_error *err)
{
    for (size_t k = 0; k < count; k++)
        if (!isfinite(all[k].value) || all[k].value < 0 ||
            (all[k].value <= 0 && !all[k].zero))
            return ovr_fail_about(
                err, all[k].about, "%s: must be %s", all[k].about,
                all[k].zero ? "zero or positive" : "positive");
    return OVR_OK;
}
