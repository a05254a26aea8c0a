/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums up in a number each what yielding made of a body. */
#include <math.h>

#include "physics/plastic/bodies.h"

/* Serves numbers alone: these are looked through at each step, and fmax is a
 * call. */
static double larger(double a, double b)
{
    return a > b ? a : b;
}

double ovr_plastic_max(const ovr_plastic *p, const ovr_yielding_body *b)
{
    double maximum = 0;
    for (size_t j = 0; j < b->layers; j++)
        for (size_t i = 0; i < b->points; i++)
            maximum = larger(
                maximum,
                b->kept[(OVR_PLASTIC_STATE * (j + 1) - 1) * b->points + i]);
    return maximum * p->how->body[b == p->body ? 0 : 1].strain;
}

double ovr_plastic_deepest(const ovr_yielding_body *b)
{
    double maximum = 0;
    for (size_t i = 0; i < b->points; i++)
        maximum = larger(maximum, b->shown[i]);
    return maximum;
}

double ovr_plastic_shoulder(const ovr_yielding_body *b, int side, bool yielded)
{
    double maximum = -INFINITY, way = b->plan.direction < 0 ? -1 : 1;
    for (size_t i = 0; i < b->points; i++) {
        double xi = b->first + (double)i * b->mesh;
        if (xi * way * side >= 0)
            maximum = larger(maximum,
                             b->shape[i] - (yielded ? b->shown[i] : 0));
    }
    return maximum;
}
