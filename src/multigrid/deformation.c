/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planning: everything that depends on the grid only (see deformation.h). */
#include "multigrid/deformation.h"

#include <math.h>
#include <stdlib.h>

#include "multigrid/field.h"

/* Dense below this: a coarsening no longer pays. */
enum { DENSE_NODES = 150 };

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

double ovr_deformation_kernel(double d, double D)
{
    return D / acos(-1.0) * (unit_kernel(d) + log(D));
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
void ovr_mlmi_choose(double wanted, int *order, int *range)
{
    static const struct {
        double error;
        int order, range;
    } table[] = {{4.4e-6, 6, 10},  {2.9e-7, 6, 16},   {2.7e-8, 6, 24},
                 {8.5e-9, 10, 16}, {1.3e-10, 10, 24}, {0, 12, 24}};
    size_t k = 0;
    while (table[k].error > wanted)
        k++;
    *order = table[k].order;
    *range = table[k].range;
}

/* Lagrange weights at 0 of the nodes +-1, +-3, ..., +-(2h - 1). */
static void interpolation_weights(size_t h, double weight[])
{
    for (size_t k = 0; k < h; k++) {
        long double x = 2 * (long double)k + 1, value = 0.5L;
        for (size_t j = 0; j < h; j++)
            if (j != k) {
                long double y = 2 * (long double)j + 1;
                value *= y * y / (y * y - x * x);
            }
        weight[k] = (double)value;
    }
}

/* Kernel at distance d of this grid, interpolated from even distances. */
static double interpolated(const ovr_mlmi *plan, double spacing, double d)
{
    double sum = 0;
    for (size_t k = 0; k < plan->half_order; k++) {
        double x = 2 * (double)k + 1;
        sum += plan->weight[k] * (unit_kernel(spacing * (d - x)) +
                                  unit_kernel(spacing * (d + x)));
    }
    return sum;
}

/* What the even outputs see at distance d after their corrections. */
static double effective(const ovr_mlmi *plan, double spacing, long d)
{
    long range = (long)(2 * plan->half_range);
    if (d % 2 == 0 || labs(d) <= range)
        return unit_kernel(spacing * (double)d);
    return interpolated(plan, spacing, (double)d);
}

static void plan_corrections(const ovr_mlmi *plan, ovr_mlmi_step *step,
                             double spacing)
{
    for (size_t k = 0; k < plan->half_range; k++) {
        double d = 2 * (double)k + 1;
        step->near_even[k] = unit_kernel(spacing * d) -
                             interpolated(plan, spacing, d);
    }
    for (size_t k = 0; k <= 2 * plan->half_range; k++) {
        double sum = 0;
        for (size_t j = 0; j < plan->half_order; j++) {
            long x = 2 * (long)j + 1;
            sum += plan->weight[j] * (effective(plan, spacing, (long)k - x) +
                                      effective(plan, spacing, (long)k + x));
        }
        step->near_odd[k] = unit_kernel(spacing * (double)k) - sum;
    }
}

static ovr_status plan_step(ovr_mlmi *plan, size_t n, ovr_arena *arena,
                            ovr_error *err)
{
    ovr_mlmi_step *step = &plan->step[plan->depth];
    step->n = n;
    step->coarse = (n + 1) / 2 + 2 * plan->half_order;
    step->even = ovr_field(arena, step->coarse, err);
    step->odd = ovr_field(arena, step->coarse, err);
    step->sum = ovr_field(arena, step->coarse, err);
    if (!step->even || !step->odd || !step->sum)
        return OVR_NO_MEMORY;
    plan_corrections(plan, step, ldexp(1, plan->depth));
    plan->depth++;
    return OVR_OK;
}

static ovr_status plan_dense(ovr_mlmi *plan, size_t n, double D,
                             ovr_arena *arena, ovr_error *err)
{
    plan->dense = n;
    plan->kernel = ovr_field(arena, 2 * n + 2 * OVR_FIELD_PAD, err);
    if (!plan->kernel)
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < 2 * n - 1; k++)
        plan->kernel[k] = unit_kernel(
                              ldexp((double)k - (double)(n - 1), plan->depth)) +
                          log(D);
    return OVR_OK;
}

ovr_status ovr_mlmi_plan(ovr_mlmi *plan, size_t n, double D, int order,
                         int range, ovr_arena *arena, ovr_error *err)
{
    size_t nodes = n;
    plan->n = n;
    plan->half_order = (size_t)order / 2;
    plan->half_range = (size_t)range / 2;
    plan->depth = 0;
    plan->scale = D / acos(-1.0);
    interpolation_weights(plan->half_order, plan->weight);
    while (nodes > DENSE_NODES && plan->depth < OVR_MLMI_DEPTH) {
        if (plan_step(plan, nodes, arena, err))
            return OVR_NO_MEMORY;
        nodes = plan->step[plan->depth - 1].coarse;
    }
    plan->values = ovr_field(arena, n, err);
    plan->output = ovr_field(arena, n, err);
    if (!plan->values || !plan->output)
        return OVR_NO_MEMORY;
    return plan_dense(plan, nodes, D, arena, err);
}
