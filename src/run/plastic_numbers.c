/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums up in a number each what yielding made of a body. */
#include <math.h>

#include "run/plastic.h"

/* Serves numbers alone: these are looked through at each step, and fmax is a
 * call. */
static double larger(double a, double b)
{
    return a > b ? a : b;
}

double ovr_plastic_most(const ovr_plastic *p, const ovr_yielding_body *b)
{
    double most = 0;
    for (size_t j = 0; j < b->layers; j++)
        for (size_t i = 0; i < b->points; i++)
            most = larger(
                most,
                b->kept[(OVR_PLASTIC_STATE * (j + 1) - 1) * b->points + i]);
    return most * p->how->body[b == p->body ? 0 : 1].strain;
}

double ovr_plastic_deepest(const ovr_yielding_body *b)
{
    double most = 0;
    for (size_t i = 0; i < b->points; i++)
        most = larger(most, b->shown[i]);
    return most;
}

double ovr_plastic_shoulder(const ovr_yielding_body *b, int side, bool yielded)
{
    double most = -INFINITY, way = b->plan.direction < 0 ? -1 : 1;
    for (size_t i = 0; i < b->points; i++) {
        double xi = b->first + (double)i * b->mesh;
        if (xi * way * side >= 0)
            most = larger(most, b->shape[i] - (yielded ? b->shown[i] : 0));
    }
    return most;
}
