/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Execution of an MLMI plan (method in deformation.h).
 *
 * Layout, known to this file only: lane s of vector J holds node s S + J, S
 * nodes a lane.  A neighbour in space is the next vector, so every stencil is
 * made of whole aligned vectors, and coarsening stays within a lane.  Vectors
 * -halo..-1 and S..S+halo-1 repeat what the neighbouring lanes hold; there the
 * first and the last lane hold the ghost nodes outside the grid.
 *
 * Down: transfer.  Dense sum in natural order.  Up: correct the even outputs,
 * interpolate and correct the odd ones.  Symmetric stencils add the pair of
 * values first.
 */
#include <string.h>

#include "multigrid/deformation.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Vectors made in one go, so that what one loads the next finds in a register;
 * loops overshoot by less than that. */
enum { BLOCK = VEC == 8 ? 8 : 4 };

static inline vec at(const double *x, ptrdiff_t J)
{
    return load(x + J * VEC);
}

static inline void put(double *x, ptrdiff_t J, vec v)
{
    store(x + J * VEC, v);
}

/* sum_b += c (x_{step b + right} + x_{step b + left}) */
static inline void add_pair(vec sum[BLOCK], double c, const double *x,
                            ptrdiff_t step, ptrdiff_t right, ptrdiff_t left)
{
    for (ptrdiff_t b = 0; b < BLOCK; b++)
        sum[b] = fused(at(x, step * b + right) + at(x, step * b + left), all(c),
                       sum[b]);
}

/* Repeats the ends of each lane beyond the ends of its neighbours. */
static inline void repeat_ends(double *x, ptrdiff_t S, ptrdiff_t halo)
{
    for (ptrdiff_t J = -halo; J < 0; J++)
        put(x, J, lanes_up(at(x, J), at(x, S + J)));
    for (ptrdiff_t J = S; J < S + halo; J++)
        put(x, J, lanes_down(at(x, J - S), at(x, J)));
}

/* U_J = u_{2J} + sum_k weight_k (u_{2J+1+2k} + u_{2J-1-2k}) */
static inline void transfer(ptrdiff_t h, const double *weight, const double *u,
                            double *U, ptrdiff_t from, ptrdiff_t to)
{
    for (ptrdiff_t J = from; J < to; J += BLOCK) {
        vec sum[BLOCK];
        for (ptrdiff_t b = 0; b < BLOCK; b++)
            sum[b] = at(u, 2 * (J + b));
        UNROLL
        for (ptrdiff_t k = 0; k < h; k++)
            add_pair(sum, weight[k], u, 2, 2 * J + 1 + 2 * k,
                     2 * J - 1 - 2 * k);
        for (ptrdiff_t b = 0; b < BLOCK; b++)
            put(U, J + b, sum[b]);
    }
}

/* even_J += sum_k near_k (u_{2J+1+2k} + u_{2J-1-2k}), distances 2k + 1 */
static inline void correct_even(ptrdiff_t range, const double *near,
                                const double *u, double *even, ptrdiff_t from,
                                ptrdiff_t to)
{
    for (ptrdiff_t J = from; J < to; J += BLOCK) {
        vec sum[BLOCK];
        for (ptrdiff_t b = 0; b < BLOCK; b++)
            sum[b] = at(even, J + b);
        UNROLL
        for (ptrdiff_t k = 0; k < range / 2; k++)
            add_pair(sum, near[k], u, 2, 2 * J + 1 + 2 * k, 2 * J - 1 - 2 * k);
        for (ptrdiff_t b = 0; b < BLOCK; b++)
            put(even, J + b, sum[b]);
    }
}

/* result_{2J+1} = sum_k weight_k (even_{J+1+k} + even_{J-k})
 *               + near_0 u_{2J+1} + sum_k near_k (u_{2J+1+k} + u_{2J+1-k}) */
static inline void interpolate_odd(ptrdiff_t h, ptrdiff_t range,
                                   const double *weight, const double *near,
                                   const double *u, const double *even,
                                   double *result, ptrdiff_t from, ptrdiff_t to)
{
    for (ptrdiff_t J = from; J < to; J += BLOCK) {
        vec sum[BLOCK];
        for (ptrdiff_t b = 0; b < BLOCK; b++)
            sum[b] = all(near[0]) * at(u, 2 * (J + b) + 1);
        UNROLL
        for (ptrdiff_t k = 0; k < h; k++)
            add_pair(sum, weight[k], even, 1, J + 1 + k, J - k);
        /* in this order the next pairs but one are the last, shifted */
        UNROLL
        for (ptrdiff_t k = 1; k <= range; k += 2)
            add_pair(sum, near[k], u, 2, 2 * J + 1 + k, 2 * J + 1 - k);
        UNROLL
        for (ptrdiff_t k = 2; k <= range; k += 2)
            add_pair(sum, near[k], u, 2, 2 * J + 1 + k, 2 * J + 1 - k);
        for (ptrdiff_t b = 0; b < BLOCK; b++) {
            put(result, 2 * (J + b), at(even, J + b));
            put(result, 2 * (J + b) + 1, sum[b]);
        }
    }
}

/* Natural order to lanes and back, S >= VEC: the last tile overlaps. */
static inline void to_lanes(const double *P, ptrdiff_t S, double *u)
{
    for (ptrdiff_t J = 0; J < S; J += VEC) {
        ptrdiff_t start = J + VEC <= S ? J : S - VEC;
        vec tile[VEC];
        for (ptrdiff_t l = 0; l < VEC; l++)
            tile[l] = load(P + l * S + start);
        transpose(tile);
        for (ptrdiff_t k = 0; k < VEC; k++)
            put(u, start + k, tile[k]);
    }
    u[S * VEC + VEC - 1] = P[VEC * S];
}

static inline void from_lanes(const double *out, ptrdiff_t S, double *w)
{
    for (ptrdiff_t J = 0; J < S; J += VEC) {
        ptrdiff_t start = J + VEC <= S ? J : S - VEC;
        vec tile[VEC];
        for (ptrdiff_t k = 0; k < VEC; k++)
            tile[k] = at(out, start + k);
        transpose(tile);
        for (ptrdiff_t l = 0; l < VEC; l++)
            store(w + l * S + start, tile[l]);
    }
    w[VEC * S] = out[S * VEC + VEC - 1];
}

/* w_i = sum_j kernel(i - j) U_j, `count` nodes */
static void dense_sum(const double *kernel, size_t count, const double *U,
                      double *w)
{
    enum { REGISTERS = 4 };
    for (size_t i = 0; i < count; i += REGISTERS * VEC) {
        vec sum[REGISTERS] = {{0}};
        for (size_t j = 0; j < count; j++)
            for (size_t b = 0; b < REGISTERS; b++)
                sum[b] = fused(all(U[j]), load(kernel + i - j + b * VEC),
                               sum[b]);
        for (size_t b = 0; b < REGISTERS; b++)
            store(w + i + b * VEC, sum[b]);
    }
}

/* The coarsest grid: left ghosts, the lanes one after another, right ghosts.
 */
static void dense_lanes(const ovr_mlmi *plan, ptrdiff_t S, ptrdiff_t left,
                        ptrdiff_t right, const double *u, double *out)
{
    double *U = plan->natural, *w = plan->result;
    for (ptrdiff_t l = 0; l < VEC; l++)
        for (ptrdiff_t J = l ? 0 : -left; J < (l < VEC - 1 ? S : S + right);
             J++)
            U[left + l * S + J] = u[J * VEC + l];
    dense_sum(plan->kernel, (size_t)(left + VEC * S + right), U, w);
    for (ptrdiff_t l = 0; l < VEC; l++)
        for (ptrdiff_t J = l ? 0 : -left; J < (l < VEC - 1 ? S : S + right);
             J++)
            out[J * VEC + l] = w[left + l * S + J];
}

/* h and range as constants unroll the stencils. */
static inline void apply(ptrdiff_t h, ptrdiff_t range, const ovr_mlmi *plan,
                         ptrdiff_t S, const double *P, double *w)
{
    const ovr_mlmi_grid *grid = plan->grid;
    ptrdiff_t pad = plan->pad * VEC;
    int last = plan->depth > 0 ? plan->depth : 0;
    to_lanes(P, S, grid[0].u + pad);
    for (int s = 0; s < last; s++) {
        const ovr_mlmi_grid *coarse = &grid[s + 1];
        repeat_ends(grid[s].u + pad, S >> s, range);
        transfer(h, plan->weight, grid[s].u + pad, coarse->u + pad,
                 -coarse->left, (S >> (s + 1)) + coarse->right);
    }
    dense_lanes(plan, S >> last, grid[last].left, grid[last].right,
                grid[last].u + pad, grid[last].out + pad);
    for (int s = last - 1; s >= 0; s--) {
        const ovr_mlmi_grid *fine = &grid[s], *coarse = &grid[s + 1];
        ptrdiff_t half = S >> (s + 1);
        correct_even(range, fine->near_even, fine->u + pad, coarse->out + pad,
                     -coarse->left, half + coarse->right);
        repeat_ends(coarse->out + pad, half, h);
        interpolate_odd(h, range, plan->weight, fine->near_odd, fine->u + pad,
                        coarse->out + pad, fine->out + pad, -fine->left / 2,
                        half + fine->right / 2);
    }
    from_lanes(grid[0].out + pad, S, w);
}

/* Those that ovr_mlmi_choose gives for the finer grids. */
static inline void choose_stencil(const ovr_mlmi *plan, ptrdiff_t S,
                                  const double *P, double *w)
{
    if (plan->half_order == 5 && plan->range == 10)
        apply(5, 10, plan, S, P, w);
    else if (plan->half_order == 5 && plan->range == 12)
        apply(5, 12, plan, S, P, w);
    else if (plan->half_order == 5 && plan->range == 14)
        apply(5, 14, plan, S, P, w);
    else if (plan->half_order == 6 && plan->range == 16)
        apply(6, 16, plan, S, P, w);
    else
        apply(plan->half_order, plan->range, plan, S, P, w);
}

void OVR_KERNEL(deformation)(const ovr_mlmi *plan, const double *P, double *w)
{
    size_t n = plan->n, S = ovr_mlmi_lane(plan, VEC);
    if (plan->depth == 0) {
        dense_sum(plan->kernel, n, P, w);
    } else if (VEC * S + 1 == n) {
        choose_stencil(plan, (ptrdiff_t)S, P, w);
    } else { /* not a grid that the lanes divide: with zeros behind it */
        memcpy(plan->padded, P, n * sizeof *P);
        choose_stencil(plan, (ptrdiff_t)S, plan->padded, plan->padded_result);
        memcpy(w, plan->padded_result, n * sizeof *w);
    }
}
