/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A table by depth gives its numbers at any depth. */
#ifndef OVR_STRESS_BY_DEPTH_H
#define OVR_STRESS_BY_DEPTH_H

#include <stddef.h>

/* Linear between the depths z, which rise; the first and last value beyond. */
static inline double ovr_by_depth(size_t count, const double *z,
                                  const double *value, double at)
{
    size_t k = 1;
    if (at <= z[0])
        return value[0];
    while (k < count && z[k] < at)
        k++;
    if (k == count)
        return value[k - 1];
    return value[k - 1] +
           (at - z[k - 1]) / (z[k] - z[k - 1]) * (value[k] - value[k - 1]);
}

#endif
