/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/measured.h"

#include <math.h>

ovr_status ovr_measured_make(ovr_feature *feature, const ovr_feature_form *form,
                             const ovr_contact *contact, double mesh,
                             ovr_arena *arena, ovr_error *err)
{
    (void)form, (void)contact, (void)mesh, (void)arena;
    return ovr_fail(err, OVR_BAD_INPUT, "feature '%s': not built yet",
                    feature->name);
}
