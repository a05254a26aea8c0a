/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values at the feet of paths (feet.h). */
#include "simulation/feet.h"

#include <math.h>

/* Beyond the end by which material comes nothing, beyond the other its last. */
static double value(size_t n, const double *v, ptrdiff_t i, double meshes)
{
    if (i >= 0 && i < (ptrdiff_t)n)
        return v[i];
    if ((i < 0) == (meshes >= 0))
        return 0;
    return v[i < 0 ? 0 : n - 1];
}

/* Lagrange's cubic at s in [0, 1) of the middle of four nodes. */
static void cubic(double s, double c[4])
{
    c[0] = -s * (s - 1) * (s - 2) / 6;
    c[1] = (s + 1) * (s - 1) * (s - 2) / 2;
    c[2] = -(s + 1) * s * (s - 2) / 2;
    c[3] = (s + 1) * s * (s - 1) / 6;
}

static double near_an_end(size_t n, const double *v, ptrdiff_t first,
                          const double c[4], double meshes)
{
    double sum = 0;
    for (ptrdiff_t k = 0; k < 4; k++)
        sum += c[k] * value(n, v, first + k, meshes);
    return sum;
}

/* No foot is farther away than this many domains. */
static double bounded(size_t n, double meshes)
{
    double most = 2 * (double)n;
    return fmax(-most, fmin(meshes, most));
}

void ovr_feet_cubic(size_t n, const double *v, double meshes, double *at_feet)
{
    double shift = bounded(n, meshes), whole = floor(-shift), c[4];
    ptrdiff_t first = (ptrdiff_t)whole - 1, size = (ptrdiff_t)n;
    ptrdiff_t from = first < 0 ? -first : 0, to = size - 3 - first;
    from = from < size ? from : size;
    to = to < from ? from : to < size ? to : size;
    cubic(-shift - whole, c);
    for (ptrdiff_t i = 0; i < from; i++)
        at_feet[i] = near_an_end(n, v, i + first, c, shift);
    for (ptrdiff_t i = from; i < to; i++)
        at_feet[i] = c[0] * v[i + first] + c[1] * v[i + first + 1] +
                     c[2] * v[i + first + 2] + c[3] * v[i + first + 3];
    for (ptrdiff_t i = to; i < size; i++)
        at_feet[i] = near_an_end(n, v, i + first, c, shift);
}

double ovr_foot_linear(size_t n, const double *v, size_t i, double meshes)
{
    double at = (double)i - bounded(n, meshes), whole = floor(at);
    double s = at - whole;
    ptrdiff_t first = (ptrdiff_t)whole;
    return (1 - s) * value(n, v, first, meshes) +
           s * value(n, v, first + 1, meshes);
}
