/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The life of a profile: created, read, looked at, saved, freed. */
#include "surface/profile.h"
#include "base/given.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/plain.h"
#include "surface/surfaces.h"

ovr_profile_source ovr_profile_source_default(void)
{
    const ovr_profile_source defaults = {.spacing = NAN};
    return defaults;
}

ovr_conditioning ovr_conditioning_default(void)
{
    const ovr_conditioning defaults = {.from = NAN,
                                       .to = NAN,
                                       .scale = 1,
                                       .stretch = 1,
                                       .max_gap = NAN,
                                       .max_missing = 0.2,
                                       .outliers = NAN,
                                       .level = OVR_LEVEL_LINE,
                                       .degree = 2,
                                       .lambda_c = NAN,
                                       .lambda_s = NAN,
                                       .offset = 0,
                                       .taper = NAN,
                                       .extend = OVR_EXTEND_NONE};
    return defaults;
}

ovr_roughness ovr_roughness_default(void)
{
    const ovr_roughness defaults = {.Rq = NAN,
                                    .length = NAN,
                                    .spectrum = OVR_SELF_AFFINE,
                                    .hurst = 0.8,
                                    .rolloff = NAN,
                                    .shortest = NAN,
                                    .correlation = NAN,
                                    .skewness = NAN,
                                    .kurtosis = NAN,
                                    .seed = 1};
    return defaults;
}

/* -------------------------------------------------------------- building */

ovr_profile *ovr_profile_new(const char *file, const ovr_allocator *allocator,
                             ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(allocator);
    ovr_profile *profile = ovr_arena_take(&arena, 1, sizeof *profile, err);
    if (!profile)
        return NULL;
    profile->arena = arena;
    profile->file = ovr_arena_text(&profile->arena, file ? file : "", err);
    profile->view.notes = profile->notes;
    profile->view.format = "";
    profile->view.lambda_c = NAN;
    if (profile->file)
        return profile;
    ovr_profile_free(profile);
    return NULL;
}

void ovr_profile_free(ovr_profile *profile)
{
    if (profile) {
        ovr_arena arena = profile->arena;
        ovr_arena_release(&arena);
    }
}

const ovr_profile_view *ovr_profile_look(const ovr_profile *profile)
{
    return !profile ? NULL : &profile->view;
}

ovr_status ovr_profile_reserve(ovr_profile *profile, size_t n, ovr_error *err)
{
    if (n > OVR_POINTS_MAX)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "%zu points are more than the %d that are read", n,
                           OVR_POINTS_MAX);
    profile->x = ovr_arena_take(&profile->arena, n, sizeof(double), err);
    profile->z = ovr_arena_take(&profile->arena, n, sizeof(double), err);
    return profile->x && profile->z ? OVR_OK : OVR_NO_MEMORY;
}

void ovr_profile_note(ovr_profile *profile, const char *format, ...)
{
    size_t used = strlen(profile->notes), capacity = OVR_NOTES_SIZE - used;
    va_list args;
    int length;
    va_start(args, format);
    length = vsnprintf(profile->notes + used, capacity, format, args);
    va_end(args);
    if (length >= 0 && (size_t)length + 2 <= capacity)
        memcpy(profile->notes + used + length, "\n", 2);
    else
        profile->notes[used] = 0;
}

/* ------------------------------------------------- pieces of its messages */

/* Steps of a thousand below the metre: 0.32 mm, 88.4 nm. */
ovr_piece ovr_metres(double metres)
{
    static const char *const units[] = {"m", "mm", "um", "nm"};
    double size = fabs(metres);
    int k = 0;
    ovr_piece piece;
    for (; size < 0.1 && size > 0 && k < 3; size *= 1e3, k++)
        metres *= 1e3;
    snprintf(piece.text, sizeof piece.text, "%.4g %s", metres, units[k]);
    return piece;
}

static ovr_piece sized(double value, bool scaled, double metres,
                       const char *own)
{
    ovr_piece piece;
    if (!scaled || metres > 0)
        return ovr_metres(scaled ? value * metres : value);
    snprintf(piece.text, sizeof piece.text, "%.4g %s", value, own);
    return piece;
}

ovr_piece ovr_along(const ovr_profile *profile, double x)
{
    if (!profile)
        return (ovr_piece){0};
    return sized(x, profile->view.scaled_x, profile->b, "b");
}

ovr_piece ovr_across(const ovr_profile *profile, double z)
{
    if (!profile)
        return (ovr_piece){0};
    return sized(z, profile->view.scaled_z, profile->height, "b^2/R");
}

ovr_piece ovr_named(const ovr_profile *profile, const char *key)
{
    ovr_piece piece;
    snprintf(piece.text, sizeof piece.text, "%s%s",
             profile->options ? "--" : "", key);
    for (char *c = piece.text; profile->options && *c; c++)
        if (*c == '_')
            *c = '-';
    return piece;
}

void ovr_profile_regular(ovr_profile *profile, size_t n, double first,
                         double spacing)
{
    for (size_t i = 0; i < n; i++)
        profile->x[i] = first + (double)i * spacing;
}

ovr_status ovr_profile_choose_line(ovr_profile *profile,
                                   const ovr_profile_source *source,
                                   size_t lines, size_t *line, ovr_error *err)
{
    int asked = source->line;
    if (asked < 0 || (asked > 0 && (size_t)asked > lines))
        return ovr_about(err, "line",
                         ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                                     "%s = %d: the file has %s%zu",
                                     ovr_named(profile, "line").text, asked,
                                     lines > 1 ? "the lines 1 to " : "line ",
                                     lines));
    *line = asked > 0 ? (size_t)asked - 1 : 0;
    if (lines > 1 && asked)
        ovr_profile_note(profile, "line %zu of %zu", *line + 1, lines);
    else if (lines > 1)
        ovr_profile_note(profile, "line %zu of %zu (%s chooses another)",
                         *line + 1, lines, ovr_named(profile, "line").text);
    return OVR_OK;
}

/* Fourth powers of heights must not overflow. */
static const double HUGE_SIZE = 1e30;

static bool is_uniform(size_t n, const double *x)
{
    double mean = (x[n - 1] - x[0]) / (double)(n - 1);
    for (size_t i = 0; i < n; i++)
        if (fabs(x[i] - x[0] - (double)i * mean) > 0.01 * mean)
            return false;
    return true;
}

ovr_status ovr_profile_finish(ovr_profile *profile, size_t n, ovr_error *err)
{
    ovr_profile_view *view = &profile->view;
    if (n < 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "a profile needs two points, there %s %zu",
                           n == 1 ? "is" : "are", n);
    view->n = n;
    view->x = profile->x;
    view->z = profile->z;
    view->uniform = is_uniform(n, profile->x);
    view->missing = 0;
    for (size_t i = 0; i < n; i++) {
        if (!isfinite(profile->z[i])) {
            profile->z[i] = NAN;
            view->missing++;
        }
        if (!(fabs(profile->x[i]) < HUGE_SIZE) ||
            fabs(profile->z[i]) > HUGE_SIZE)
            return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                               "point %zu is (%s, %s): too large to be true",
                               i + 1, ovr_along(profile, profile->x[i]).text,
                               ovr_across(profile, profile->z[i]).text);
        if (i && !(profile->x[i] > profile->x[i - 1]))
            return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                               "x must increase: point %zu at %s", i + 1,
                               ovr_along(profile, profile->x[i]).text);
    }
    if (view->missing == n)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "none of the %zu points has a height", n);
    return OVR_OK;
}

ovr_profile *ovr_profile_create(size_t n, const double *x, const double *z,
                                bool scaled, const ovr_allocator *allocator,
                                ovr_error *err)
{
    if (!x || !z)
        return ovr_null(err, __func__);
    ovr_profile *profile = ovr_profile_new("profile", allocator, err);
    if (!profile)
        return NULL;
    profile->view.scaled_x = profile->view.scaled_z = scaled;
    profile->view.format = "memory";
    if (!ovr_profile_reserve(profile, n, err)) {
        memcpy(profile->x, x, n * sizeof *x);
        memcpy(profile->z, z, n * sizeof *z);
        if (!ovr_profile_finish(profile, n, err))
            return profile;
    }
    ovr_profile_free(profile);
    return NULL;
}

/* ---------------------------------------------------------------- saving */

static int write_points(const ovr_profile_view *view, FILE *out)
{
    int bad = fprintf(out, "# x in %s, z in %s\n", view->scaled_x ? "b" : "m",
                      view->scaled_z ? "b^2/R" : "m") < 0;
    for (size_t i = 0; i < view->n && !bad; i++)
        bad = isnan(view->z[i])
                  ? fprintf(out, "%.17g, NaN\n", view->x[i]) < 0
                  : fprintf(out, "%.17g, %.17g\n", view->x[i], view->z[i]) < 0;
    return bad;
}

ovr_status ovr_profile_save(const ovr_profile *profile, const char *path,
                            ovr_error *err)
{
    if (!profile)
        return ovr_fail_null(err, __func__);
    FILE *out = fopen(path, "w");
    locale_t before;
    int bad;
    if (!out)
        return ovr_fail_at(err, OVR_BAD_INPUT, path, 0, "cannot be written: %s",
                           strerror(errno));
    before = ovr_plain_begin();
    bad = write_points(&profile->view, out);
    ovr_plain_end(before);
    if (fclose(out) || bad)
        return ovr_fail_at(err, OVR_IO, path, 0, "writing failed: %s",
                           strerror(errno));
    return OVR_OK;
}
