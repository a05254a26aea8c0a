/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random roughness from a seed. */
#ifndef OVR_SURFACE_SYNTHESIS_H
#define OVR_SURFACE_SYNTHESIS_H

#include "overroll/profile.h"

/* One period, in b and b^2/R. */
ovr_profile *ovr_synthesize(const ovr_roughness *form,
                            const ovr_allocator *allocator, ovr_error *err);

#endif
