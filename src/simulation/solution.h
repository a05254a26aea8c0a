/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The solution as all above multigrid sees it, node by node: the fields that
 * are `shown` (multigrid/fields.h) on nodes X at any distances.
 */
#ifndef OVR_SIMULATION_SOLUTION_H
#define OVR_SIMULATION_SOLUTION_H

#include "multigrid/fields.h"

typedef struct ovr_solution {
    size_t n;
    double D; /* the smallest mesh */
    const double *X;
    double *weights; /* integral of f: sum of weights f */
    union {
        struct {
            OVR_LEVEL_FIELDS(OVR_FIELD_POINTER)
        };
        double *all[OVR_FIELD_COUNT];
    };
} ovr_solution;

/* The distance from the node before to node i > 0. */
static inline double ovr_spacing(const ovr_solution *s, size_t i)
{
    return s->X[i] - s->X[i - 1];
}

/* The node i > 0 with X_{i-1} <= X < X_i; the first or the last beyond. */
size_t ovr_node_after(const ovr_solution *s, double X);

/* Interpolates f at X inside, by the cubic through the four nodes about it. */
double ovr_value_at(const ovr_solution *s, const double *f, double X);

#endif
