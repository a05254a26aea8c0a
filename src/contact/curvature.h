/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Radii of curvature that vary in time. */
#ifndef OVR_CONTACT_CURVATURE_H
#define OVR_CONTACT_CURVATURE_H

#include "overroll/contact.h"

/* R and, where known, R_1 of surface 1 over the nominal R (NULL: 1, and not
 * known); speed, sliding and ratio as of ovr_surface_speed.  Convected: the
 * curvature belongs to the material, which carries it along. */
typedef struct ovr_curving {
    const ovr_history *radius, *radius_1, *speed, *sliding;
    double ratio[2];
    bool convected;
} ovr_curving;

/* The gap of the smooth surfaces (half - cubic X) X^2, of 1/2 and 0 at the
 * nominal radius. */
typedef struct ovr_smooth {
    double half, cubic;
} ovr_smooth;

ovr_smooth ovr_smooth_of(const ovr_curving *curving, double T);

static inline double ovr_smooth_at(const ovr_smooth *smooth, double X)
{
    return (smooth->half - smooth->cubic * X) * X * X;
}

/* The radius is positive, and the surfaces part all the way to |X|. */
bool ovr_smooth_opens(const ovr_smooth *smooth, double X);

/* The nominal contact at loads Cw, speeds Cu and curvatures c = R0/R relative
 * to it: the same in its own scaling,
 *     M' = M Cw sqrt(c/Cu),  L' = L (Cu c)^(1/4)
 *     X = s X', s = sqrt(Cw/c),  H = Cw H',  P = sqrt(Cw c) P' */
typedef struct ovr_instant {
    double M, L, s;
} ovr_instant;
ovr_instant ovr_instant_of(const ovr_contact *contact, double Cw, double Cu,
                           double c);

#endif
