/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dense linear algebra for the coarsest grid.
 */
#include <math.h>
#include <string.h>

#include "multigrid/kernels.h"
#include "multigrid/vector.h"

/* row_j = c_0 k_{j+2} + c_1 k_{j+1} + c_2 k_j + c_3 k_{j-1} */
void OVR_KERNEL(dense_row)(size_t n, const double c[4], const double *k,
                           double *row)
{
    for (size_t j = 0; j < n; j += VEC) {
        vec sum = c[0] * load(k + j + 2);
        sum = fused(all(c[1]), load(k + j + 1), sum);
        sum = fused(all(c[2]), load(k + j), sum);
        store(row + j, fused(all(c[3]), load(k + j - 1), sum));
    }
}

/* PANEL: rows subtracted from the rows below in one pass. TOGETHER: number of
 * rows below that are processed together, to have enough independent
 * operations. */
enum { PANEL = 4, TOGETHER = 4 };

/* True if one of x_from .. x_{to-1} is more than ten times x_from. */
static bool has_larger(const double *x, size_t from, size_t to)
{
    vec bound = all(10 * fabs(x[from]));
    ivec found = {0};
    size_t j = from;
    for (; j + VEC <= to; j += VEC) {
        vec here = load(x + j);
        found |= (here > bound) | (here < -bound);
    }
    for (; j < to; j++)
        if (fabs(x[j]) > bound[0])
            return true;
    return any(found);
}

/* Index of the pivot among x_from .. x_{to-1}: the first, unless another one is
 * much larger. Then the largest. */
static size_t pivot(const double *x, size_t from, size_t to)
{
    size_t best = from;
    if (!has_larger(x, from, to))
        return from;
    for (size_t j = from + 1; j < to; j++)
        best = fabs(x[j]) > fabs(x[best]) ? j : best;
    return best;
}

static void exchange_columns(double *A, size_t stride, size_t m, size_t c,
                             size_t d)
{
    for (size_t i = 0; i < m; i++) {
        double t = A[i * stride + c];
        A[i * stride + c] = A[i * stride + d];
        A[i * stride + d] = t;
    }
}

/* Computes the factors by which the `count` rows of the panel at row and column
 * c are subtracted from a row; each depends on the previous ones. */
static INLINE void find_factors(const double *row, const double *top,
                                size_t stride, const double *inverse,
                                size_t count, size_t c, double factor[PANEL])
{
    UNROLL
    for (size_t q = 0; q < count; q++) {
        double sum = row[c + q];
        UNROLL
        for (size_t p = 0; p < q; p++)
            sum -= factor[p] * top[p * stride + c + q];
        factor[q] = sum * inverse[q];
    }
}

/* row_rj -= sum_q factor_rq top_qj for `rows` rows, j from the vector that
 * contains column c + count up to m. Elements to the left are not used again.
 */
static INLINE void subtract_panel(double *row, size_t rows, const double *top,
                                  size_t stride, const double *inverse,
                                  size_t count, size_t c, size_t m)
{
    double factor[TOGETHER][PANEL];
    UNROLL
    for (size_t r = 0; r < rows; r++)
        find_factors(row + r * stride, top, stride, inverse, count, c,
                     factor[r]);
    for (size_t j = (c + count) / VEC * VEC; j <= m; j += VEC) {
        vec above[PANEL];
        UNROLL
        for (size_t q = 0; q < count; q++)
            above[q] = load(top + q * stride + j);
        UNROLL
        for (size_t r = 0; r < rows; r++) {
            vec sum = load(row + r * stride + j);
            UNROLL
            for (size_t q = 0; q < count; q++)
                sum = less(sum, all(factor[r][q]), above[q]);
            store(row + r * stride + j, sum);
        }
    }
}

/* b_i minus the sum of A_ij x_j over the unknowns solved so far; the rest of x
 * is zero. */
static inline double remainder_of(const double *row, size_t from, size_t m,
                                  const double *x)
{
    vec dot = all(0);
    for (size_t j = from / VEC * VEC; j < m; j += VEC)
        dot = fused(load(row + j), load(x + j), dot);
    return row[m] - sum_of_lanes(dot);
}

/* Back substitution in panels of rows, from the last; the diagonal contains its
 * inverse. */
static void back_substitute(const double *A, size_t stride, size_t m, double *x)
{
    memset(x, 0, (m + VEC) * sizeof *x);
    for (size_t end = m; end > 0;) {
        size_t width = (end - 1) % PANEL + 1, begin = end - width;
        double rest[PANEL];
        for (size_t r = 0; r < width; r++)
            rest[r] = remainder_of(A + (begin + r) * stride, end, m, x);
        for (size_t i = end; i-- > begin;) {
            const double *row = A + i * stride;
            double sum = rest[i - begin];
            for (size_t j = i + 1; j < end; j++)
                sum -= row[j] * x[j];
            x[i] = sum * row[i];
        }
        end = begin;
    }
}

/* Factors the panel of rows that begins at row c. Returns false if it is
 * singular. */
static bool factor_panel(double *A, size_t stride, size_t m, size_t c,
                         size_t width, double *inverse)
{
    double *top = A + c * stride;
    for (size_t q = 0; q < width; q++) {
        double *row = top + q * stride;
        if (q)
            subtract_panel(row, 1, top, stride, inverse, q, c, m);
        size_t best = pivot(row, c + q, m);
        row[m + 1] = (double)best;
        if (best != c + q)
            exchange_columns(A, stride, m, c + q, best);
        if (!(fabs(row[c + q]) > 0))
            return false;
        row[c + q] = inverse[q] = 1 / row[c + q];
    }
    return true;
}

/* Subtracts the panel from all rows below it; constant counts let the compiler
 * use registers. */
static void subtract_below(double *A, size_t stride, size_t m, size_t c,
                           const double *inverse)
{
    const double *top = A + c * stride;
    size_t i = c + PANEL;
    for (; i + TOGETHER <= m; i += TOGETHER)
        subtract_panel(A + i * stride, TOGETHER, top, stride, inverse, PANEL, c,
                       m);
    for (; i < m; i++)
        subtract_panel(A + i * stride, 1, top, stride, inverse, PANEL, c, m);
}

/* Clears the space after b. Whole vectors extend into it, and infinite values
 * from a failed solve would spoil later ones (0 times infinity is NaN). */
static void clear_workspace(double *A, size_t stride, size_t m)
{
    size_t end = (m + VEC) / VEC * VEC;
    for (size_t i = 0; i < m; i++)
        for (size_t j = m + 1; j < end; j++)
            A[i * stride + j] = 0;
}

/*
 * Solves A x = b by Gaussian elimination. The pivot of a row is its diagonal,
 * or a much larger value of the row, so that no search down a column is
 * necessary; columns are exchanged. A has m rows of `stride` values, at least m
 * + 8: b in column m, then space for whole vectors and for the exchanges. x has
 * space for m + 8 values. Returns false if A is singular.
 */
bool OVR_KERNEL(dense_solve)(size_t m, size_t stride, double *A, double *x)
{
    clear_workspace(A, stride, m);
    for (size_t c = 0; c < m; c += PANEL) {
        size_t width = m - c < PANEL ? m - c : PANEL;
        double inverse[PANEL];
        if (!factor_panel(A, stride, m, c, width, inverse))
            return false;
        subtract_below(A, stride, m, c, inverse);
    }
    back_substitute(A, stride, m, x);
    for (size_t c = m; c-- > 0;) {
        size_t best = (size_t)A[c * stride + m + 1];
        double t = x[c];
        x[c] = x[best];
        x[best] = t;
    }
    return true;
}
