/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "overroll/profile.h"

#include <math.h>

ovr_profile_source ovr_profile_source_default(void)
{
    return (ovr_profile_source){.spacing = NAN};
}

ovr_conditioning ovr_conditioning_default(void)
{
    return (ovr_conditioning){.from = NAN,
                              .to = NAN,
                              .scale = 1,
                              .stretch = 1,
                              .max_gap = NAN,
                              .max_missing = 0.2,
                              .outliers = NAN,
                              .level = OVR_LEVEL_LINE,
                              .degree = 2,
                              .lambda_c = NAN,
                              .lambda_s = NAN,
                              .offset = 0,
                              .taper = NAN,
                              .extend = OVR_EXTEND_NONE};
}

ovr_roughness ovr_roughness_default(void)
{
    return (ovr_roughness){.Rq = NAN,
                           .length = NAN,
                           .spectrum = OVR_SELF_AFFINE,
                           .hurst = 0.8,
                           .rolloff = NAN,
                           .shortest = NAN,
                           .correlation = NAN,
                           .skewness = NAN,
                           .kurtosis = NAN,
                           .seed = 1};
}
