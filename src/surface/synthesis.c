/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/synthesis.h"

ovr_profile *ovr_synthesize(const ovr_roughness *form,
                            const ovr_allocator *allocator, ovr_error *err)
{
    (void)form, (void)allocator;
    ovr_fail(err, OVR_BAD_INPUT, "roughness: not built yet");
    return NULL;
}
