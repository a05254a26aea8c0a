/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Missing heights and outliers.
 *
 * Outliers are detected by Hampel's test: r_i = z_i - median of its 11
 * neighbours; |r_i| > limit sigma with sigma = 1.4826 median |r|, which is the
 * standard deviation of Gaussian heights and does not feel the outliers.  The
 * neighbours in a map are 5 x 5 points.
 */
#include "surface/conditioning.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

enum { HALF = 5, WINDOW = 2 * HALF + 1, HALF_OF_MAP = 2, WINDOW_OF_MAP = 25 };

static double median_of(double *near, size_t count)
{
    if (!count)
        return NAN;
    gsl_sort(near, 1, count);
    return gsl_stats_median_from_sorted_data(near, 1, count);
}

static double median_about(size_t n, const double *z, size_t i)
{
    double near[WINDOW];
    size_t count = 0, last = i + HALF < n ? i + HALF : n - 1;
    for (size_t j = i > HALF ? i - HALF : 0; j <= last; j++)
        if (!isnan(z[j]))
            near[count++] = z[j];
    return median_of(near, count);
}

static double median_in_map(size_t nx, size_t ny, const double *z, size_t i,
                            size_t j)
{
    double near[WINDOW_OF_MAP];
    size_t count = 0;
    size_t right = i + HALF_OF_MAP < nx ? i + HALF_OF_MAP : nx - 1;
    size_t above = j + HALF_OF_MAP < ny ? j + HALF_OF_MAP : ny - 1;
    for (size_t m = j > HALF_OF_MAP ? j - HALF_OF_MAP : 0; m <= above; m++)
        for (size_t k = i > HALF_OF_MAP ? i - HALF_OF_MAP : 0; k <= right; k++)
            if (!isnan(z[m * nx + k]))
                near[count++] = z[m * nx + k];
    return median_of(near, count);
}

/* Marks the heights whose distance r from the median is too large. */
static size_t mark(size_t n, double *z, const double *r, double limit,
                   double *size)
{
    size_t count = 0, marked = 0;
    for (size_t i = 0; i < n; i++)
        if (!isnan(r[i]))
            size[count++] = r[i];
    double sigma = 1.4826 * median_of(size, count);
    for (size_t i = 0; i < n && sigma > 0; i++)
        if (r[i] > limit * sigma) {
            z[i] = NAN;
            marked++;
        }
    return marked;
}

size_t ovr_mark_outliers(size_t n, double *z, double limit, double *work)
{
    for (size_t i = 0; i < n; i++)
        work[i] = fabs(z[i] - median_about(n, z, i));
    return mark(n, z, work, limit, work + n);
}

size_t ovr_mark_map_outliers(size_t nx, size_t ny, double *z, double limit,
                             double *work)
{
    for (size_t j = 0; j < ny; j++)
        for (size_t i = 0; i < nx; i++)
            work[j * nx + i] = fabs(z[j * nx + i] -
                                    median_in_map(nx, ny, z, i, j));
    return mark(nx * ny, z, work, limit, work + nx * ny);
}

/* The gap after point i (which has a height): index of the next height. */
static size_t next_height(size_t n, const double *z, size_t i)
{
    do
        i++;
    while (i < n && isnan(z[i]));
    return i;
}

void ovr_longest_gap(size_t n, const double *x, const double *z, double *length,
                     double *where)
{
    *length = 0;
    *where = x[0];
    for (size_t i = 0, j; i < n; i = j) {
        j = next_height(n, z, i);
        if (j < n && j > i + 1 && x[j] - x[i] > *length) {
            *length = x[j] - x[i];
            *where = x[i];
        }
    }
}

size_t ovr_fill_gaps(size_t n, const double *x, double *z)
{
    size_t filled = 0;
    for (size_t i = 0, j; i < n; i = j) {
        j = next_height(n, z, i);
        for (size_t k = i + 1; j < n && k < j; k++, filled++)
            z[k] = z[i] + (z[j] - z[i]) * (x[k] - x[i]) / (x[j] - x[i]);
    }
    return filled;
}
