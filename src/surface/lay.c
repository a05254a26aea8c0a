/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Parameters of an areal surface: Sa, Sq, Ssk, Sku, texture aspect ratio Str
 * and the direction of the lay (ISO 25178-2).
 *
 * z is measured from its least-squares plane. The autocorrelation
 *
 *     A(s) = (sum of z(r) z(r + s) over pairs) / (number of pairs) / Sq^2
 *
 * is computed by FFT of the heights, padded with zeros. The number of pairs is
 * (nx - |i|)(ny - |j|) at a shift by i, j points, or the autocorrelation of the
 * mask of existing heights if some are missing. Grids of more than 256 points a
 * side are averaged over blocks first. r(t) is the distance in the direction t
 * at which A falls below 0.2, at most R, half the shorter side. Str = min r /
 * max r. The lay is the direction with the largest integral of A from 0 to R.
 * For parallel grooves its error is about half a degree.
 */
#include <gsl/gsl_fft_complex.h>
#include <math.h>
#include <stdlib.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/areal.h"
#include "surface/areal.h"

static const double pi = 3.14159265358979323846;

enum { SIDE = 256, DIRECTIONS = 360 };

/* -------------------------------------------------------- plane, Sa and Sq */

typedef struct plane {
    double z0, zx, zy; /* z0 + zx i + zy j */
} plane;

/* Fits a plane by least squares, with normal equations about the means of i and
 * j. */
static plane fit_plane(const ovr_areal *a)
{
    double n = 0, mi = 0, mj = 0, mz = 0;
    double ii = 0, ij = 0, jj = 0, iz = 0, jz = 0, det;
    plane p = {0};
    for (size_t j = 0; j < a->ny; j++)
        for (size_t i = 0; i < a->nx; i++) {
            double z = a->z[j * a->nx + i];
            if (!isnan(z))
                n++, mi += (double)i, mj += (double)j, mz += z;
        }
    mi /= n, mj /= n, mz /= n;
    for (size_t j = 0; j < a->ny; j++)
        for (size_t i = 0; i < a->nx; i++) {
            double z = a->z[j * a->nx + i] - mz;
            double u = (double)i - mi, v = (double)j - mj;
            if (!isnan(z))
                ii += u * u, ij += u * v, jj += v * v, iz += u * z, jz += v * z;
        }
    det = ii * jj - ij * ij;
    if (det > 1e-12 * ii * jj) {
        p.zx = (iz * jj - jz * ij) / det;
        p.zy = (jz * ii - iz * ij) / det;
    } else if (ii > 0) {
        p.zx = iz / ii;
    }
    p.z0 = mz - p.zx * mi - p.zy * mj;
    return p;
}

void ovr_areal_plane(const ovr_areal *areal, double to[3])
{
    plane p = fit_plane(areal);
    to[0] = p.z0;
    to[1] = p.zx;
    to[2] = p.zy;
}

static double about_plane(const ovr_areal *a, const plane *p, size_t i,
                          size_t j)
{
    return a->z[j * a->nx + i] - p->z0 - p->zx * (double)i - p->zy * (double)j;
}

static void measure_heights(const ovr_areal *a, const plane *p,
                            ovr_areal_numbers *numbers)
{
    double sum = 0, squares = 0, n = 0, third = 0, fourth = 0;
    for (size_t j = 0; j < a->ny; j++)
        for (size_t i = 0; i < a->nx; i++) {
            double z = about_plane(a, p, i, j);
            if (!isnan(z))
                n++, sum += fabs(z), squares += z * z;
        }
    numbers->Sa = sum / n;
    numbers->Sq = sqrt(squares / n);
    for (size_t j = 0; j < a->ny && numbers->Sq > 0; j++)
        for (size_t i = 0; i < a->nx; i++) {
            double v = about_plane(a, p, i, j) / numbers->Sq;
            if (!isnan(v))
                third += v * v * v, fourth += v * v * v * v;
        }
    numbers->Ssk = numbers->Sq > 0 ? third / n : NAN;
    numbers->Sku = numbers->Sq > 0 ? fourth / n : NAN;
}

/* ---------------------------------------------------------- autocorrelation */

typedef struct correlation {
    size_t nx, ny; /* after averaging */
    size_t cx, cy; /* padded to powers of two */
    double dx, dy;
    double *heights; /* complex, cx cy elements: first of the heights, then of
                      * the products */
    double *mask;    /* as `heights`, for the mask; NULL: no height is
                      * missing */
    double zero;     /* value at zero shift */
} correlation;

/* Shifts are at most half the shorter side and the next point. */
static size_t largest_shift(size_t n)
{
    return n / 2 + 2;
}

static size_t padded(size_t n)
{
    size_t power = 2;
    while (power < n + largest_shift(n))
        power *= 2;
    return power;
}

/* Averages over blocks of bx by by points; blocks without heights get height 0
 * and mask 0. Returns the number of blocks with heights. */
static size_t fill(correlation *c, const ovr_areal *a, const plane *p,
                   size_t bx, size_t by)
{
    size_t filled = 0;
    for (size_t j = 0; j < c->ny; j++)
        for (size_t i = 0; i < c->nx; i++) {
            double sum = 0, n = 0;
            for (size_t v = j * by; v < (j + 1) * by && v < a->ny; v++)
                for (size_t u = i * bx; u < (i + 1) * bx && u < a->nx; u++) {
                    double z = about_plane(a, p, u, v);
                    if (!isnan(z))
                        n++, sum += z;
                }
            if (n > 0) {
                c->heights[2 * (j * c->cx + i)] = sum / n;
                c->mask[2 * (j * c->cx + i)] = 1;
                filled++;
            }
        }
    return filled;
}

/* Transforms the first `rows` rows, before or after all columns. */
static void transform_rows(double *data, size_t cx, size_t rows, bool back)
{
    for (size_t j = 0; j < rows; j++)
        if (back)
            gsl_fft_complex_radix2_backward(data + 2 * j * cx, 1, cx);
        else
            gsl_fft_complex_radix2_forward(data + 2 * j * cx, 1, cx);
}

static void transform_columns(double *data, size_t cx, size_t cy, bool back)
{
    for (size_t i = 0; i < cx; i++)
        if (back)
            gsl_fft_complex_radix2_backward(data + 2 * i, cx, cy);
        else
            gsl_fft_complex_radix2_forward(data + 2 * i, cx, cy);
}

/* Computes the sums of products, in the real parts, at all shifts that find_lay
 * needs: none is towards smaller y. Rows from ny on are zero. */
static void correlate(const correlation *c, double *data)
{
    size_t cx = c->cx, cy = c->cy;
    transform_rows(data, cx, c->ny, false);
    transform_columns(data, cx, cy, false);
    for (size_t k = 0; k < cx * cy; k++) {
        data[2 * k] = data[2 * k] * data[2 * k] +
                      data[2 * k + 1] * data[2 * k + 1];
        data[2 * k + 1] = 0;
    }
    transform_columns(data, cx, cy, true);
    transform_rows(data, cx, largest_shift(c->ny), true);
}

/* Returns the mean product at an integer shift; j is not negative. */
static double at_points(const correlation *c, long i, long j)
{
    size_t u = (size_t)(i < 0 ? i + (long)c->cx : i);
    size_t k = 2 * ((size_t)j * c->cx + u);
    double all = (double)(c->cx * c->cy);
    double pairs = (double)((long)c->nx - labs(i)) * (double)((long)c->ny - j);
    if (c->mask)
        pairs = c->mask[k] / all;
    return pairs > 0.5 ? c->heights[k] / (all * pairs) : 0;
}

static double at_shift(const correlation *c, double x, double y)
{
    double i = floor(x / c->dx), j = floor(y / c->dy);
    double u = x / c->dx - i, v = y / c->dy - j;
    long k = (long)i, m = (long)j;
    return ((1 - u) *
                ((1 - v) * at_points(c, k, m) + v * at_points(c, k, m + 1)) +
            u * ((1 - v) * at_points(c, k + 1, m) +
                 v * at_points(c, k + 1, m + 1))) /
           c->zero;
}

/* ----------------------------------------------------------------- lay, Str */

/* Integrates the autocorrelation A along one direction up to R, and finds where
 * A falls below 0.2. */
static double follow(const correlation *c, double angle, double R, double *r)
{
    double step = fmin(c->dx, c->dy) / 2, integral = 0, before = 1;
    *r = R;
    for (double s = step; s <= R * (1 + 1e-12); s += step) {
        double now = at_shift(c, s * cos(angle), s * sin(angle));
        integral += (before + now) / 2 * step;
        if (now < 0.2 && *r == R)
            *r = s - step * (0.2 - now) / fmax(before - now, 1e-300);
        before = now;
    }
    return integral;
}

static void find_lay(const correlation *c, ovr_areal_numbers *numbers)
{
    double R = fmin(c->dx * (double)c->nx, c->dy * (double)c->ny) / 2;
    double shortest = INFINITY, longest = 0, integral[DIRECTIONS], a, b, d;
    size_t best = 0;
    for (size_t k = 0; k < DIRECTIONS; k++) {
        double r;
        integral[k] = follow(c, pi * (double)k / DIRECTIONS, R, &r);
        shortest = fmin(shortest, r);
        longest = fmax(longest, r);
        best = integral[k] > integral[best] ? k : best;
    }
    numbers->Str = shortest / longest;
    numbers->Str_is_bound = longest >= R && shortest < R;
    if (!(numbers->Str <= 0.5))
        return;
    a = integral[(best + DIRECTIONS - 1) % DIRECTIONS];
    b = integral[best];
    d = integral[(best + 1) % DIRECTIONS];
    numbers->lay = (double)best;
    if (a + d < 2 * b)
        numbers->lay += (a - d) / (a - 2 * b + d) / 2;
    numbers->lay *= 180.0 / DIRECTIONS;
    if (numbers->lay > 90)
        numbers->lay -= 180;
}

/* Returns the points of a block along one side. */
static size_t block(size_t n)
{
    return (n + SIDE - 1) / SIDE;
}

static correlation correlation_of(const ovr_areal *a)
{
    size_t bx = block(a->nx), by = block(a->ny);
    correlation c = {.nx = (a->nx + bx - 1) / bx,
                     .ny = (a->ny + by - 1) / by,
                     .dx = a->dx * (double)bx,
                     .dy = a->dy * (double)by};
    c.cx = padded(c.nx);
    c.cy = padded(c.ny);
    return c;
}

double ovr_areal_measure_work(const ovr_areal *a)
{
    const double height = 12, butterfly = 5, shift = 20; /* multiplications */
    correlation c = correlation_of(a);
    double n = (double)(c.cx * c.cy),
           side = (double)(c.nx < c.ny ? c.nx : c.ny);
    return height * (double)(a->nx * a->ny) + butterfly * n * log2(n) +
           shift * DIRECTIONS * side;
}

static ovr_status measure_lay(const ovr_areal *a, const plane *p,
                              ovr_areal_numbers *numbers, ovr_arena *arena,
                              ovr_error *err)
{
    correlation c = correlation_of(a);
    size_t size = 2 * c.cx * c.cy;
    c.heights = ovr_arena_take(arena, size, sizeof *c.heights, err);
    c.mask = ovr_arena_take(arena, size, sizeof *c.mask, err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    if (fill(&c, a, p, block(a->nx), block(a->ny)) == c.nx * c.ny)
        c.mask = NULL;
    correlate(&c, c.heights);
    if (c.mask)
        correlate(&c, c.mask);
    c.zero = at_points(&c, 0, 0);
    if (c.zero > 0)
        find_lay(&c, numbers);
    return OVR_OK;
}

ovr_status ovr_areal_measure(const ovr_areal *areal, ovr_areal_numbers *numbers,
                             ovr_error *err)
{
    ovr_arena arena;
    ovr_status status = OVR_OK;
    plane p;
    if (!areal || !numbers)
        return ovr_fail_null(err, __func__);
    if (!areal->z || areal->missing >= areal->nx * areal->ny)
        return ovr_fail(err, OVR_BAD_INPUT, "an areal surface without heights");
    *numbers = (ovr_areal_numbers){.Str = NAN, .lay = NAN};
    p = fit_plane(areal);
    measure_heights(areal, &p, numbers);
    if (areal->nx < 8 || areal->ny < 8 ||
        !(numbers->Sq > 1e-12 * (fabs(p.z0) + numbers->Sa)))
        return OVR_OK;
    arena = ovr_arena_make(NULL);
    status = measure_lay(areal, &p, numbers, &arena, err);
    ovr_arena_release(&arena);
    return status;
}
