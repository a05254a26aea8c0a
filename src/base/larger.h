/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_BASE_LARGER_H
#define OVR_BASE_LARGER_H

/*
 * fmax and fmin for loops over nodes. The C library's fmax is a function call:
 * its result is the other argument if either is NaN. Here a NaN as the second
 * argument yields the first one. A running maximum therefore ignores NaN.
 */
static inline double ovr_larger(double gathered, double x)
{
    return x > gathered ? x : gathered;
}

static inline double ovr_smaller(double gathered, double x)
{
    return x < gathered ? x : gathered;
}

/* Limits x to -limit..limit. */
static inline double ovr_clipped(double x, double limit)
{
    return x > limit ? limit : x < -limit ? -limit : x;
}

#endif
