/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "multigrid/deflation.h"

#include <math.h>
#include <string.h>

#include "multigrid/field.h"

enum { STRIDE = 16, MOST = 128 };

ovr_status ovr_deflation_take(ovr_deflation *d, size_t n, ovr_arena *arena,
                              ovr_error *err)
{
    size_t s = STRIDE;
    while ((n - 1) / s > MOST)
        s *= 2;
    const size_t count = (n - 1) / s > 2 ? (n - 1) / s - 1 : 0;
    *d = (ovr_deflation){.stride = s, .count = count};
    if (!count)
        return OVR_OK;
    const size_t width = (n - 1) / s + count + 2, m = count + 1;
    d->hat = ovr_field(arena, s * width, err);
    d->columns = d->hat ? ovr_field(arena, n * m, err) : NULL;
    d->matrix = d->columns ? ovr_field(arena, m * m, err) : NULL;
    d->value = d->matrix ? ovr_field(arena, m, err) : NULL;
    d->pivot = d->value ? ovr_arena_take(arena, m, sizeof *d->pivot, err)
                        : NULL;
    return d->pivot ? OVR_OK : OVR_NO_MEMORY;
}

/* Influences of a hat on nodes r + s (far - x) away from its middle, r < s. */
static void fill_hats(ovr_deflation *d, size_t n, const double *kernel)
{
    const ptrdiff_t s = (ptrdiff_t)d->stride, most = (ptrdiff_t)n;
    const ptrdiff_t far = (most - 1) / s;
    const ptrdiff_t width = far + (ptrdiff_t)d->count + 2;
    for (ptrdiff_t r = 0; r < s; r++)
        for (ptrdiff_t x = 0; x < width; x++) {
            ptrdiff_t distance = r + s * (far - x);
            double sum = 0;
            for (ptrdiff_t m = 1 - s; m < s; m++) {
                ptrdiff_t at = distance - m;
                at = at > most ? most : at < -most ? -most : at;
                sum += (1 - fabs((double)m) / (double)s) * kernel[at];
            }
            d->hat[r * width + x] = sum;
        }
}

/* Influences of all hats on node j. */
static const double *hats_on(const ovr_deflation *d, size_t n, size_t j)
{
    const size_t s = d->stride, far = (n - 1) / s;
    return d->hat + (j % s) * (far + d->count + 2) + far + 1 - j / s;
}

/* Weights of the hats before and after node i; their numbers are i/s - 1 and
 * i/s. */
static double weight_after(const ovr_deflation *d, size_t i)
{
    return (double)(i % d->stride) / (double)d->stride;
}

/* Adds a row of A P with its weights to two rows of R A P. */
static void restrict_row(const ovr_deflation *d, const ovr_kernels *run,
                         size_t i, const double *from)
{
    const size_t m = d->count + 1, after = i / d->stride;
    const double share = weight_after(d, i);
    if (after > 0 && after <= d->count) {
        double *to = d->matrix + (after - 1) * m;
        run->combine(m, 1, to, 1 - share, from, to);
    }
    if (after < d->count) {
        double *to = d->matrix + after * m;
        run->combine(m, 1, to, share, from, to);
    }
}

static void make_row(const ovr_deflation *d, const ovr_kernels *run,
                     const ovr_newton_row *row, size_t n, size_t i)
{
    const size_t m = d->count + 1;
    double *to = d->columns + i * m;
    memset(to, 0, m * sizeof *to);
    for (size_t k = i == 1; k < 4 && i + k < n + 2; k++) {
        const size_t j = i + k - 2, after = j / d->stride;
        const double share = weight_after(d, j);
        run->combine(d->count, 1, to, row->e[k], hats_on(d, n, j), to);
        if (after > 0 && after <= d->count)
            to[after - 1] += row->local[k] * (1 - share);
        if (after < d->count)
            to[after] += row->local[k] * share;
        to[d->count] -= row->e[k];
    }
}

static bool factor(ovr_deflation *d, const ovr_kernels *run)
{
    const size_t m = d->count + 1;
    for (size_t c = 0; c < m; c++) {
        size_t best = c;
        for (size_t i = c + 1; i < m; i++)
            if (fabs(d->matrix[i * m + c]) > fabs(d->matrix[best * m + c]))
                best = i;
        double *top = d->matrix + c * m, *other = d->matrix + best * m;
        for (size_t j = 0; best != c && j < m; j++) {
            double value = top[j];
            top[j] = other[j];
            other[j] = value;
        }
        d->pivot[c] = best;
        if (!(fabs(top[c]) > 0 && isfinite(top[c])))
            return false;
        top[c] = 1 / top[c];
        for (size_t i = c + 1; i < m; i++) {
            double *row = d->matrix + i * m, share = row[c] * top[c];
            row[c] = share;
            run->combine(m - c - 1, 1, row + c + 1, -share, top + c + 1,
                         row + c + 1);
        }
    }
    return true;
}

bool ovr_deflation_factor(ovr_deflation *d, const ovr_kernels *run,
                          const ovr_newton_row *row, size_t n, double D,
                          const double *kernel)
{
    const size_t m = d->count + 1;
    double *force = d->matrix + d->count * m;
    if (!d->count)
        return false;
    if (d->of != kernel[0]) { /* the influence does not change in a run */
        fill_hats(d, n, kernel);
        d->of = kernel[0];
    }
    memset(d->matrix, 0, m * m * sizeof *d->matrix);
    for (size_t i = 1; i + 1 < n; i++) {
        make_row(d, run, &row[i], n, i);
        restrict_row(d, run, i, d->columns + i * m);
    }
    for (size_t j = 0; j < d->count; j++)
        force[j] = D * (double)d->stride;
    return factor(d, run);
}

static void solve(const ovr_deflation *d, double *x)
{
    const size_t m = d->count + 1;
    for (size_t c = 0; c < m; c++) {
        double value = x[d->pivot[c]];
        x[d->pivot[c]] = x[c];
        x[c] = value;
    }
    for (size_t i = 1; i < m; i++)
        for (size_t j = 0; j < i; j++)
            x[i] -= d->matrix[i * m + j] * x[j];
    for (size_t i = m; i-- > 0;) {
        for (size_t j = i + 1; j < m; j++)
            x[i] -= d->matrix[i * m + j] * x[j];
        x[i] *= d->matrix[i * m + i];
    }
}

void ovr_deflation_apply(ovr_deflation *d, const ovr_kernels *run, size_t n,
                         double D, const double *v, double *u)
{
    const size_t m = d->count + 1;
    double *x = d->value, sum = 0;
    memset(x, 0, m * sizeof *x);
    for (size_t i = 1; i + 1 < n; i++) {
        const size_t after = i / d->stride;
        const double share = weight_after(d, i);
        if (after > 0 && after <= d->count)
            x[after - 1] += (1 - share) * v[i - 1];
        if (after < d->count)
            x[after] += share * v[i - 1];
    }
    x[d->count] = v[n - 2];
    solve(d, x);
    for (size_t i = 1; i + 1 < n; i++)
        u[i - 1] = v[i - 1] - run->gain(m, d->columns + i * m, x, NULL);
    for (size_t j = 0; j < d->count; j++)
        sum += x[j];
    u[n - 2] = v[n - 2] - D * (double)d->stride * sum;
}

void ovr_deflation_add(const ovr_deflation *d, size_t n, double *step)
{
    for (size_t i = 1; i + 1 < n; i++) {
        const size_t after = i / d->stride;
        const double share = weight_after(d, i);
        if (after > 0 && after <= d->count)
            step[i] += (1 - share) * d->value[after - 1];
        if (after < d->count)
            step[i] += share * d->value[after];
    }
    step[n] += d->value[d->count];
}
