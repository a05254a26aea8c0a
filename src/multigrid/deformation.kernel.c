/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Execution of an MLMI plan (method in deformation.h).
 *
 * P, w and the fields of coarser grids are stored in lanes (lanes.h).  Halos
 * are as wide as the stencils reach; In the first and last lane they contain
 * the ghost nodes outside the grid.
 *
 * Coarsening: transfer P. Coarsest grid: dense sum in the order of the nodes.
 * Refinement: correct the even outputs, interpolate and correct the odd
 * outputs, chunk by chunk, so that data stay in the cache. Symmetric stencils
 * add pairs of values first.
 */
#include "multigrid/deformation.h"
#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* Vectors computed together, so that loaded values are reused from registers.
 * Loops may overshoot by less than a block. */
enum { BLOCK = VEC == 8 ? 8 : 4, CHUNK = 8 * BLOCK };

static inline ptrdiff_t downto(ptrdiff_t count)
{
    return count / BLOCK * BLOCK;
}

/* count >= 0 rounded up to whole blocks */
static inline ptrdiff_t upto(ptrdiff_t count)
{
    return downto(count + BLOCK - 1);
}

/* sum_b += c (x_{step b + right} + x_{step b + left}) */
static inline void add_pair(vec sum[BLOCK], double c, const double *x,
                            ptrdiff_t step, ptrdiff_t right, ptrdiff_t left)
{
    for (ptrdiff_t b = 0; b < BLOCK; b++)
        sum[b] = fused(at(x, step * b + right) + at(x, step * b + left), all(c),
                       sum[b]);
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
        /* in this order the pairs of two steps later are the previous ones,
         * shifted */
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

/* Output vectors of the dense sum that are kept in registers. */
enum { TILE = 5 };

/* Adds the products of kernel vectors b - t with U of input vector t, one
 * element each: 2 TILE - 1 kernel vectors suffice for TILE^2 products. */
static INLINE void add_tile(const double *kernel, const double *U,
                            vec sum[TILE])
{
    UNROLL
    for (int d = 1 - TILE; d < TILE; d++) {
        vec k = load(kernel + d * VEC);
        UNROLL
        for (int b = d > 0 ? d : 0; b < (d < 0 ? TILE + d : TILE); b++)
            sum[b] = fused(all(U[(b - d) * VEC]), k, sum[b]);
    }
}

/* w_i = sum_j kernel(i - j) U_j for `count` nodes; U is zero beyond them. */
static void dense_sum(const double *kernel, ptrdiff_t count, const double *U,
                      double *w)
{
    for (ptrdiff_t i = 0; i < count; i += TILE * VEC) {
        vec sum[TILE] = {{0}};
        for (ptrdiff_t j = 0; j < count; j += TILE * VEC)
            for (ptrdiff_t r = 0; r < VEC; r++)
                add_tile(kernel + i - j - r, U + j + r, sum);
        for (ptrdiff_t b = 0; b < TILE; b++)
            store(w + i + b * VEC, sum[b]);
    }
}

/* Dense sum on the coarsest grid: left ghosts, the lanes one after another,
 * right ghosts. */
static void dense_lanes(const ovr_mlmi *plan, ptrdiff_t S, ptrdiff_t left,
                        ptrdiff_t right, const double *u, double *out)
{
    double *U = plan->natural, *w = plan->result;
    for (ptrdiff_t l = 0; l < VEC; l++)
        for (ptrdiff_t J = l ? 0 : -left; J < (l < VEC - 1 ? S : S + right);
             J++)
            U[left + l * S + J] = u[J * VEC + l];
    dense_sum(plan->kernel, left + VEC * S + right, U, w);
    for (ptrdiff_t l = 0; l < VEC; l++)
        for (ptrdiff_t J = l ? 0 : -left; J < (l < VEC - 1 ? S : S + right);
             J++)
            out[J * VEC + l] = w[left + l * S + J];
}

/* Even outputs near the lane boundaries are completed first. */
static inline void refine(ptrdiff_t h, ptrdiff_t range, const ovr_mlmi *plan,
                          const ovr_mlmi_grid *fine,
                          const ovr_mlmi_grid *coarse, ptrdiff_t half,
                          const double *u, double *out)
{
    double *even = coarse->out;
    ptrdiff_t first = upto(h + coarse->left) - coarse->left;
    ptrdiff_t last = half - h > first ? first + downto(half - h - first)
                                      : first;
    ptrdiff_t end = half + fine->right / 2, done = first;
    correct_even(range, fine->near_even, u, even, -coarse->left, first);
    correct_even(range, fine->near_even, u, even, last, half + coarse->right);
    repeat_ends(even, half, h);
    for (ptrdiff_t J = -fine->left / 2; J < end; J += CHUNK) {
        ptrdiff_t to = J + CHUNK < end ? J + CHUNK : end;
        ptrdiff_t reach = first + upto(to + h - first);
        ptrdiff_t next = reach < last ? reach : last;
        if (next > done) {
            correct_even(range, fine->near_even, u, even, done, next);
            done = next;
        }
        interpolate_odd(h, range, plan->weight, fine->near_odd, u, even, out, J,
                        to);
    }
}

/* Constant h and range let the compiler unroll the stencils. */
static inline void apply(ptrdiff_t h, ptrdiff_t range, const ovr_mlmi *plan,
                         ptrdiff_t S, double *P, double *w)
{
    const ovr_mlmi_grid *grid = plan->grid;
    int last = plan->depth;
    for (int s = 0; s < last; s++) {
        const ovr_mlmi_grid *coarse = &grid[s + 1];
        double *u = s ? grid[s].u : P;
        repeat_ends(u, S >> s, range);
        transfer(h, plan->weight, u, coarse->u, -coarse->left,
                 (S >> (s + 1)) + coarse->right);
    }
    dense_lanes(plan, S >> last, grid[last].left, grid[last].right,
                last ? grid[last].u : P, last ? grid[last].out : w);
    for (int s = last - 1; s >= 0; s--)
        refine(h, range, plan, &grid[s], &grid[s + 1], S >> (s + 1),
               s ? grid[s].u : P, s ? grid[s].out : w);
}

void OVR_KERNEL(deformation)(const ovr_mlmi *plan, double *P, double *w)
{
    ptrdiff_t S = (ptrdiff_t)ovr_mlmi_lane(plan, VEC);
    /* Orders and ranges of coarse grids and of the finest grid up to level 12
     * (simulation/options.c). Unrolling the others would gain at most 2 % and
     * take as long to compile as all the rest. */
    if (plan->half_order == 3 && plan->range == 10)
        apply(3, 10, plan, S, P, w);
    else if (plan->half_order == 5 && plan->range == 10)
        apply(5, 10, plan, S, P, w);
    else
        apply(plan->half_order, plan->range, plan, S, P, w);
    if (plan->depth == 0)
        repeat_ends(P, S, OVR_HALO);
    repeat_ends(w, S, OVR_HALO);
}
