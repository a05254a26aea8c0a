/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time-varying radii of curvature. */
#ifndef OVR_CONTACT_CURVATURE_H
#define OVR_CONTACT_CURVATURE_H

#include "overroll/contact.h"

/* R and, if known, R_1 of surface 1, relative to the reference radius (NULL: 1,
 * and unknown); speed, sliding and ratio as for ovr_surface_speed. Convected:
 * the curvature moves with the material. */
typedef struct ovr_curving {
    const ovr_history *radius, *radius_1, *speed, *sliding;
    double ratio[2];
    bool convected;
} ovr_curving;

/* Gap of the smooth surfaces, (half - cubic X) X^2; 1/2 and 0 at the reference
 * radius. */
typedef struct ovr_smooth {
    double half, cubic;
} ovr_smooth;

ovr_smooth ovr_smooth_of(const ovr_curving *curving, double T);

static inline double ovr_smooth_at(const ovr_smooth *smooth, double X)
{
    return (smooth->half - smooth->cubic * X) * X * X;
}

/* True if the radius is positive and the gap increases up to |X|. */
bool ovr_smooth_opens(const ovr_smooth *smooth, double X);

/* The contact at load Cw, speed Cu and curvature c = R0/R relative to the
 * reference contact, in its own scaling:
 *     M' = M Cw sqrt(c/Cu),  L' = L (Cu c)^(1/4)
 *     X = s X', s = sqrt(Cw/c),  H = Cw H',  P = sqrt(Cw c) P' */
typedef struct ovr_instant {
    double M, L, s;
} ovr_instant;
ovr_instant ovr_instant_of(const ovr_contact *contact, double Cw, double Cu,
                           double c);

#endif
