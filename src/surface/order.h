/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Points of a text as they come: backwards, with x repeated by rounding. */
#ifndef OVR_SURFACE_ORDER_H
#define OVR_SURFACE_ORDER_H

#include "surface/profile.h"

/* Makes x increase, or fails with the line (of each point in `line`) where it
 * turns back; *n may shrink.  What was done is noted. */
ovr_status ovr_put_in_order(ovr_profile *profile, size_t *n, const long *line,
                            ovr_error *err);

#endif
