/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Dense algebra of the coarsest grid.
 */
#include <math.h>

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

/* Rows that are taken off the rows below in one pass. */
enum { PANEL = 4 };

/* Where the largest of x_from .. x_{to-1} is. */
static size_t largest(const double *x, size_t from, size_t to)
{
    size_t best = from;
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

/* row_j -= sum_q factor_q top_qj, j = from..m */
static inline void subtract_rows(double *row, const double *top, size_t stride,
                                 const double *factor, size_t count,
                                 size_t from, size_t m)
{
    for (size_t j = from; j <= m; j += VEC) {
        vec sum = load(row + j);
        for (size_t q = 0; q < count; q++)
            sum = less(sum, all(factor[q]), load(top + q * stride + j));
        store(row + j, sum);
    }
}

/* Takes `count` rows of the panel that begins at row and column c off a row;
 * the factors come one from the other. */
static inline void take_off(double *row, const double *top, size_t stride,
                            const double *inverse, size_t count, size_t c,
                            size_t m)
{
    double factor[PANEL];
    for (size_t q = 0; q < count; q++) {
        double sum = row[c + q];
        for (size_t p = 0; p < q; p++)
            sum -= factor[p] * top[p * stride + c + q];
        factor[q] = sum * inverse[q];
    }
    subtract_rows(row, top, stride, factor, count, c + count, m);
}

static void back_substitute(const double *A, size_t stride, size_t m, double *x)
{
    for (size_t i = m; i-- > 0;) {
        const double *row = A + i * stride;
        double sum = row[m], part[VEC];
        vec dot = all(0);
        size_t j = i + 1;
        for (; j + VEC <= m; j += VEC)
            dot = fused(load(row + j), load(x + j), dot);
        store(part, dot);
        for (; j < m; j++)
            sum -= row[j] * x[j];
        for (size_t l = 0; l < VEC; l++)
            sum -= part[l];
        x[i] = sum / row[i];
    }
}

/*
 * x of A x = b by Gaussian elimination.  The pivot of a row is its largest
 * value, so that it is found, and columns are exchanged, without walking down
 * columns.  A has m rows of `stride` values, at least m + 8: b in column m,
 * then room for whole vectors and, behind b, for the exchanges.  x has room for
 * m values.  False when A is singular.
 */
bool OVR_KERNEL(dense_solve)(size_t m, size_t stride, double *A, double *x)
{
    for (size_t c = 0; c < m; c += PANEL) {
        size_t width = m - c < PANEL ? m - c : PANEL;
        double *top = A + c * stride, inverse[PANEL];
        for (size_t q = 0; q < width; q++) {
            double *row = top + q * stride;
            take_off(row, top, stride, inverse, q, c, m);
            size_t best = largest(row, c + q, m);
            row[m + 1] = (double)best;
            if (best != c + q)
                exchange_columns(A, stride, m, c + q, best);
            if (!(fabs(row[c + q]) > 0))
                return false;
            inverse[q] = 1 / row[c + q];
        }
        for (size_t i = c + PANEL; i < m; i++)
            take_off(A + i * stride, top, stride, inverse, PANEL, c, m);
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
