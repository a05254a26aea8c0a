/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What histories mean for the grid: the domain, and the gap on it. */
#ifndef OVR_CASE_DOMAIN_H
#define OVR_CASE_DOMAIN_H

#include "case/resolve.h"

/* Load, speed or radius vary: other films at other times. */
bool ovr_setup_varies(const ovr_setup *setup);

/* The end, as far as it is known before the domain is. */
double ovr_setup_end(const ovr_setup *setup);

/* The domain, where it is left to the program. */
void ovr_setup_domain(ovr_setup *setup);

/* Whether the curvature rides with the material, on that domain. */
ovr_status ovr_setup_curvature(ovr_resolved *r, ovr_error *err);

#endif
