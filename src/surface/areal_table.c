/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Anti-aliasing and interpolation of areal surfaces.
 *
 * A windowed sinc gives the heights between the points in each direction:
 *
 *     z(s) = sum_j z_j w_j / sum_j w_j,  w_j = sinc(2 fc u) B(u/W),  u = s -
 * s_j
 *
 * B is the four-term Blackman-Harris window, as for profiles (resample.c).  If
 * the map is finer than the grid, wavelengths above 2.7 mesh sizes pass and
 * those below 2 vanish.  Beyond its ends the map is mirrored.
 *
 * The ends are blended by the quintic smoothstep over the taper, into the
 * smooth surface or into the other end.
 *
 * Cubic B-splines interpolate the entries.  Each max(d, D) has 4 along x and 2
 * across, where d is the distance of points and D the mesh size.  Coefficients
 * follow from a recursive filter (Unser, IEEE Signal Process. Mag. 16(6),
 * 1999).
 *
 * A wave of 8 mesh sizes is reproduced to 1e-4 of its amplitude.
 */
#include "surface/areal_table.h"

#include <math.h>

#include "base/error.h"
#include "surface/feature.h"
#include "surface/profile.h"
#include "surface/resample.h"

static const double PI = 3.14159265358979323846;

/* ------------------------------------------------------------- 1. resample */

/* Interpolation weights of the points for each entry of the table. */
typedef struct weights {
    size_t entries, taps;
    size_t *point; /* point[k taps + m]; unused weights are 0 */
    double *weight;
} weights;

/* One direction of the map and its table. */
typedef struct direction {
    size_t n;      /* points */
    double d;      /* distance between points */
    double length; /* from the first point to the last */
    double fc, reach;
    bool closed;
    double taper;
    int extend;
    size_t m;       /* intervals of the table */
    size_t entries; /* resampled entries: m + 1, or more if the ends are
                     * blended */
    ovr_areal_axis axis;
} direction;

/* Returns the index of the point at j, with mirrored or periodic
 * continuation. */
static size_t point_of(const direction *a, ptrdiff_t j)
{
    ptrdiff_t last = (ptrdiff_t)a->n - 1, period = a->closed ? last : 2 * last;
    j = (j % period + period) % period;
    return (size_t)(j > last ? period - j : j);
}

static ovr_status make_weights(const direction *a, weights *w, ovr_arena *arena,
                               ovr_error *err)
{
    w->entries = a->entries;
    w->taps = (size_t)floor(2 * a->reach / a->d) + 2;
    w->point = ovr_arena_take(arena, w->entries * w->taps, sizeof *w->point,
                              err);
    w->weight = ovr_arena_take(arena, w->entries * w->taps, sizeof *w->weight,
                               err);
    if (ovr_arena_status(arena))
        return OVR_NO_MEMORY;
    for (size_t k = 0; k < w->entries; k++) {
        double at = (double)k * a->axis.h, sum = 0;
        ptrdiff_t first = (ptrdiff_t)ceil((at - a->reach) / a->d);
        ptrdiff_t last = (ptrdiff_t)floor((at + a->reach) / a->d);
        double *weight = w->weight + k * w->taps;
        for (ptrdiff_t j = first; j <= last; j++) {
            weight[j - first] = ovr_windowed_sinc(at - (double)j * a->d, a->fc,
                                                  a->reach);
            w->point[k * w->taps + (size_t)(j - first)] = point_of(a, j);
            sum += weight[j - first];
        }
        for (size_t m = 0; m < w->taps; m++)
            weight[m] /= sum;
    }
    return OVR_OK;
}

/* Resamples each row of the map. */
static void resample_rows(const ovr_areal *map, const weights *w, double *to)
{
    for (size_t j = 0; j < map->ny; j++)
        for (size_t k = 0; k < w->entries; k++) {
            const double *z = map->z + j * map->nx;
            double sum = 0;
            for (size_t m = k * w->taps; m < (k + 1) * w->taps; m++)
                sum += w->weight[m] * z[w->point[m]];
            to[j * w->entries + k] = sum;
        }
}

/* Resamples the columns of rows of n heights. */
static void resample_columns(const double *from, size_t n, const weights *w,
                             double *to)
{
    for (size_t k = 0; k < w->entries; k++)
        for (size_t m = k * w->taps; m < (k + 1) * w->taps; m++) {
            const double *row = from + w->point[m] * n;
            const double weight = w->weight[m];
            for (size_t i = 0; weight != 0 && i < n; i++)
                to[k * n + i] += weight * row[i];
        }
}

static ovr_status check_taper(direction *a, double taper, const char *key,
                              ovr_error *err)
{
    a->taper = isnan(taper) ? 0.05 * a->length : taper;
    if (a->taper >= 0 && a->taper <= a->length / 2)
        return OVR_OK;
    return ovr_fail_about(err, key,
                          "%s = %g b must be between 0 and half the length of "
                          "the map, %g b",
                          key, a->taper, a->length / 2);
}

/* Chooses the entries in one direction, `share` entries per mesh size. */
static ovr_status plan(direction *a, const ovr_areal_fit *fit, int which,
                       ovr_error *err)
{
    static const char *const keys[] = {"taper", "taper_across"};
    const double share[] = {4, 2}, mesh = fit->mesh[which];
    bool periodic = fit->extend[which] == OVR_EXTEND_PERIODIC;
    bool mirror = fit->extend[which] == OVR_EXTEND_MIRROR;
    a->length = (double)(a->n - 1) * a->d;
    a->extend = fit->extend[which];
    a->closed = fit->closed;
    if (!(a->length >= 4 * mesh))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the map is %g b %s, less than 4 mesh sizes of %g b",
                        a->length, which ? "wide" : "long", mesh);
    if (check_taper(a, fit->taper[which], keys[which], err))
        return OVR_BAD_INPUT;
    double blend = periodic && !fit->closed ? a->taper : 0;
    double span = a->length - blend;
    a->fc = fmin(0.5 / a->d, 0.875 * 0.5 / mesh);
    a->reach = 24 * fmax(a->d, mesh);
    a->m = (size_t)fmax(8, ceil(share[which] * span / fmax(a->d, mesh)));
    a->axis.h = span / (double)a->m;
    a->axis.endless = periodic || mirror;
    a->axis.taper = a->taper;
    a->taper = mirror || (periodic && fit->closed) ? 0 : a->taper;
    a->entries = a->m + 1 + (size_t)ceil(blend / a->axis.h);
    a->axis.n = mirror ? 2 * a->m : periodic ? a->m : a->m + 1;
    return OVR_OK;
}

/* ---------------------------------------------------------------- 2. blend */

/* Returns the blended height of entry k from the resampled ones, which are
 * `apart` elements from each other. */
static double blended(const direction *a, const double *z, size_t apart,
                      size_t k)
{
    double at = (double)k * a->axis.h;
    if (a->extend == OVR_EXTEND_MIRROR)
        return z[apart * (k > a->m ? 2 * a->m - k : k)];
    if (!(a->taper > 0))
        return z[apart * k];
    double share = ovr_smoothstep(at / a->taper);
    if (a->extend == OVR_EXTEND_NONE)
        return z[apart * k] * share *
               ovr_smoothstep((a->length - at) / a->taper);
    if (share >= 1)
        return z[apart * k];
    return share * z[apart * k] + (1 - share) * z[apart * (k + a->m)];
}

/* --------------------------------------------------------------- 3. splines */

/* Computes the interpolation coefficients of n entries, `apart` elements from
 * each other. */
static void filter_line(double *z, size_t n, size_t apart, bool periodic)
{
    enum { HORIZON = 40 };
    const double pole = sqrt(3) - 2;
    size_t period = periodic ? n : 2 * (n - 1);
    double sum = 0, power = 1;
    if (n < 2)
        return;
    for (size_t k = 0; k < HORIZON; k++, power *= pole) {
        size_t j = (period - k % period) % period;
        sum += power * z[apart * (j >= n ? period - j : j)];
    }
    z[0] = sum;
    for (size_t k = 1; k < n; k++)
        z[apart * k] += pole * z[apart * (k - 1)];
    if (periodic) {
        sum = 0, power = -pole;
        for (size_t k = 0; k < HORIZON; k++, power *= pole)
            sum += power * z[apart * ((n - 1 + k) % n)];
    } else {
        sum = pole / (pole * pole - 1) *
              (z[apart * (n - 1)] + pole * z[apart * (n - 2)]);
    }
    z[apart * (n - 1)] = sum;
    for (size_t k = n - 1; k-- > 0;)
        z[apart * k] = pole * (z[apart * (k + 1)] - z[apart * k]);
    for (size_t k = 0; k < n; k++)
        z[apart * k] *= 6;
}

static void filter_table(ovr_areal_table *t)
{
    for (size_t i = 0; i < t->x.n; i++)
        filter_line(t->c + i * t->y.n, t->y.n, 1, t->y.endless);
    for (size_t j = 0; j < t->y.n; j++)
        filter_line(t->c + j, t->x.n, t->y.n, t->x.endless);
}

/* ----------------------------------------------------------------- numbers */

static double variance(size_t n, const double *z)
{
    double sum = 0, squares = 0;
    for (size_t i = 0; i < n; i++)
        sum += z[i];
    for (size_t i = 0; i < n; i++)
        squares += (z[i] - sum / (double)n) * (z[i] - sum / (double)n);
    return squares / (double)n;
}

/* Computes Sq, maximum height and mean wavelength from the entries, before they
 * are replaced by coefficients. */
static void measure(ovr_areal_table *t)
{
    double slope = 0;
    size_t all = t->x.n * t->y.n, n = t->y.n;
    for (size_t k = 0; k < all; k++)
        t->largest = fmax(t->largest, fabs(t->c[k]));
    for (size_t i = 0; i + 1 < t->x.n; i++)
        for (size_t j = 0; j + 1 < n; j++) {
            const double *z = t->c + i * n + j;
            double u = (z[n] - z[0]) / t->x.h, v = (z[1] - z[0]) / t->y.h;
            slope += u * u + v * v;
        }
    slope /= (double)((t->x.n - 1) * (n - 1));
    t->Sq = sqrt(variance(all, t->c));
    t->wavelength = slope > 0 ? 2 * PI * t->Sq / sqrt(slope) : INFINITY;
}

/* ------------------------------------------------------------------- table */

/* Blends the ends of `count` resampled rows of length n along x, in place. */
static void blend_rows(const direction *a, double *z, size_t count, size_t n,
                       double *line)
{
    for (size_t j = 0; j < count; j++) {
        for (size_t k = 0; k < a->axis.n; k++)
            line[k] = blended(a, z + j * n, 1, k);
        for (size_t k = 0; k < a->axis.n; k++)
            z[j * n + k] = line[k];
    }
}

static ovr_status fill(const ovr_areal *map, const direction *x,
                       const direction *y, ovr_areal_table *t, ovr_arena *work,
                       ovr_error *err)
{
    weights along = {0}, across = {0};
    size_t n = x->axis.n > x->entries ? x->axis.n : x->entries;
    double *rows = ovr_arena_take(work, map->ny * x->entries, sizeof *rows,
                                  err);
    double *all = ovr_arena_take(work, y->entries * n, sizeof *all, err);
    double *line = ovr_arena_take(work, n, sizeof *line, err);
    if (!rows || !all || !line || make_weights(x, &along, work, err) ||
        make_weights(y, &across, work, err))
        return OVR_NO_MEMORY;
    resample_rows(map, &along, rows);
    resample_columns(rows, x->entries, &across, all);
    double taps[] = {(double)(along.entries * along.taps),
                     (double)(across.entries * across.taps)};
    t->work = taps[0] * ((double)map->ny + OVR_SINC_WORK) +
              taps[1] * ((double)x->entries + OVR_SINC_WORK);
    double was = variance(map->nx * map->ny, map->z);
    double is = variance(y->entries * x->entries, all);
    t->lost = was > 0 ? fmax(0, 1 - is / was) : 0;
    if (n > x->entries) /* rows of the mirrored map are longer */
        for (size_t j = y->entries; j-- > 0;)
            for (size_t i = x->entries; i-- > 0;)
                all[j * n + i] = all[j * x->entries + i];
    blend_rows(x, all, y->entries, n, line);
    for (size_t i = 0; i < t->x.n; i++)
        for (size_t j = 0; j < t->y.n; j++)
            t->c[i * t->y.n + j] = blended(y, all + i, n, j);
    return OVR_OK;
}

ovr_status ovr_areal_tabulate(const ovr_areal *map, const ovr_areal_fit *fit,
                              ovr_areal_table *t, ovr_arena *arena,
                              ovr_error *err)
{
    direction x = {.n = map->nx, .d = map->dx};
    direction y = {.n = map->ny, .d = map->dy};
    if (plan(&x, fit, 0, err) || plan(&y, fit, 1, err))
        return OVR_BAD_INPUT;
    double entries = (double)x.axis.n * (double)y.axis.n;
    if (!(entries < OVR_POINTS_MAX))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "the map is too large for the grid: it needs a table "
                        "of %g points",
                        entries);
    *t = (ovr_areal_table){.x = x.axis, .y = y.axis};
    t->both = fit->both && x.axis.endless;
    t->c = ovr_arena_take(arena, t->x.n * t->y.n, sizeof *t->c, err);
    if (!t->c)
        return OVR_NO_MEMORY;
    ovr_arena work = ovr_arena_make(&arena->allocator);
    ovr_status status = fill(map, &x, &y, t, &work, err);
    ovr_arena_release(&work);
    if (status)
        return status;
    measure(t);
    filter_table(t);
    return OVR_OK;
}

/* -------------------------------------------------------------- evaluation */

double ovr_areal_extent(const ovr_areal_axis *a)
{
    return (double)(a->endless ? a->n : a->n - 1) * a->h;
}

/* Finds the four entries around s and their weights; false if s is outside. */
static bool entries_at(const ovr_areal_axis *a, double s, size_t at[4],
                       double weight[4])
{
    double length = ovr_areal_extent(a), u;
    if (a->endless)
        s -= length * floor(s / length);
    else if (!(s >= 0 && s <= length))
        return false;
    u = s / a->h;
    size_t last = a->endless ? a->n - 1 : a->n - 2;
    size_t i = (size_t)fmin(u, (double)last);
    double t = u - (double)i, r = 1 - t;
    weight[0] = r * r * r / 6;
    weight[1] = (t * t * (3 * t - 6) + 4) / 6;
    weight[2] = (r * r * (3 * r - 6) + 4) / 6;
    weight[3] = t * t * t / 6;
    size_t after = i + 2;
    at[0] = i > 0 ? i - 1 : a->endless ? a->n - 1 : 1;
    at[1] = i;
    at[2] = a->endless && i + 1 == a->n ? 0 : i + 1;
    at[3] = after < a->n ? after : a->endless ? after - a->n : a->n - 2;
    return true;
}

void ovr_areal_add(const ovr_areal_table *t, double factor, double s, double t0,
                   size_t lines, const double *Y, double *S)
{
    size_t i[4], j[4];
    double along[4], across[4], length = ovr_areal_extent(&t->x);
    if (t->x.endless && !t->both) {
        if (s >= length)
            return;
        if (t->x.taper > 0)
            factor *= ovr_smoothstep((length - s) / t->x.taper);
    }
    if (!entries_at(&t->x, s, i, along))
        return;
    for (size_t k = 0; k < lines; k++) {
        double z = 0;
        if (!entries_at(&t->y, t0 + Y[k], j, across))
            continue;
        for (int m = 0; m < 4; m++) {
            const double *c = t->c + i[m] * t->y.n;
            z += along[m] * (across[0] * c[j[0]] + across[1] * c[j[1]] +
                             across[2] * c[j[2]] + across[3] * c[j[3]]);
        }
        S[k] += factor * z;
    }
}
