/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pair of teeth at one point of the path carries a share of the load, which
 * is given here. */
#ifndef OVR_ELEMENTS_GEAR_SHARING_H
#define OVR_ELEMENTS_GEAR_SHARING_H

#include "overroll/elements.h"

/* Load per length of the contact line, N/m, at xi base pitches from A; its
 * unit for spur gears is the whole load over the face. */
double ovr_gear_load(const ovr_gear_form *form, const ovr_gear_geometry *g,
                     double xi);

/* c' of ISO 6336-1 in N/m2; *applies: its shifts are in the standard's range.
 */
double ovr_iso_stiffness(const ovr_gear_form *form, const ovr_gear_geometry *g,
                         bool *applies);

#endif
