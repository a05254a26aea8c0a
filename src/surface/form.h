/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Form removal of profiles. */
#ifndef OVR_SURFACE_FORM_H
#define OVR_SURFACE_FORM_H

#include "surface/profile.h"

/* Removes the form how->level from the first n points and adds a note.
 * Residuals of the size of rounding errors become 0. `work` has 3 n
 * elements. */
ovr_status ovr_take_form(ovr_profile *profile, const ovr_conditioning *how,
                         size_t n, double *work, ovr_error *err);

#endif
