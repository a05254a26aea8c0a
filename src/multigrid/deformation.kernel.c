/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Execution of an MLMI plan (method in deformation.h).  Down: split and
 * transfer; dense sum; up: correct the even outputs, interpolate and correct
 * the odd ones, merge.  Every loop makes BLOCK outputs at once in registers;
 * symmetric stencils add the pair of values first.
 */
#include "multigrid/deformation.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Outputs of one pass, four registers of the widest vectors; loops overshoot
 * by at most that into the padding. */
enum { REGISTERS = 4, BLOCK = REGISTERS * VEC };

typedef struct block {
    vec v[REGISTERS];
} block;

static inline void add(block *sum, const double *x)
{
    for (size_t l = 0; l < REGISTERS; l++)
        sum->v[l] += load(x + l * VEC);
}

static inline void add_pair(block *sum, double c, const double *x,
                            const double *y)
{
    for (size_t l = 0; l < REGISTERS; l++)
        sum->v[l] += c * (load(x + l * VEC) + load(y + l * VEC));
}

static inline void keep(double *x, const block *sum)
{
    for (size_t l = 0; l < REGISTERS; l++)
        store(x + l * VEC, sum->v[l]);
}

static void split(size_t n, const double *restrict u, double *restrict even,
                  double *restrict odd)
{
    size_t pairs = n / 2;
    for (size_t j = 0; j < pairs; j++) {
        even[j] = u[2 * j];
        odd[j] = u[2 * j + 1];
    }
    if (n % 2)
        even[pairs] = u[n - 1];
}

static void merge(size_t n, const double *restrict even,
                  const double *restrict odd, double *restrict u)
{
    size_t pairs = n / 2;
    for (size_t j = 0; j < pairs; j++) {
        u[2 * j] = even[j];
        u[2 * j + 1] = odd[j];
    }
    if (n % 2)
        u[n - 1] = even[pairs];
}

/* U_J = even_J' + sum_k weight_k (odd_{J'+k} + odd_{J'-1-k}), J' = J - ghosts
 */
static inline void transfer(size_t h, const ovr_mlmi *plan,
                            const ovr_mlmi_step *step, double *U)
{
    for (size_t J = 0; J < step->coarse; J += BLOCK) {
        const double *even = step->even + J - h, *odd = step->odd + J - h;
        block sum = {{{0}}};
        add(&sum, even);
        for (size_t k = 0; k < h; k++)
            add_pair(&sum, plan->weight[k], odd + k, odd - 1 - k);
        keep(U + J, &sum);
    }
}

/* sum_J += near_even_k (odd_{J'+k} + odd_{J'-1-k}), distances 2k + 1 */
static inline void correct_even(size_t h, size_t range,
                                const ovr_mlmi_step *step)
{
    for (size_t J = 0; J < step->coarse; J += BLOCK) {
        const double *odd = step->odd + J - h;
        block sum = {{{0}}};
        add(&sum, step->sum + J);
        for (size_t k = 0; k < range; k++)
            add_pair(&sum, step->near_even[k], odd + k, odd - 1 - k);
        keep(step->sum + J, &sum);
    }
}

/* Odd output j: interpolation between the even ones, plus corrections from
 * the odd values (even distances) and the even values (odd distances). */
static inline void interpolate_odd(size_t h, size_t range, const ovr_mlmi *plan,
                                   const ovr_mlmi_step *step, double *result)
{
    const double *near = step->near_odd;
    for (size_t j = 0; j < step->n / 2; j += BLOCK) {
        const double *even = step->even + j, *odd = step->odd + j;
        const double *out = step->sum + h + j;
        block sum = {{{0}}};
        for (size_t k = 0; k < h; k++)
            add_pair(&sum, plan->weight[k], out + 1 + k, out - k);
        add_pair(&sum, 0.5 * near[0], odd, odd);
        for (size_t k = 1; k <= range; k++)
            add_pair(&sum, near[2 * k], odd + k, odd - k);
        for (size_t k = 0; k < range; k++)
            add_pair(&sum, near[2 * k + 1], even + 1 + k, even - k);
        keep(result + j, &sum);
    }
}

/* w_i = scale sum_j kernel(i - j) U_j */
static void dense_sum(const ovr_mlmi *plan, const double *U, double scale,
                      double *w)
{
    size_t n = plan->dense;
    for (size_t i = 0; i < n; i += BLOCK) {
        const double *kernel = plan->kernel + i + n - 1;
        block sum = {{{0}}};
        for (size_t j = 0; j < n; j++)
            for (size_t l = 0; l < REGISTERS; l++)
                sum.v[l] += U[j] * load(kernel - j + l * VEC);
        for (size_t l = 0; l < REGISTERS; l++)
            store(w + i + l * VEC, scale * sum.v[l]);
    }
}

/* h and range as constants unroll the stencils. */
static inline void apply(size_t h, size_t range, const ovr_mlmi *plan,
                         const double *P, double *w)
{
    const double *u = P;
    for (int s = 0; s < plan->depth; s++) {
        const ovr_mlmi_step *step = &plan->step[s];
        split(step->n, u, step->even, step->odd);
        transfer(h, plan, step, plan->values);
        u = plan->values;
    }
    if (plan->depth == 0) {
        dense_sum(plan, u, plan->scale, w);
        return;
    }
    dense_sum(plan, u, 1, plan->step[plan->depth - 1].sum);
    for (int s = plan->depth - 1; s >= 0; s--) {
        const ovr_mlmi_step *step = &plan->step[s];
        double *result = s ? plan->step[s - 1].sum : w;
        correct_even(h, range, step);
        interpolate_odd(h, range, plan, step, plan->output);
        merge(step->n, step->sum + h, plan->output, result);
    }
    for (size_t i = 0; i < plan->n; i++)
        w[i] *= plan->scale;
}

void OVR_KERNEL(deformation)(const ovr_mlmi *plan, const double *P, double *w)
{
    if (plan->half_order == 5 && plan->half_range == 8)
        apply(5, 8, plan, P, w);
    else if (plan->half_order == 3 && plan->half_range == 8)
        apply(3, 8, plan, P, w);
    else
        apply(plan->half_order, plan->half_range, plan, P, w);
}
