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

/* Columns eliminated in one pass over the rows below them. */
enum { PANEL = 4 };

static void exchange_rows(double *a, double *b, size_t count)
{
    for (size_t j = 0; j < count; j += VEC) {
        vec t = load(a + j);
        store(a + j, load(b + j));
        store(b + j, t);
    }
}

/* The largest value of a column below and at row c comes to row c. */
static bool pivot(double *A, size_t stride, size_t m, size_t c)
{
    size_t best = c;
    for (size_t i = c + 1; i < m; i++)
        if (fabs(A[i * stride + c]) > fabs(A[best * stride + c]))
            best = i;
    if (best != c)
        exchange_rows(A + c * stride, A + best * stride, m + 1);
    return fabs(A[c * stride + c]) > 0;
}

/* Columns c..c+width-1 of all rows below: factors replace them. */
static bool factor_panel(double *A, size_t stride, size_t m, size_t c,
                         size_t width)
{
    for (size_t p = 0; p < width; p++) {
        const double *top = A + c * stride + c;
        for (size_t i = c + 1; i < m; i++) {
            double *low = A + i * stride + c;
            for (size_t q = 0; q < p && c + q < i; q++)
                low[p] -= low[q] * top[q * stride + p];
        }
        if (!pivot(A, stride, m, c + p))
            return false;
        double inverse = 1 / top[p * stride + p];
        for (size_t i = c + p + 1; i < m; i++)
            A[i * stride + c + p] *= inverse;
    }
    return true;
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

/* The columns after the panel: rows of the panel first, one by one. */
static void update(double *A, size_t stride, size_t m, size_t c, size_t width)
{
    const double *top = A + c * stride;
    size_t end = c + width;
    for (size_t i = c + 1; i < m; i++) {
        double *row = A + i * stride;
        if (i >= end && width == PANEL)
            subtract_rows(row, top, stride, row + c, PANEL, end, m);
        else
            subtract_rows(row, top, stride, row + c, i < end ? i - c : width,
                          end, m);
    }
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
 * x of A x = b by Gaussian elimination with partial pivoting.  A has m rows of
 * `stride` values, at least m + 8: b in column m, then room for whole vectors.
 * False when A is singular.
 */
bool OVR_KERNEL(dense_solve)(size_t m, size_t stride, double *A, double *x)
{
    for (size_t c = 0; c < m; c += PANEL) {
        size_t width = m - c < PANEL ? m - c : PANEL;
        if (!factor_panel(A, stride, m, c, width))
            return false;
        update(A, stride, m, c, width);
    }
    back_substitute(A, stride, m, x);
    return true;
}
