/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Conditioning of areal surfaces.
 *
 * Missing heights become the mean of their known neighbours, from the rim of a
 * gap inwards, smoothed by 100 Jacobi sweeps of the Laplace equation.  Outliers
 * (conditioning.c) are replaced in the same way.
 *
 * F-operation (ISO 25178-2): least-squares polynomial of total degree n in
 * products of Legendre polynomials, by normal equations (Cholesky).  Maps of
 * more than 2^18 points are fitted on every k-th row and column.
 *
 * S- and L-filter: the Gaussian areal filter of nesting index lambda, ISO
 * 16610-61, exp(-pi (r/(alpha lambda))^2) with alpha = sqrt(ln 2/pi), whose
 * transmission is one half at the wavelength lambda.  The weight is a product
 * of functions of x and y, so rows and columns are filtered in turn.  Near the
 * ends the filter is a regression of first order, as for profiles (filter.c).
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/areal.h"
#include "surface/areal.h"
#include "surface/conditioning.h"

enum { DEGREE_MAX = 8, TERMS_MAX = (DEGREE_MAX + 1) * (DEGREE_MAX + 2) / 2 };

static ovr_profile *owner_of(const ovr_areal *a)
{
    return a->owner;
}

/* ----------------------------------------------------------------- points */

static ovr_status check(const ovr_areal *a, const ovr_conditioning *how,
                        ovr_error *err)
{
    const ovr_profile *p = owner_of(a);
    const struct {
        const char *key;
        bool right;
        const char *must;
    } rules[] = {
        {"scale", isfinite(how->scale), "be a finite number"},
        {"offset", isfinite(how->offset), "be a finite height"},
        {"stretch", how->stretch > 0 && !isinf(how->stretch), "be positive"},
        {"outliers", !(how->outliers <= 0 || isinf(how->outliers)),
         "be positive"},
        {"max_missing", how->max_missing >= 0 && how->max_missing <= 1,
         "be 0 to 1"},
        {"lambda_c", !(how->lambda_c <= 0 || isinf(how->lambda_c)),
         "be positive"},
        {"lambda_s", !(how->lambda_s <= 0 || isinf(how->lambda_s)),
         "be positive"},
        {"lambda_c", !(how->lambda_c <= how->lambda_s),
         "be longer than lambda_s"},
        {"level", (int)how->level >= 0 && how->level <= OVR_LEVEL_POLYNOMIAL,
         "be none, mean, plane or polynomial for an areal surface"},
        {"degree", how->degree >= 0 && how->degree <= DEGREE_MAX,
         "be 0 to 8 for an areal surface"}};
    for (size_t k = 0; k < sizeof rules / sizeof *rules; k++)
        if (!rules[k].right)
            return ovr_about(
                err, rules[k].key,
                ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0, "%s must %s",
                            ovr_named(p, rules[k].key).text, rules[k].must));
    return OVR_OK;
}

static ovr_status turn(ovr_areal *a, ovr_error *err)
{
    ovr_profile *p = owner_of(a);
    ovr_arena work = ovr_arena_make(&p->arena.allocator);
    double *z = ovr_arena_take(&work, a->nx * a->ny, sizeof *z, err), d = a->dx;
    size_t n = a->nx;
    if (!z)
        return OVR_NO_MEMORY;
    for (size_t j = 0; j < a->ny; j++)
        for (size_t i = 0; i < a->nx; i++)
            z[i * a->ny + j] = a->z[j * a->nx + i];
    memcpy(a->z, z, a->nx * a->ny * sizeof *z);
    ovr_arena_release(&work);
    a->nx = a->ny, a->ny = n;
    a->dx = a->dy, a->dy = d;
    ovr_profile_note(p, "turned: its y runs along rolling");
    return OVR_OK;
}

/* Finds the points with from <= k d <= to. */
static void window(double from, double to, double d, size_t *first, size_t *n)
{
    size_t last = *n - 1;
    double low = isnan(from) ? 0 : ceil(from / d - 1e-9);
    double high = isnan(to) ? (double)last : floor(to / d + 1e-9);
    *first = (size_t)fmin(fmax(low, 0), (double)last);
    last = (size_t)fmin(fmax(high, 0), (double)last);
    *n = last >= *first ? last - *first + 1 : 0;
}

static ovr_status choose_window(ovr_areal *a, const ovr_conditioning *how,
                                ovr_error *err)
{
    ovr_profile *p = owner_of(a);
    size_t i, j, nx = a->nx, ny = a->ny;
    window(how->from, how->to, a->dx, &i, &nx);
    window(how->from_across, how->to_across, a->dy, &j, &ny);
    if (nx < 4 || ny < 4) {
        bool along = nx < 4;
        const char *key = along ? "to" : "to_across";
        double d = along ? a->dx : a->dy;
        size_t n = along ? a->nx : a->ny;
        return ovr_about(
            err, key,
            ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                        "the window of the map contains %zu points "
                        "%s; at least 4 are needed (the map is %s "
                        "%s)",
                        along ? nx : ny, along ? "along x" : "across",
                        ovr_along(p, d * (double)(n - 1)).text,
                        along ? "long" : "wide"));
    }
    if (nx < a->nx || ny < a->ny)
        ovr_profile_note(p, "window: %zu x %zu of %zu x %zu points", nx, ny,
                         a->nx, a->ny);
    for (size_t k = 0; k < ny; k++)
        memmove(a->z + k * nx, a->z + (j + k) * a->nx + i, nx * sizeof *a->z);
    a->nx = nx;
    a->ny = ny;
    return OVR_OK;
}

static void change_scales(ovr_areal *a, const ovr_conditioning *how)
{
    ovr_profile *p = owner_of(a);
    double by = how->invert ? -how->scale : how->scale;
    for (size_t k = 0; k < a->nx * a->ny; k++)
        a->z[k] *= by;
    a->dx *= how->stretch;
    a->dy *= how->stretch;
    for (size_t j = 0; how->reverse && j < a->ny; j++)
        for (size_t i = 0, k = a->nx - 1; i < k; i++, k--) {
            double *row = a->z + j * a->nx, z = row[i];
            row[i] = row[k];
            row[k] = z;
        }
    if (by != 1)
        ovr_profile_note(p, "heights times %g", by);
    if (how->stretch != 1)
        ovr_profile_note(p, "lengths times %g", how->stretch);
    if (how->reverse)
        ovr_profile_note(p, "reversed in x");
}

/* ---------------------------------------------------------------- missing */

/* Sums the four neighbours that have heights; returns their number. */
static int neighbours(const ovr_areal *a, size_t i, size_t j, double *sum)
{
    const double *z = a->z + j * a->nx + i;
    const double near[] = {i > 0 ? z[-1] : NAN, i + 1 < a->nx ? z[1] : NAN,
                           j > 0 ? *(z - a->nx) : NAN,
                           j + 1 < a->ny ? z[a->nx] : NAN};
    int count = 0;
    *sum = 0;
    for (int k = 0; k < 4; k++)
        if (!isnan(near[k])) {
            *sum += near[k];
            count++;
        }
    return count;
}

/* Sets each missing height to the mean of its known neighbours. */
static void sweep(ovr_areal *a, const size_t *gap, size_t count, double *value)
{
    for (size_t k = 0; k < count; k++) {
        double sum;
        int n = neighbours(a, gap[k] % a->nx, gap[k] / a->nx, &sum);
        value[k] = n ? sum / n : NAN;
    }
    for (size_t k = 0; k < count; k++)
        a->z[gap[k]] = value[k];
}

static ovr_status fill_gaps(ovr_areal *a, const ovr_conditioning *how,
                            ovr_error *err)
{
    enum { SMOOTHING = 100 };
    ovr_profile *p = owner_of(a);
    size_t all = a->nx * a->ny, count = 0, left;
    for (size_t k = 0; k < all; k++)
        count += isnan(a->z[k]) ? 1 : 0;
    if (!count)
        return OVR_OK;
    if ((double)count > how->max_missing * (double)all || count == all)
        return ovr_about(err, "max_missing",
                         ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                     "%zu of %zu heights are missing, more "
                                     "than %s = %g",
                                     count, all,
                                     ovr_named(p, "max_missing").text,
                                     how->max_missing));
    ovr_arena work = ovr_arena_make(&p->arena.allocator);
    size_t *gap = ovr_arena_take(&work, count, sizeof *gap, err);
    double *value = ovr_arena_take(&work, count, sizeof *value, err);
    if (!gap || !value) {
        ovr_arena_release(&work);
        return OVR_NO_MEMORY;
    }
    count = 0;
    for (size_t k = 0; k < all; k++)
        if (isnan(a->z[k]))
            gap[count++] = k;
    do {
        sweep(a, gap, count, value);
        left = 0;
        for (size_t k = 0; k < count; k++)
            left += isnan(value[k]) ? 1 : 0;
    } while (left);
    for (int k = 0; k < SMOOTHING; k++)
        sweep(a, gap, count, value);
    ovr_arena_release(&work);
    a->missing = 0;
    ovr_profile_note(p, "%zu missing heights filled from their neighbours",
                     count);
    return OVR_OK;
}

static ovr_status drop_outliers(ovr_areal *a, const ovr_conditioning *how,
                                ovr_error *err)
{
    ovr_profile *p = owner_of(a);
    if (isnan(how->outliers))
        return OVR_OK;
    ovr_arena arena = ovr_arena_make(&p->arena.allocator);
    double *work = ovr_arena_take(&arena, 2 * a->nx * a->ny, sizeof *work, err);
    if (!work)
        return OVR_NO_MEMORY;
    size_t marked = ovr_mark_map_outliers(a->nx, a->ny, a->z, how->outliers,
                                          work);
    ovr_arena_release(&arena);
    ovr_profile_note(p, "%zu outliers beyond %g robust standard deviations",
                     marked, how->outliers);
    return fill_gaps(a, how, err);
}

/* -------------------------------------------------------------------- form */

/* Evaluates the Legendre polynomials up to `degree` at t in [-1, 1]. */
static void legendre(double t, int degree, double *P)
{
    P[0] = 1;
    P[1] = t;
    for (int k = 2; k <= degree; k++)
        P[k] = ((2 * k - 1) * t * P[k - 1] - (k - 1) * P[k - 2]) / k;
}

/* Evaluates the terms of the form at point (i, j); returns their number. */
static int terms_at(const ovr_areal *a, size_t i, size_t j, int degree,
                    double *term)
{
    double X[DEGREE_MAX + 2], Y[DEGREE_MAX + 2];
    int count = 0;
    legendre(2 * (double)i / (double)(a->nx - 1) - 1, degree, X);
    legendre(2 * (double)j / (double)(a->ny - 1) - 1, degree, Y);
    for (int k = 0; k <= degree; k++)
        for (int m = 0; m + k <= degree; m++)
            term[count++] = X[k] * Y[m];
    return count;
}

/* Solves the n normal equations in place by Cholesky decomposition; false if
 * they are singular. */
static bool solve(double *matrix, double *right, int n)
{
    for (int k = 0; k < n; k++) {
        double *row = matrix + k * n;
        for (int m = 0; m <= k; m++) {
            const double *other = matrix + m * n;
            double sum = row[m];
            for (int i = 0; i < m; i++)
                sum -= row[i] * other[i];
            if (m == k && !(sum > 1e-12 * row[k]))
                return false;
            row[m] = m == k ? sqrt(sum) : sum / other[m];
        }
    }
    for (int k = 0; k < n; k++) {
        for (int m = 0; m < k; m++)
            right[k] -= matrix[k * n + m] * right[m];
        right[k] /= matrix[k * n + k];
    }
    for (int k = n; k-- > 0;) {
        for (int m = k + 1; m < n; m++)
            right[k] -= matrix[m * n + k] * right[m];
        right[k] /= matrix[k * n + k];
    }
    return true;
}

static void remove_form(ovr_areal *a, int degree)
{
    enum { FITTED = 1 << 18 };
    double term[TERMS_MAX], matrix[TERMS_MAX * TERMS_MAX] = {0};
    double right[TERMS_MAX] = {0};
    size_t step = 1;
    int n = 0;
    while (a->nx / step * (a->ny / step) > FITTED)
        step++;
    for (size_t j = 0; j < a->ny; j += step)
        for (size_t i = 0; i < a->nx; i += step) {
            n = terms_at(a, i, j, degree, term);
            for (int k = 0; k < n; k++) {
                right[k] += term[k] * a->z[j * a->nx + i];
                for (int m = 0; m < n; m++)
                    matrix[k * n + m] += term[k] * term[m];
            }
        }
    if (!solve(matrix, right, n))
        return;
    for (size_t j = 0; j < a->ny; j++)
        for (size_t i = 0; i < a->nx; i++) {
            terms_at(a, i, j, degree, term);
            for (int k = 0; k < n; k++)
                a->z[j * a->nx + i] -= right[k] * term[k];
        }
}

static void level(ovr_areal *a, const ovr_conditioning *how)
{
    ovr_profile *p = owner_of(a);
    int degree = how->level == OVR_LEVEL_MEAN   ? 0
                 : how->level == OVR_LEVEL_LINE ? 1
                                                : how->degree;
    if (how->level == OVR_LEVEL_NONE)
        return;
    remove_form(a, degree);
    if (degree < 2)
        ovr_profile_note(p, "F-operation: %s removed",
                         degree ? "least-squares plane" : "mean height");
    else
        ovr_profile_note(p, "F-operation: polynomial of degree %d removed",
                         degree);
}

/* ------------------------------------------------------------------ filters */

/* Applies the Gaussian filter to `count` lines of n heights. */
static void smooth_lines(double *z, size_t count, size_t n, double d,
                         size_t between, size_t apart, double lambda,
                         double *work)
{
    double *x = work, *line = work + n, *mean = line + n, *rest = mean + n;
    double *kernel = rest + 2 * n, sum = 0;
    size_t reach = (size_t)floor(lambda / d);
    for (size_t i = 0; i < n; i++)
        x[i] = (double)i * d;
    for (size_t k = 0; k <= reach && k < n; k++) {
        double u = (double)k * d / lambda;
        kernel[k] = exp(-14.238829324987503738 * u * u);
        sum += (k ? 2 : 1) * kernel[k];
    }
    for (size_t j = 0; j < count; j++) {
        double *of = z + j * between;
        for (size_t i = 0; i < n; i++)
            line[i] = of[i * apart];
        /* Points near the ends are filtered with local regression. */
        size_t edge = 2 * reach + 1 < n ? 2 * reach + 1 : n;
        const ovr_points first = {edge, x, line};
        ovr_gaussian(&first, lambda, true, mean, rest);
        for (size_t i = 0; i < edge && (i < reach || edge == n); i++)
            of[i * apart] = mean[i];
        if (edge == n)
            continue;
        const ovr_points last = {edge, x, line + n - edge};
        ovr_gaussian(&last, lambda, true, mean, rest);
        for (size_t i = reach + 1; i < edge; i++)
            of[(n - edge + i) * apart] = mean[i];
        for (size_t i = reach; i + reach < n; i++) {
            double value = kernel[0] * line[i];
            for (size_t k = 1; k <= reach; k++)
                value += kernel[k] * (line[i - k] + line[i + k]);
            of[i * apart] = value / sum;
        }
    }
}

static ovr_status smooth(const ovr_areal *a, double *z, double lambda,
                         ovr_error *err)
{
    ovr_profile *p = owner_of(a);
    ovr_arena arena = ovr_arena_make(&p->arena.allocator);
    size_t most = a->nx > a->ny ? a->nx : a->ny;
    double *work = ovr_arena_take(&arena, 6 * most, sizeof *work, err);
    if (!work)
        return OVR_NO_MEMORY;
    smooth_lines(z, a->ny, a->nx, a->dx, a->nx, 1, lambda, work);
    smooth_lines(z, a->nx, a->ny, a->dy, 1, a->nx, lambda, work);
    ovr_arena_release(&arena);
    return OVR_OK;
}

static ovr_status filter(ovr_areal *a, const ovr_conditioning *how,
                         ovr_error *err)
{
    ovr_profile *p = owner_of(a);
    size_t all = a->nx * a->ny;
    ovr_status status = OVR_OK;
    if (!isnan(how->lambda_c)) {
        ovr_arena work = ovr_arena_make(&p->arena.allocator);
        double *mean = ovr_arena_take(&work, all, sizeof *mean, err);
        if (!mean)
            return OVR_NO_MEMORY;
        memcpy(mean, a->z, all * sizeof *mean);
        status = smooth(a, mean, how->lambda_c, err);
        for (size_t k = 0; k < all; k++)
            a->z[k] -= mean[k];
        ovr_arena_release(&work);
        ovr_profile_note(p, "L-filter: Gaussian, nesting index %s",
                         ovr_along(p, how->lambda_c).text);
    }
    if (status || isnan(how->lambda_s))
        return status;
    ovr_profile_note(p, "S-filter: Gaussian, nesting index %s",
                     ovr_along(p, how->lambda_s).text);
    return smooth(a, a->z, how->lambda_s, err);
}

ovr_status ovr_areal_condition(ovr_areal *a, const ovr_conditioning *given,
                               ovr_error *err)
{
    ovr_conditioning own, *how = &own;
    if (!a || !a->owner || !a->z)
        return ovr_fail_null(err, __func__);
    ovr_status status = OVR_TAKE(ovr_conditioning, how, given, err);
    if (!status)
        status = check(a, how, err);
    if (!status && how->turn)
        status = turn(a, err);
    if (!status)
        status = choose_window(a, how, err);
    if (status)
        return status;
    change_scales(a, how);
    status = fill_gaps(a, how, err);
    if (!status)
        status = drop_outliers(a, how, err);
    if (status)
        return status;
    level(a, how);
    status = filter(a, how, err);
    for (size_t k = 0; k < a->nx * a->ny; k++)
        a->z[k] += how->offset;
    a->notes = owner_of(a)->notes;
    return status;
}
