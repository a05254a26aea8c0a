/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lagrange's cubic interpolation between the points of a level. */
#ifndef OVR_STRESS_CUBIC_H
#define OVR_STRESS_CUBIC_H

#include <stddef.h>

/* Interpolates four values `stride` apart, at t from v[0] towards the next. */
static inline double ovr_cubic(const float *v, ptrdiff_t stride, double t)
{
    return -t * (t - 1) * (t - 2) / 6 * (double)v[-stride] +
           (t + 1) * (t - 1) * (t - 2) / 2 * (double)v[0] -
           (t + 1) * t * (t - 2) / 2 * (double)v[stride] +
           (t + 1) * t * (t - 1) / 6 * (double)v[2 * stride];
}

#endif
