/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A number as a vector of length one. Code written for `num` (the row of the
 * Reynolds equation, lubricant models) then processes single nodes; with
 * vector.h and power.h it processes vectors of nodes. */
#ifndef OVR_BASE_SCALAR_H
#define OVR_BASE_SCALAR_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

typedef double num;
typedef bool truth;

#define INLINE inline

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

/* Returns a b + c. */
static inline num fused(num a, num b, num c)
{
    return a * b + c;
}

/* Returns c - a b. */
static inline num less(num c, num a, num b)
{
    return c - a * b;
}

/* Returns the larger number; b if one is NaN. */
static inline num larger(num a, num b)
{
    return a > b ? a : b;
}

static inline num smaller(num a, num b)
{
    return a < b ? a : b;
}

/* Returns which ? a : b. */
static inline num choose(truth which, num a, num b)
{
    return which ? a : b;
}

/* Integer part of a number from 0 to 2^31, used as a table index. */
typedef size_t cell;

static inline cell whole_part(num x)
{
    return (cell)x;
}

static inline num from_whole(cell k)
{
    return (num)k;
}

static inline num gather(const double *x, cell k)
{
    return x[k];
}

/* Computes z log2 x and s 2^y from tables that include the factor. */
typedef struct log_table {
    double z;
} log_table;

typedef struct exp_table {
    double s;
} exp_table;

static inline void make_log_table(double z, log_table *table)
{
    table->z = z;
}

static inline void make_exp_table(double s, exp_table *table)
{
    table->s = s;
}

static inline num scaled_log2(const log_table *table, num x)
{
    return table->z * log2(x);
}

static inline num scaled_exp2(const exp_table *table, num y)
{
    return table->s * exp2(y);
}

#endif
