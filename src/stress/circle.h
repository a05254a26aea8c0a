/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Circumscribed circles of shear stress paths in the plane of (d, tau). */
#ifndef OVR_STRESS_CIRCLE_H
#define OVR_STRESS_CIRCLE_H

/* Extents are taken along u_m = (cos, sin)(pi m/16) and in the opposite
 * directions. */
enum { OVR_HALF_DIRECTIONS = 16 };

double ovr_direction_cos(int m);
double ovr_direction_sin(int m);

/* Radius of the smallest circle around a path, from high[m] = max u_m.s and
 * low[m] = min u_m.s. Never larger than the radius of the path, at most 0.48 %
 * smaller. */
double ovr_circle_of_extents(const double *high, const double *low);

#endif
