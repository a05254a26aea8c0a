/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planning of the multilevel integration: computes all numbers that depend on
 * the grid only (see deformation.h). */
#include "multigrid/deformation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "multigrid/field.h"
#include "multigrid/lanes.h"

/* --------------------------------------------- weights of the interpolation */

/*
 * Interpolation weights for a logarithmic kernel: symmetric weights at the
 * distances y_k = 1, 3, ..., 2h - 1 with sum 1 that minimize
 *     max x^1.5 |e(x)|,
 *     e(x) = ln x - sum_k weight_k [ln(x + y_k) + ln(x - y_k)]
 * over x > range.  (The errors of all distances add up: 1.5 was best of 0, 0.5,
 * ..., 2.)  Compared with Lagrange's weights, the deformation error is smaller
 * by factors of 12 (p = 6), 60 (p = 8) and 250 (p = 10).
 *
 * Lawson's method: least squares with weights lambda(x), lambda <- lambda x^1.5
 * |e|, until the largest errors are equal. The unknowns are all weights except
 * the first, which follows from the sum. Their columns are nearly linearly
 * dependent; they are therefore orthogonalized in extended precision.
 */

enum { POINTS = 120, ITERATIONS = 60 };

typedef struct fit {
    long double column[OVR_MLMI_MAX][POINTS]; /* the last is ln x */
    long double q[OVR_MLMI_MAX][POINTS];
    long double lambda[POINTS], importance[POINTS];
} fit;

/* Sample points: integers at first, then with growing steps, because e changes
 * slowly at large distances. */
static long double point(size_t j, size_t range)
{
    long double x = (long double)(range + 1 + j);
    return j < 64 ? x : x * powl(1.1L, (long double)(j - 64));
}

static void fill(fit *f, size_t h, size_t range)
{
    for (size_t j = 0; j < POINTS; j++) {
        long double x = point(j, range);
        /* ln(x^2 - y^2) - ln x^2: the common part is subtracted */
        long double first = log1pl(-1 / (x * x));
        f->column[h - 1][j] = -0.5L * first;
        f->lambda[j] = 1;
        f->importance[j] = powl(x, 1.5L);
        for (size_t k = 1; k < h; k++) {
            long double y = 2 * (long double)k + 1;
            f->column[k - 1][j] = log1pl(-y * y / (x * x)) - first;
        }
    }
}

static long double dot(const fit *f, const long double *a, const long double *b)
{
    long double sum = 0;
    for (size_t j = 0; j < POINTS; j++)
        sum += f->lambda[j] * a[j] * b[j];
    return sum;
}

/* Least squares by Gram-Schmidt on copies of the columns. The last column then
 * contains the error. */
static void least_squares(fit *f, size_t unknowns, long double solution[])
{
    long double(*q)[POINTS] = f->q;
    long double R[OVR_MLMI_MAX][OVR_MLMI_MAX] = {{0}};
    for (size_t c = 0; c <= unknowns; c++) {
        for (size_t j = 0; j < POINTS; j++)
            q[c][j] = f->column[c][j];
        for (size_t b = 0; b < c; b++) {
            R[b][c] = dot(f, q[b], q[c]);
            for (size_t j = 0; j < POINTS; j++)
                q[c][j] -= R[b][c] * q[b][j];
        }
        if (c == unknowns)
            break;
        long double size = sqrtl(dot(f, q[c], q[c]));
        R[c][c] = size;
        for (size_t j = 0; j < POINTS; j++)
            q[c][j] /= size;
    }
    for (size_t c = unknowns; c-- > 0;) {
        long double sum = R[c][unknowns];
        for (size_t k = c + 1; k < unknowns; k++)
            sum -= R[c][k] * solution[k];
        solution[c] = sum / R[c][c];
    }
}

/* Lagrange's weights, optimal at infinite distance. */
static void lagrange(size_t h, double weight[])
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

static void level_errors(fit *f, size_t unknowns)
{
    long double total = 0;
    for (size_t j = 0; j < POINTS; j++) {
        f->lambda[j] *= f->importance[j] * fabsl(f->q[unknowns][j]);
        total += f->lambda[j];
    }
    for (size_t j = 0; j < POINTS; j++)
        f->lambda[j] /= total;
}

void ovr_mlmi_fit_weights(size_t h, size_t range, double weight[])
{
    long double w[OVR_MLMI_MAX], first = 0.5L;
    fit f;
    if (range < 2 * h || h < 2 || h > 6) {
        lagrange(h, weight);
        return;
    }
    fill(&f, h, range);
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
        least_squares(&f, h - 1, w);
        level_errors(&f, h - 1);
    }
    for (size_t k = 1; k < h; k++) {
        weight[k] = (double)w[k - 1];
        first -= w[k - 1];
    }
    weight[0] = (double)first;
}

/* Results of the fit for the pairs in ovr_mlmi_choose. Computing them takes as
 * long as a fifth of a steady solution at level 8. */
static const struct {
    size_t h, range;
    double weight[6];
} fitted[] = {
    {3,
     10,
     {0x1.2a05b57d3b4b4p-1, -0x1.7870b71ffd4d4p-4, 0x1.421859b1179b9p-7}},
    {3,
     16,
     {0x1.2b310bf13ecb9p-1, -0x1.8653c476b5149p-4, 0x1.665b2765f5bfcp-7}},
    {5,
     10,
     {0x1.31455c5388257p-1, -0x1.dd50ed0ddac18p-4, 0x1.7421897129abep-6,
      -0x1.488b6d1ad393ep-9, 0x1.880df8971e39bp-14}},
    {5,
     12,
     {0x1.32b9ec9135f9fp-1, -0x1.f30f4376a559ap-4, 0x1.a9e47aa584488p-6,
      -0x1.bf06f46ad37dp-9, 0x1.7defcdd6275fdp-13}},
    {5,
     14,
     {0x1.339a1b475c2cbp-1, -0x1.0034e88835fddp-3, 0x1.cc6b610df2fcap-6,
      -0x1.08b0e293b3a1dp-8, 0x1.092cbb4911373p-12}},
    {6,
     16,
     {0x1.362b42e6b90d2p-1, -0x1.14e0313378dd7p-3, 0x1.22badda36c236p-5,
      -0x1.c059f581d3a69p-8, 0x1.9b247005a4ea5p-11, -0x1.3e6943d678cf8p-15}},
};

void ovr_mlmi_weights(size_t h, size_t range, double weight[])
{
    for (size_t i = 0; i < sizeof fitted / sizeof *fitted; i++)
        if (fitted[i].h == h && fitted[i].range == range) {
            memcpy(weight, fitted[i].weight, h * sizeof *weight);
            return;
        }
    ovr_mlmi_fit_weights(h, range, weight);
}

/* Below this number of nodes a dense sum is cheaper than further coarsening. */
enum { DENSE_NODES = 70 };

/*
 * f(d).  At large d the closed form suffers from cancellation (terms of size d
 * ln d, result of size ln d). Beyond 64 the series
 *     f = ln d - sum_k 1/(2k (2k+1) (2d)^(2k)),  k = 1, 2, ...
 * from log1p(+-1/(2d)) is used; the error of four terms is below 1e-18.
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
 * of which eight terms are used, with an error below 1e-19.
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

/* f(d) of a plan, including the parts added to the logarithmic kernel. */
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

/* Kernel of one grid at integer distances, up to the longest one needed by
 * corrections. */
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

/* Effective kernel of the even outputs at distance d, after their corrections.
 */
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

/* Number of coarsenings until the grid is small or the lanes are shorter than
 * the range. */
static int depth_of(size_t n, ptrdiff_t range)
{
    int depth = 0;
    while ((n >> depth) > DENSE_NODES &&
           (ptrdiff_t)((n - 1) / OVR_MAX_LANES >> depth) >= range &&
           depth < OVR_MLMI_DEPTH)
        depth++;
    return depth;
}

/* Number of ghost nodes of a coarse grid, from the reach of the finer grid's
 * stencils. */
static void count_ghosts(const ovr_mlmi *plan, const ovr_mlmi_grid *fine,
                         ovr_mlmi_grid *coarse)
{
    ptrdiff_t left = plan->half_order + fine->left / 2;
    ptrdiff_t right = plan->half_order + fine->right / 2;
    coarse->left = left + left % 2;
    coarse->right = right + right % 2;
}

/* Maximum number of nodes in the lanes, for any number of lanes. */
static size_t max_nodes(const ovr_mlmi *plan)
{
    size_t maximum = 0;
    for (size_t lanes = 1; lanes <= OVR_MAX_LANES; lanes *= 2) {
        size_t nodes = lanes * ovr_mlmi_lane(plan, lanes);
        maximum = nodes > maximum ? nodes : maximum;
    }
    return maximum;
}

/* Allocates an array of the grid that is coarsened `coarsenings` times. */
static double *allocate(const ovr_mlmi *plan, int coarsenings, ovr_arena *arena,
                        ovr_error *err)
{
    size_t nodes = max_nodes(plan) >> coarsenings;
    size_t pad = (size_t)plan->pad * OVR_MAX_LANES - OVR_FIELD_PAD;
    double *all = ovr_field(arena, nodes + 2 * pad, err);
    return all ? all + pad : NULL;
}

double *ovr_mlmi_field(const ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    return allocate(plan, 0, arena, err);
}

static void allocate_grids(ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    plan->grid[0].left = 0;
    plan->grid[0].right = 2;
    for (int s = 0; s <= plan->depth; s++) {
        ovr_mlmi_grid *grid = &plan->grid[s];
        grid->near_even = ovr_arena_take(arena, 3 * OVR_MLMI_MAX + 1,
                                         sizeof *grid->near_even, err);
        if (grid->near_even)
            grid->near_odd = grid->near_even + OVR_MLMI_MAX;
        if (s) {
            count_ghosts(plan, &plan->grid[s - 1], grid);
            grid->u = allocate(plan, s, arena, err);
            grid->out = allocate(plan, s, arena, err);
        }
    }
}

/* Number of nodes in the dense sum. */
static size_t dense_nodes(const ovr_mlmi *plan)
{
    const ovr_mlmi_grid *last = &plan->grid[plan->depth];
    return (max_nodes(plan) >> plan->depth) +
           (size_t)(last->left + last->right);
}

/* kernel[0] is the value at distance zero. */
static void allocate_dense(ovr_mlmi *plan, ovr_arena *arena, ovr_error *err)
{
    size_t count = dense_nodes(plan);
    double *kernel = ovr_field(arena, 2 * count + OVR_FIELD_PAD, err);
    plan->natural = ovr_field(arena, count, err);
    plan->result = ovr_field(arena, count, err);
    plan->kernel = kernel ? kernel + count : NULL;
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
    allocate_grids(plan, arena, err);
    allocate_dense(plan, arena, err);
    return ovr_arena_status(arena);
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
