/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Multilevel multi-integration in the steps of deformation.h. Beyond nodes and
 * ghost nodes, u is zero. */
#include <stdlib.h>

#include "multigrid/deformation.h"
#include "multigrid/plain.h"

/* Step 1: moves u of odd nodes to the even nodes. */
static void coarsen(const ovr_mlmi *plan, const double *u, double *U,
                    ptrdiff_t from, ptrdiff_t to)
{
    for (ptrdiff_t I = from; I < to; I++) {
        U[I] = u[2 * I];
        for (ptrdiff_t k = 0; k < plan->half_order; k++)
            U[I] += plan->weight[k] *
                    (u[2 * I + 1 + 2 * k] + u[2 * I - 1 - 2 * k]);
    }
}

/* Step 2: corrects even outputs at odd distances up to the range. */
static void correct_even(const ovr_mlmi *plan, const ovr_mlmi_grid *fine,
                         const double *u, double *even, ptrdiff_t from,
                         ptrdiff_t to)
{
    for (ptrdiff_t I = from; I < to; I++)
        for (ptrdiff_t k = 0; k < plan->range / 2; k++)
            even[I] += fine->near_even[k] *
                       (u[2 * I + 1 + 2 * k] + u[2 * I - 1 - 2 * k]);
}

/* Step 3: interpolates and corrects odd outputs. */
static void refine(const ovr_mlmi *plan, const ovr_mlmi_grid *fine,
                   const double *u, const double *even, double *out,
                   ptrdiff_t from, ptrdiff_t to)
{
    for (ptrdiff_t I = from; I < to; I++) {
        ptrdiff_t i = 2 * I + 1;
        out[i - 1] = even[I];
        out[i] = fine->near_odd[0] * u[i];
        for (ptrdiff_t k = 0; k < plan->half_order; k++)
            out[i] += plan->weight[k] * (even[I + 1 + k] + even[I - k]);
        for (ptrdiff_t k = 1; k <= plan->range; k++)
            out[i] += fine->near_odd[k] * (u[i + k] + u[i - k]);
    }
}

/* Step 4: dense sum. */
static void dense_sum(const double *kernel, const double *u, double *out,
                      ptrdiff_t from, ptrdiff_t to)
{
    for (ptrdiff_t i = from; i < to; i++) {
        out[i] = 0;
        for (ptrdiff_t j = from; j < to; j++)
            out[i] += kernel[labs(i - j)] * u[j];
    }
}

/* Computes the outputs of grid s, which has nodes 0..last. */
static void integrate(const ovr_mlmi *plan, int s, ptrdiff_t last,
                      const double *u, double *out)
{
    const ovr_mlmi_grid *fine = &plan->grid[s], *coarse = fine + 1;
    if (s == plan->depth) {
        dense_sum(plan->kernel, u, out, -fine->left, last + fine->right);
        return;
    }
    ptrdiff_t from = -coarse->left, to = last / 2 + coarse->right;
    coarsen(plan, u, coarse->u, from, to);
    integrate(plan, s + 1, last / 2, coarse->u, coarse->out);
    correct_even(plan, fine, u, coarse->out, from, to);
    refine(plan, fine, u, coarse->out, out, -fine->left / 2,
           (last + fine->right) / 2);
}

void ovr_deformation_plain(const ovr_mlmi *plan, double *P, double *w)
{
    integrate(plan, 0, (ptrdiff_t)ovr_mlmi_lane(plan, 1), P, w);
}
