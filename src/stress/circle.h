/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A path in the plane of (d, tau) is judged by its extents. */
#ifndef OVR_STRESS_CIRCLE_H
#define OVR_STRESS_CIRCLE_H

/* Extents are taken along u_m = (cos, sin)(pi m/16), and against it. */
enum { OVR_HALF_DIRECTIONS = 16 };

double ovr_direction_cos(int m);
double ovr_direction_sin(int m);

/* Radius of the smallest circle round a path, from high[m] = max u_m.s and
 * low[m] = min u_m.s; never more than the radius of the path itself, at most
 * 0.48 % less. */
double ovr_circle_of_extents(const double *high, const double *low);

#endif
