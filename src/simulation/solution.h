/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The solution for all layers above multigrid: the fields marked `shown`
 * (multigrid/fields.h) at nodes X with any spacing.
 */
#ifndef OVR_SIMULATION_SOLUTION_H
#define OVR_SIMULATION_SOLUTION_H

#include "multigrid/fields.h"

typedef struct ovr_solution {
    size_t n;
    double D; /* minimum mesh size */
    const double *X;
    double *weights; /* weights of quadrature: integral of f = sum of weights f
                      */
    union {
        struct {
            OVR_LEVEL_FIELDS(OVR_FIELD_POINTER)
        };
        double *all[OVR_FIELD_COUNT];
    };
} ovr_solution;

/* Distance between nodes i - 1 and i > 0. */
static inline double ovr_spacing(const ovr_solution *s, size_t i)
{
    return s->X[i] - s->X[i - 1];
}

/* Node i > 0 with X_{i-1} <= X < X_i; the first or last one for X outside. */
size_t ovr_node_after(const ovr_solution *s, double X);

/* Interpolates f at X inside the domain by the cubic through the four nearest
 * nodes. */
double ovr_value_at(const ovr_solution *s, const double *f, double X);

#endif
