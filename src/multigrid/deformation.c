/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planning: everything that depends on the grid only (see deformation.h). */
#include "multigrid/deformation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/deformation_weights.h"
#include "multigrid/field.h"
#include "multigrid/lanes.h"

/* Dense below this: a coarsening no longer pays. */
enum { DENSE_NODES = 70 };

/*
 * f(d).  The closed form cancels at large d (terms of size d ln d for a
 * result of size ln d), so beyond 64 the series
 *     f = ln d - sum_k 1/(2k (2k+1) (2d)^(2k)),  k = 1, 2, ...
 * is used: from log1p(+-1/(2d)); four terms leave less than 1e-18.
 */
static double unit_kernel(double d)
{
    d = fabs(d);
    if (d < 64) {
        double right = d + 0.5, left = d - 0.5;
        return right * log(right) - left * log(fabs(left)) - 1;
    }
    double h = 0.25 / (d * d);
    return log(d) - h * (1. / 6 + h * (1. / 20 + h * (1. / 42 + h / 72)));
}

/* d^2/2 ln|d| - 3/4 d^2 */
static double second_integral(double d)
{
    return d == 0 ? 0 : 0.5 * d * d * (log(fabs(d)) - 1.5);
}

/*
 * f(d) of a linear pressure, beyond 8 by
 *     f = ln d - sum_k 1/(k (2k + 1) (2k + 2) d^(2k)),
 * of which eight terms leave less than 1e-19.
 */
static double linear_kernel(double d)
{
    d = fabs(d);
    if (d < 8)
        return second_integral(d + 1) - 2 * second_integral(d) +
               second_integral(d - 1);
    double h = 1 / (d * d), sum = 0;
    for (int k = 8; k > 0; k--)
        sum = h * (sum + 1. / (k * (2 * k + 1) * (2 * k + 2)));
    return log(d) - sum;
}

/* f(d) of a plan, including the terms besides the logarithm. */
static double kernel_of(const ovr_mlmi *plan, double d)
{
    double f = plan->linear ? linear_kernel(d) : unit_kernel(d);
    for (int k = 0; k < plan->parts; k++)
        f += ovr_influence_part_at(&plan->part[k], d * plan->D, plan->D,
                                   plan->linear) *
             acos(-1.0) / plan->D;
    return f;
}

double ovr_deformation_kernel(double d, double D)
{
    return D / acos(-1.0) * (unit_kernel(d) + log(D));
}

double ovr_deformation_linear(double d, double D)
{
    return D / acos(-1.0) * (linear_kernel(d) + log(D));
}

void ovr_deformation_direct(size_t n, double D, const double *P, double *w)
{
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t j = 0; j < n; j++)
            sum += ovr_deformation_kernel((double)i - (double)j, D) * P[j];
        w[i] = sum;
    }
}

/* Measured errors of the method relative to max |w| (tests/unit). */
ovr_mlmi_form ovr_mlmi_choose(double target)
{
    static const struct {
        double error;
        ovr_mlmi_form form;
    } table[] = {{4e-7, {6, 10}},     {3e-8, {6, 16}},     {6e-9, {10, 10}},
                 {8.5e-10, {10, 12}}, {1.7e-10, {10, 14}}, {0, {12, 16}}};
    size_t k = 0;
    while (table[k].error > target)
        k++;
    return table[k].form;
}

/* The kernel of one grid at whole distances, as far as its corrections ask. */
enum { FARTHEST = 4 * OVR_MLMI_MAX };

typedef struct sampled {
    double at[FARTHEST];
} sampled;

static void sample(const ovr_mlmi *plan, double spacing, sampled *kernel)
{
    ptrdiff_t last = plan->range + 4 * plan->half_order - 2;
    for (ptrdiff_t d = 0; d <= last; d++)
        kernel->at[d] = kernel_of(plan, spacing * (double)d);
}

/* Kernel at distance d of this grid, interpolated from even distances. */
static double interpolated(const ovr_mlmi *plan, const sampled *kernel,
                           ptrdiff_t d)
{
    double sum = 0;
    for (ptrdiff_t k = 0; k < plan->half_order; k++) {
        ptrdiff_t x = 2 * k + 1;
        sum += plan->weight[k] *
               (kernel->at[labs(d - x)] + kernel->at[labs(d + x)]);
    }
    return sum;
}

/* The kernel as the even outputs see it at distance d after their
 * corrections. */
static double effective(const ovr_mlmi *plan, const sampled *kernel,
                        ptrdiff_t d)
{
    if (d % 2 == 0 || labs(d) <= plan->range)
        return kernel->at[labs(d)];
    return interpolated(plan, kernel, d);
}

static void plan_corrections(const ovr_mlmi *plan, ovr_mlmi_grid *grid,
                             double spacing, double scale)
{
    sampled kernel;
    sample(plan, spacing, &kernel);
    for (ptrdiff_t k = 0; k < plan->range / 2; k++) {
        ptrdiff_t d = 2 * k + 1;
        grid->near_even[k] = scale *
                             (kernel.at[d] - interpolated(plan, &kernel, d));
    }
    for (ptrdiff_t k = 0; k <= plan->range; k++) {
        double sum = 0;
        for (ptrdiff_t j = 0; j < plan->half_order; j++) {
            ptrdiff_t x = 2 * j + 1;
            sum += plan->weight[j] * (effective(plan, &kernel, k - x) +
                                      effective(plan, &kernel, k + x));
        }
        grid->near_odd[k] = scale * (kernel.at[k] - sum);
    }
}

/* Coarsenings until the grid is small, or the lanes shorter than the range. */
static int depth_of(size_t n, ptrdiff_t range)
{
    int depth = 0;
    while ((n >> depth) > DENSE_NODES &&
           (ptrdiff_t)((n - 1) / OVR_MAX_LANES >> depth) >= range &&
           depth < OVR_MLMI_DEPTH)
        depth++;
    return depth;
}

/* Ghosts of a coarse grid: where the stencils of the finer one reach. */
static void count_ghosts(const ovr_mlmi *plan, const ovr_mlmi_grid *fine,
                         ovr_mlmi_grid *coarse)
{
    ptrdiff_t left = plan->half_order + fine->left / 2;
    ptrdiff_t right = plan->half_order + fine->right / 2;
    coarse->left = left + left % 2;
    coarse->right = right + right % 2;
}

/* Nodes that the lanes hold, for whatever number of lanes. */
static size_t max_nodes(const ovr_mlmi *plan)
{
    size_t maximum = 0;
    for (size_t lanes = 1; lanes <= OVR_MAX_LANES; lanes *= 2) {
        size_t nodes = lanes * ovr_mlmi_lane(plan, lanes);
        maximum = nodes > maximum ? nodes : maximum;
    }
    return maximum;
}

/* An array of a grid after `coarsenings`. */
static double *take(const ovr_mlmi *plan, int coarsenings, ovr_arena *arena,
                    ovr_error *err)
{
    size_t nodes = max_nodes(plan) >> coarsenings;
    size_t pad = (size_t)plan->pad * OVR_MAX_LANES - OVR_FIELD_PAD;
    double *all = ovr_field(arena, nodes + 2 * pad, err);
    return all ? all + pad : NULL;
}

double *ovr_mlmi_field(const ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    return take(plan, 0, arena, err);
}

static ovr_status take_grids(ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    plan->grid[0].left = 0;
    plan->grid[0].right = 2;
    for (int s = 0; s <= plan->depth; s++) {
        ovr_mlmi_grid *grid = &plan->grid[s];
        grid->near_even = ovr_arena_take(arena, 3 * OVR_MLMI_MAX + 1,
                                         sizeof *grid->near_even, err);
        if (!grid->near_even)
            return OVR_NO_MEMORY;
        grid->near_odd = grid->near_even + OVR_MLMI_MAX;
        if (s) {
            count_ghosts(plan, &plan->grid[s - 1], grid);
            grid->u = take(plan, s, arena, err);
            grid->out = take(plan, s, arena, err);
            if (!grid->u || !grid->out)
                return OVR_NO_MEMORY;
        }
    }
    return OVR_OK;
}

/* Nodes of the dense sum. */
static size_t dense_nodes(const ovr_mlmi *plan)
{
    const ovr_mlmi_grid *last = &plan->grid[plan->depth];
    return (max_nodes(plan) >> plan->depth) +
           (size_t)(last->left + last->right);
}

/* kernel[0] is the one at distance zero. */
static ovr_status take_dense(ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    size_t count = dense_nodes(plan);
    double *kernel = ovr_field(arena, 2 * count + OVR_FIELD_PAD, err);
    plan->natural = ovr_field(arena, count, err);
    plan->result = ovr_field(arena, count, err);
    if (!kernel || !plan->natural || !plan->result)
        return OVR_NO_MEMORY;
    plan->kernel = kernel + count;
    return OVR_OK;
}

ovr_status ovr_mlmi_plan(ovr_mlmi *plan, size_t n, ovr_mlmi_form form,
                         ovr_arena *arena, ovr_error *err)
{
    plan->n = n;
    plan->linear = false;
    plan->parts = 0;
    plan->half_order = form.order / 2;
    plan->range = form.range;
    plan->depth = depth_of(n, form.range);
    plan->pad = 2 * (form.order + 4) + form.range + 2 * OVR_MLMI_BLOCK;
    if (take_grids(plan, arena, err))
        return OVR_NO_MEMORY;
    return take_dense(plan, arena, err);
}

void ovr_mlmi_fill(ovr_mlmi *plan, double D, const ovr_mlmi *like)
{
    const double scale = D / acos(-1.0);
    plan->D = D;
    if (like && like->half_order == plan->half_order &&
        like->range == plan->range)
        memcpy(plan->weight, like->weight, sizeof plan->weight);
    else
        ovr_mlmi_weights((size_t)plan->half_order, (size_t)plan->range,
                         plan->weight);
    for (int s = 0; s <= plan->depth; s++)
        plan_corrections(plan, &plan->grid[s], ldexp(1, s), scale);
    for (ptrdiff_t d = 0; d < (ptrdiff_t)dense_nodes(plan); d++)
        plan->kernel[d] = plan->kernel[-d] =
            scale * (kernel_of(plan, ldexp((double)d, plan->depth)) + log(D));
}
