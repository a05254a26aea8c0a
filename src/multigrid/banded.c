/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/banded.h"

#include <math.h>

#include "multigrid/field.h"

ovr_status ovr_banded_take(ovr_banded *A, size_t n, ovr_arena *arena,
                           ovr_error *err)
{
    A->row = ovr_field(arena, n * OVR_BAND_WIDTH, err);
    A->factor = A->row ? ovr_field(arena, n * OVR_BAND, err) : NULL;
    A->pivot = A->factor ? ovr_arena_take(arena, n, sizeof *A->pivot, err)
                         : NULL;
    return A->pivot ? OVR_OK : OVR_NO_MEMORY;
}

/* A_ij to write. */
static double *at(const ovr_banded *A, size_t i, size_t j)
{
    return A->row + i * OVR_BAND_WIDTH + j + OVR_BAND - i;
}

static size_t minimum(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t largest_in(const ovr_banded *A, size_t n, size_t c)
{
    size_t best = c, end = minimum(n, c + OVR_BAND + 1);
    for (size_t i = c + 1; i < end; i++)
        if (fabs(*at(A, i, c)) > fabs(*at(A, best, c)))
            best = i;
    return best;
}

/* Exchanges rows from column c on. */
static void exchange(const ovr_banded *A, size_t c, size_t other, size_t count)
{
    double *a = at(A, c, c), *b = at(A, other, c);
    for (size_t j = 0; j < count; j++) {
        double value = a[j];
        a[j] = b[j];
        b[j] = value;
    }
}

/* The diagonal holds its inverse when its column is done. */
bool ovr_banded_factor(ovr_banded *A, size_t n)
{
    for (size_t c = 0; c < n; c++) {
        size_t end = minimum(n, c + OVR_BAND + 1);
        size_t count = minimum(n - c, 2 * OVR_BAND + 1);
        size_t best = A->pivot[c] = largest_in(A, n, c);
        if (best != c)
            exchange(A, c, best, count);
        double *top = at(A, c, c), inverse = 1 / top[0];
        if (!(fabs(top[0]) > 0 && isfinite(top[0])))
            return false;
        for (size_t i = c + 1; i < end; i++) {
            double *row = at(A, i, c), factor = row[0] * inverse;
            A->factor[c * OVR_BAND + i - c - 1] = factor;
            for (size_t j = 1; j < count; j++)
                row[j] -= factor * top[j];
        }
        top[0] = inverse;
    }
    return true;
}

static void forward(const ovr_banded *A, size_t n, double *x)
{
    for (size_t c = 0; c < n; c++) {
        const double *factor = A->factor + c * OVR_BAND;
        size_t end = minimum(n, c + OVR_BAND + 1), best = A->pivot[c];
        double value = x[best];
        x[best] = x[c];
        x[c] = value;
        for (size_t i = c + 1; i < end; i++)
            x[i] -= factor[i - c - 1] * value;
    }
}

/* sum_j row_j x_j of the neighbours j = 2.. 2 BAND, in three chains. */
static double beyond_the_next(const double *row, const double *x)
{
    double a = 0, b = 0, c = 0;
    for (size_t j = 2; j < 2 * OVR_BAND; j += 3) {
        a += row[j] * x[j];
        b += row[j + 1] * x[j + 1];
        c += row[j + 2] * x[j + 2];
    }
    return a + b + c;
}
_Static_assert((2 * OVR_BAND - 1) % 3 == 0, "neighbours in three chains");

/* The neighbour that was found last is taken off last: what waits for it is
 * two operations long, and the sums of several rows run beside each other. */
static void backward(const ovr_banded *A, size_t n, double *x)
{
    for (size_t i = n; i-- > 0;) {
        const double *row = at(A, i, i);
        double value = x[i];
        if (i + 2 * OVR_BAND < n)
            value -= beyond_the_next(row, x + i);
        else
            for (size_t j = 2; i + j < n; j++)
                value -= row[j] * x[i + j];
        if (i + 1 < n)
            value -= row[1] * x[i + 1];
        x[i] = value * row[0];
    }
}

void ovr_banded_solve(const ovr_banded *A, size_t n, double *x)
{
    forward(A, n, x);
    backward(A, n, x);
}
