/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef OVR_BASE_LARGER_H
#define OVR_BASE_LARGER_H

/*
 * fmax and fmin for loops over nodes: those of the C library are calls, since a
 * NaN on either side has to give the other.  Here a NaN that comes second gives
 * the first, so that a maximum that is gathered passes it over as fmax does.
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
