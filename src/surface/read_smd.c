/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/profile.h"

ovr_status ovr_read_smd(ovr_profile *profile, const ovr_profile_source *source,
                        ovr_bytes content, ovr_error *err)
{
    (void)source, (void)content;
    return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0, "not read yet");
}
