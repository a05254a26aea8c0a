/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lift of a cam and its derivatives by the angle. */
#ifndef OVR_ELEMENTS_LIFT_H
#define OVR_ELEMENTS_LIFT_H

#include "base/arena.h"
#include "overroll/elements.h"

/* A natural cubic spline through a table of lifts: second derivatives at the
 * points; the form's own tables are replaced by copies in the arena. */
ovr_status ovr_lift_make(ovr_cam_form *form, double **bending, ovr_arena *arena,
                         ovr_error *err);

/* s, s' and s'' at an angle from the beginning of the rise; 0 outside. */
void ovr_lift_at(const ovr_cam_form *form, const double *bending, double angle,
                 double lift[3]);

#endif
