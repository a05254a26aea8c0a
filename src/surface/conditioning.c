/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conditions a profile in the order given in profile.h; each step adds a
 * note. */
#include "surface/conditioning.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "surface/form.h"
#include "surface/profile.h"

/* --------------------------------------------- missing heights and outliers */

/*
 * Missing heights and outliers. Outliers are detected by Hampel's test:
 *
 *     r_i = z_i - median of its 11 neighbours; |r_i| > limit sigma
 *
 * sigma = 1.4826 median |r| is the standard deviation of Gaussian heights and
 * is insensitive to outliers. The neighbours in a map are 5 x 5 points.
 */

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

/* Sets heights to NAN whose distance r from the median is too large. */
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

/* Sets to NAN the heights further than `limit` robust standard deviations from
 * the median of their 11 neighbours; returns their number. `work` has 2 n
 * elements. */
static size_t mark_outliers(size_t n, double *z, double limit, double *work)
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

/* Returns the index of the next height after point i. */
static size_t next_height(size_t n, const double *z, size_t i)
{
    do
        i++;
    while (i < n && isnan(z[i]));
    return i;
}

static void longest_gap(size_t n, const double *x, const double *z,
                        double *length, double *where)
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

/* Interpolates missing heights linearly. Stores the length of the longest gap
 * and the x at which it begins. */
static size_t fill_gaps(size_t n, const double *x, double *z)
{
    size_t filled = 0;
    for (size_t i = 0, j; i < n; i = j) {
        j = next_height(n, z, i);
        for (size_t k = i + 1; j < n && k < j; k++, filled++)
            z[k] = z[i] + (z[j] - z[i]) * (x[k] - x[i]) / (x[j] - x[i]);
    }
    return filled;
}

static ovr_status wrong(const ovr_profile *p, ovr_error *err, const char *key,
                        const char *value, const char *right)
{
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%s = %s must be %s", ovr_named(p, key).text,
                                 value, right));
}

static ovr_piece plain(double value)
{
    ovr_piece piece;
    snprintf(piece.text, sizeof piece.text, "%g", value);
    return piece;
}

static ovr_status check_lengths(const ovr_profile *p,
                                const ovr_conditioning *how, ovr_error *err)
{
    const struct {
        const char *key;
        double value;
    } lengths[] = {{"max_gap", how->max_gap},
                   {"lambda_c", how->lambda_c},
                   {"lambda_s", how->lambda_s}};
    for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; k++)
        if (lengths[k].value <= 0 || isinf(lengths[k].value))
            return wrong(p, err, lengths[k].key,
                         ovr_along(p, lengths[k].value).text, "positive");
    if (how->lambda_c <= how->lambda_s)
        return ovr_about(err, "lambda_c",
                         ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                     "%s = %s must be longer than %s = %s",
                                     ovr_named(p, "lambda_c").text,
                                     ovr_along(p, how->lambda_c).text,
                                     ovr_named(p, "lambda_s").text,
                                     ovr_along(p, how->lambda_s).text));
    return OVR_OK;
}

static ovr_status check(const ovr_profile *p, const ovr_conditioning *how,
                        ovr_error *err)
{
    const struct {
        const char *key;
        bool right;
        double value;
        const char *target;
    } rules[] = {
        {"outliers", !(how->outliers <= 0 || isinf(how->outliers)),
         how->outliers, "positive"},
        {"scale", isfinite(how->scale), how->scale, "a finite number"},
        {"offset", isfinite(how->offset), how->offset, "a finite height"},
        {"stretch", how->stretch > 0 && !isinf(how->stretch), how->stretch,
         "positive"},
        {"max_missing", how->max_missing >= 0 && how->max_missing <= 1,
         how->max_missing, "from 0 to 1"},
        {"level", (int)how->level >= 0 && how->level <= OVR_LEVEL_AUTO,
         how->level, "one of its names"},
        {"degree", how->degree >= 0 && how->degree <= 12, how->degree,
         "from 0 to 12"}};
    for (size_t k = 0; k < sizeof rules / sizeof rules[0]; k++)
        if (!rules[k].right)
            return wrong(p, err, rules[k].key, plain(rules[k].value).text,
                         rules[k].target);
    return check_lengths(p, how, err);
}

/* ------------------------------------------------------------ the points */

static void keep(ovr_profile *p, size_t from, size_t n)
{
    memmove(p->x, p->x + from, n * sizeof(double));
    memmove(p->z, p->z + from, n * sizeof(double));
}

static ovr_status choose_window(ovr_profile *p, const ovr_conditioning *how,
                                size_t *n, ovr_error *err)
{
    size_t first = 0, last = *n;
    while (first < *n && p->x[first] < how->from)
        first++;
    while (last > first && p->x[last - 1] > how->to)
        last--;
    if (last - first < 2)
        return ovr_about(
            err, isnan(how->from) ? "to" : "from",
            ovr_fail_at(
                err, OVR_BAD_INPUT, p->file, 0,
                "the window from %s to %s contains %zu point%s; the profile "
                "extends from %s to %s",
                isnan(how->from) ? "its begin" : ovr_along(p, how->from).text,
                isnan(how->to) ? "its end" : ovr_along(p, how->to).text,
                last - first, last - first == 1 ? "" : "s",
                ovr_along(p, p->x[0]).text, ovr_along(p, p->x[*n - 1]).text));
    if (last - first < *n)
        ovr_profile_note(p, "window: %zu of %zu points", last - first, *n);
    keep(p, first, last - first);
    *n = last - first;
    return OVR_OK;
}

static void turn(ovr_profile *p, size_t n)
{
    for (size_t i = 0, j = n - 1; i < j; i++, j--) {
        double x = p->x[i], z = p->z[i];
        p->x[i] = p->x[j], p->z[i] = p->z[j];
        p->x[j] = x, p->z[j] = z;
    }
    for (size_t i = 0; i < n; i++)
        p->x[i] = -p->x[i];
    ovr_profile_note(p, "reversed in x");
}

static void change_scales(ovr_profile *p, const ovr_conditioning *how, size_t n)
{
    double by = how->invert ? -how->scale : how->scale;
    for (size_t i = 0; i < n; i++) {
        p->x[i] *= how->stretch;
        p->z[i] *= by;
    }
    if (how->reverse)
        turn(p, n);
    if (by != 1)
        ovr_profile_note(p, "heights times %g", by);
    if (how->stretch != 1)
        ovr_profile_note(p, "lengths times %g", how->stretch);
}

/* ---------------------------------------------------------------- gaps */

static size_t count_missing(size_t n, const double *z)
{
    size_t missing = 0;
    for (size_t i = 0; i < n; i++)
        missing += isnan(z[i]) ? 1 : 0;
    return missing;
}

/* Missing heights at the ends are removed, others are interpolated. */
/* Removes points without heights at both ends. */
static ovr_status cut_ends(ovr_profile *p, size_t *n, ovr_error *err)
{
    size_t first = 0, last = *n;
    while (first < last && isnan(p->z[first]))
        first++;
    while (last > first && isnan(p->z[last - 1]))
        last--;
    if (last - first < 2)
        return ovr_fail_at(
            err, OVR_BAD_INPUT, p->file, 0,
            "fewer than two heights remain after conditioning; remove fewer "
            "points");
    keep(p, first, last - first);
    if (last - first < *n)
        ovr_profile_note(p, "%zu points without height removed at the ends",
                         *n - (last - first));
    *n = last - first;
    return OVR_OK;
}

static ovr_status close_gaps(ovr_profile *p, const ovr_conditioning *how,
                             size_t *n, ovr_error *err)
{
    size_t missing = count_missing(*n, p->z), filled;
    double length, where, maximum = how->max_gap;
    if (!missing)
        return OVR_OK;
    if ((double)missing > how->max_missing * (double)*n)
        return ovr_about(
            err, "max_missing",
            ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                        "%zu of %zu heights are missing, more than %s = %g",
                        missing, *n, ovr_named(p, "max_missing").text,
                        how->max_missing));
    if (cut_ends(p, n, err))
        return OVR_BAD_INPUT;
    /* The length that n points represent is n spacings. */
    if (isnan(maximum))
        maximum = 0.05 * (p->x[*n - 1] - p->x[0]) * (double)*n /
                  (double)(*n - 1);
    longest_gap(*n, p->x, p->z, &length, &where);
    if (length > maximum * (1 + 1e-9)) /* x has rounding errors */
        return ovr_about(
            err, "max_gap",
            ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                        "a gap of %s at x = %s is longer than %s = %s%s",
                        ovr_along(p, length).text, ovr_along(p, where).text,
                        ovr_named(p, "max_gap").text,
                        ovr_along(p, maximum).text,
                        isnan(how->max_gap) ? ", 5 % of the length" : ""));
    filled = fill_gaps(*n, p->x, p->z);
    p->view.filled += filled;
    if (filled)
        ovr_profile_note(p, "%zu points interpolated linearly, longest gap %s",
                         filled, ovr_along(p, length).text);
    return OVR_OK;
}

static ovr_status drop_outliers(ovr_profile *p, const ovr_conditioning *how,
                                size_t *n, double *work, ovr_error *err)
{
    size_t marked;
    if (isnan(how->outliers))
        return OVR_OK;
    marked = mark_outliers(*n, p->z, how->outliers, work);
    ovr_profile_note(p, "%zu outliers beyond %g robust standard deviations",
                     marked, how->outliers);
    return close_gaps(p, how, n, err);
}

/* ----------------------------------------------------------------- filter */

static ovr_status filter(ovr_profile *p, const ovr_conditioning *how, size_t n,
                         double *work, ovr_error *err)
{
    double *mean = ovr_arena_take(&p->arena, n, sizeof *mean, err);
    const ovr_points points = {n, p->x, p->z};
    bool uniform = p->view.uniform;
    if (!mean)
        return OVR_NO_MEMORY;
    if (!isnan(how->lambda_c)) {
        ovr_gaussian(&points, how->lambda_c, uniform, mean, work);
        for (size_t i = 0; i < n; i++)
            p->z[i] -= mean[i];
        ovr_profile_note(p, "Gaussian filter lambda_c = %s (high-pass)",
                         ovr_along(p, how->lambda_c).text);
        p->view.lambda_c = how->lambda_c;
    }
    if (!isnan(how->lambda_s)) {
        ovr_gaussian(&points, how->lambda_s, uniform, mean, work);
        memcpy(p->z, mean, n * sizeof *mean);
        ovr_profile_note(p, "Gaussian filter lambda_s = %s (low-pass)",
                         ovr_along(p, how->lambda_s).text);
    }
    return OVR_OK;
}

static void shift(ovr_profile *p, double offset, size_t n)
{
    for (size_t i = 0; i < n; i++)
        p->z[i] += offset;
    if (offset != 0)
        ovr_profile_note(p, "offset by %s", ovr_across(p, offset).text);
}

ovr_status ovr_profile_condition(ovr_profile *profile,
                                 const ovr_conditioning *given, ovr_error *err)
{
    if (!profile)
        return ovr_fail_null(err, __func__);
    size_t n = profile->view.n;
    double *work = ovr_arena_take(&profile->arena, n, 3 * sizeof *work, err);
    ovr_conditioning own, *how = &own;
    ovr_status status = work ? OVR_TAKE(ovr_conditioning, how, given, err)
                             : OVR_NO_MEMORY;
    if (!status)
        status = check(profile, how, err);
    if (!status)
        status = choose_window(profile, how, &n, err);
    if (status)
        return status;
    change_scales(profile, how, n);
    status = close_gaps(profile, how, &n, err);
    if (!status)
        status = drop_outliers(profile, how, &n, work, err);
    if (!status)
        status = ovr_profile_finish(profile, n, err);
    if (status)
        return status;
    status = ovr_take_form(profile, how, n, work, err);
    if (!status)
        status = filter(profile, how, n, work, err);
    shift(profile, how->offset, n);
    return status ? status : ovr_profile_finish(profile, n, err);
}
