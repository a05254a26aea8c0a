/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One number as a vector of one: what is stated over `num` (reynolds_row.h)
 * by nodes in their order, as vector.h has it by vectors of nodes. */
#ifndef OVR_MULTIGRID_SCALAR_H
#define OVR_MULTIGRID_SCALAR_H

#include <stdbool.h>
#include <stddef.h>

typedef double num;
typedef bool truth;

static inline num all(double x)
{
    return x;
}

static inline num with_first(num x, double first)
{
    (void)x;
    return first;
}

static inline num at(const double *x, ptrdiff_t i)
{
    return x[i];
}

/* a b + c */
static inline num fused(num a, num b, num c)
{
    return a * b + c;
}

/* c - a b */
static inline num less(num c, num a, num b)
{
    return c - a * b;
}

#endif
