/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The form that is taken off a profile. */
#ifndef OVR_SURFACE_FORM_H
#define OVR_SURFACE_FORM_H

#include "surface/profile.h"

/* Removes the form how->level from the first n points and notes it; what
 * rounding leaves of it is no roughness and becomes 0.  `work` holds 3 n. */
ovr_status ovr_take_form(ovr_profile *profile, const ovr_conditioning *how,
                         size_t n, double *work, ovr_error *err);

#endif
