/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "multigrid/plain.h"

void ovr_dense_row_plain(size_t n, const double c[4], const double *k,
                         double *row)
{
    for (size_t j = 0; j < n; j++, k++)
        row[j] = c[0] * k[2] + c[1] * k[1] + c[2] * k[0] + c[3] * k[-1];
}

/* Exchanges row c with the row, from c on, that has the largest value in column
 * c. */
static void pivot(size_t m, size_t stride, double *A, size_t c)
{
    size_t best = c;
    for (size_t i = c + 1; i < m; i++)
        if (fabs(A[i * stride + c]) > fabs(A[best * stride + c]))
            best = i;
    for (size_t j = c; j <= m; j++) {
        double t = A[c * stride + j];
        A[c * stride + j] = A[best * stride + j];
        A[best * stride + j] = t;
    }
}

/* Gaussian elimination with partial pivoting; b in column m. */
bool ovr_dense_solve_plain(size_t m, size_t stride, double *A, double *x)
{
    for (size_t c = 0; c < m; c++) {
        const double *top = A + c * stride;
        pivot(m, stride, A, c);
        if (!(fabs(top[c]) > 0))
            return false;
        for (double *row = A + (c + 1) * stride; row < A + m * stride;
             row += stride) {
            double factor = row[c] / top[c];
            for (size_t j = c; j <= m; j++)
                row[j] -= factor * top[j];
        }
    }
    for (size_t i = m; i-- > 0;) {
        const double *row = A + i * stride;
        x[i] = row[m];
        for (size_t j = i + 1; j < m; j++)
            x[i] -= row[j] * x[j];
        x[i] /= row[i];
    }
    return true;
}
