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

bool ovr_banded_factor(ovr_banded *A, size_t n)
{
    for (size_t c = 0; c < n; c++) {
        size_t end = minimum(n, c + OVR_BAND + 1);
        size_t count = minimum(n - c, 2 * OVR_BAND + 1);
        size_t best = A->pivot[c] = largest_in(A, n, c);
        if (best != c)
            exchange(A, c, best, count);
        const double *top = at(A, c, c);
        if (!(fabs(top[0]) > 0 && isfinite(top[0])))
            return false;
        for (size_t i = c + 1; i < end; i++) {
            double *row = at(A, i, c), factor = row[0] / top[0];
            A->factor[c * OVR_BAND + i - c - 1] = factor;
            for (size_t j = 1; j < count; j++)
                row[j] -= factor * top[j];
        }
    }
    return true;
}

void ovr_banded_solve(const ovr_banded *A, size_t n, double *x)
{
    for (size_t c = 0; c < n; c++) {
        size_t end = minimum(n, c + OVR_BAND + 1), best = A->pivot[c];
        double value = x[best];
        x[best] = x[c];
        x[c] = value;
        for (size_t i = c + 1; i < end; i++)
            x[i] -= A->factor[c * OVR_BAND + i - c - 1] * value;
    }
    for (size_t i = n; i-- > 0;) {
        const double *row = at(A, i, i);
        size_t count = minimum(n - i, 2 * OVR_BAND + 1);
        for (size_t j = 1; j < count; j++)
            x[i] -= row[j] * x[i + j];
        x[i] /= row[0];
    }
}
