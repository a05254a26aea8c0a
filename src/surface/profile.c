/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Creates, reads, describes, saves and frees profiles. */
#include "surface/profile.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "base/quantity.h"
#include "overroll/profile.h"
#include "surface/surfaces.h"

ovr_profile_source ovr_profile_source_default(void)
{
    const ovr_profile_source defaults = {.spacing = NAN,
                                         .spacing_across = NAN,
                                         .y = NAN,
                                         .direction = NAN,
                                         .band = NAN};
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
                                       .extend = OVR_EXTEND_NONE,
                                       .from_across = NAN,
                                       .to_across = NAN,
                                       .taper_across = NAN,
                                       .extend_across = OVR_EXTEND_PERIODIC};
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
                                    .seed = 1,
                                    .peklenik = 1};
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
    profile->map_arena = ovr_arena_make(allocator);
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
        ovr_arena_release(&profile->map_arena);
        ovr_arena_release(&arena);
    }
}

const ovr_profile_view *ovr_profile_get_view(const ovr_profile *profile)
{
    return !profile ? NULL : &profile->view;
}

ovr_status ovr_profile_reserve(ovr_profile *profile, size_t n, ovr_error *err)
{
    if (n > OVR_POINTS_MAX)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "%zu points exceed the maximum of %d", n,
                           OVR_POINTS_MAX);
    profile->x = ovr_arena_take(&profile->arena, n, sizeof(double), err);
    profile->z = ovr_arena_take(&profile->arena, n, sizeof(double), err);
    return ovr_arena_status(&profile->arena);
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

/* ------------------------------------------------------ parts of messages */

/* Formats a length with a unit prefix: 0.32 mm, 88.4 nm. */
ovr_piece ovr_metres(double metres)
{
    static const char *const units[] = {"m", "mm", "um", "nm"};
    double size = fabs(metres);
    int k = 0;
    ovr_piece piece;
    if (size < 1e-15) /* rounding error */
        metres = size = 0;
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

/* True for numbers that instruments write for missing heights. */
static bool is_code(double z)
{
    static const double codes[] = {-9999,  -99999, -999999,       -999,
                                   -32768, -32767, 32767,         65535,
                                   9999,   99999,  -2147483648.0, 2147483647.0};
    for (size_t k = 0; k < sizeof codes / sizeof *codes; k++)
        if (z == codes[k])
            return true;
    return fabs(z) >= 1e30;
}

void ovr_profile_drop_codes(ovr_profile *profile, double *z, size_t n)
{
    double low = INFINITY, high = -INFINITY, code = NAN;
    size_t dropped = 0;
    for (size_t i = 0; i < n; i++)
        if (isfinite(z[i]) && !is_code(z[i])) {
            low = fmin(low, z[i]);
            high = fmax(high, z[i]);
        }
    if (low > high)
        return;
    for (size_t i = 0; i < n; i++)
        if (isfinite(z[i]) && is_code(z[i]) &&
            fmax(z[i] - high, low - z[i]) > 3 * (high - low)) {
            code = z[i];
            z[i] = NAN;
            dropped++;
        }
    if (dropped)
        ovr_profile_note(profile,
                         "%zu heights of %g, far from all others, were taken "
                         "as missing",
                         dropped, code);
}

/* Limit of heights, so that their fourth powers do not overflow. */
static const double HUGE_SIZE = 1e30;

static bool is_uniform(size_t n, const double *x)
{
    double mean = (x[n - 1] - x[0]) / (double)(n - 1);
    for (size_t i = 0; i < n; i++)
        if (fabs(x[i] - x[0] - (double)i * mean) > 0.01 * mean)
            return false;
    return true;
}

/* Warns of lengths and heights that are unusual for surface texture, because a
 * unit may be wrong. Heights are measured from the line through the ends; form
 * errors grow with the length of the profile. */
static void question_size(ovr_profile *profile, size_t n)
{
    const double *x = profile->x, *z = profile->z;
    double length = x[n - 1] - x[0], low = INFINITY, high = -INFINITY;
    size_t first = 0, last = n - 1;
    if (profile->questioned)
        return;
    profile->questioned = true;
    while (first < n - 1 && isnan(z[first]))
        first++;
    while (last > first && isnan(z[last]))
        last--;
    for (size_t i = first; i <= last && last > first; i++) {
        double u = (x[i] - x[first]) / (x[last] - x[first]);
        double height = z[i] - z[first] - u * (z[last] - z[first]);
        low = fmin(low, height);
        high = fmax(high, height);
    }
    if (length > 0.25)
        ovr_profile_note(profile,
                         "warning: a length of %s is unusual for a profile; "
                         "check the unit of x (%s)",
                         ovr_metres(length).text,
                         ovr_named(profile, "unit_x").text);
    if (high - low > 1e-3 && high - low > length / 50)
        ovr_profile_note(profile,
                         "warning: heights above %s are unusual for "
                         "roughness; check the unit of z (%s)",
                         ovr_metres(high - low).text,
                         ovr_named(profile, "unit_z").text);
}

ovr_status ovr_profile_finish(ovr_profile *profile, size_t n, ovr_error *err)
{
    ovr_profile_view *view = &profile->view;
    if (n < 2)
        return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                           "a profile needs two points, but there %s %zu",
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
                               "point %zu is (%s, %s), which is implausibly "
                               "large",
                               i + 1, ovr_along(profile, profile->x[i]).text,
                               ovr_across(profile, profile->z[i]).text);
        if (i && !(profile->x[i] > profile->x[i - 1]))
            return ovr_fail_at(err, OVR_BAD_INPUT, profile->file, 0,
                               "x must increase: point %zu at %s", i + 1,
                               ovr_along(profile, profile->x[i]).text);
    }
    if (!view->scaled_x && !view->scaled_z)
        question_size(profile, n);
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

/* ------------------------------------------------------ lengths with a unit */

/* Parses a length of a profile: "12 um", "0.3 b" or a number without unit. */

static bool is_scaled(const char *unit, const char *scaled)
{
    return !strcmp(unit, scaled) ||
           (!strcmp(scaled, "b^2/R") && !strcmp(unit, "b2/R"));
}

ovr_status ovr_length_read(const char *text, const char *scaled,
                           ovr_length *length, ovr_error *err)
{
    if (!text)
        return ovr_fail_null(err, __func__);
    size_t digits = strspn(text, " +-0123456789.");
    ovr_line unit;
    double metres;
    if (text[digits] == 'e' || text[digits] == 'E')
        digits += strspn(text + digits, "eE+-0123456789");
    unit = ovr_trim((ovr_line){text + digits, strlen(text + digits), 0});
    metres = ovr_length_unit(unit, true);
    if (!ovr_number(ovr_trim((ovr_line){text, digits, 0}), false,
                    &length->value))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "must be a length with a unit, such as '12 um'");
    length->unit = !unit.size                     ? OVR_LENGTH_BARE
                   : is_scaled(unit.text, scaled) ? OVR_LENGTH_SCALED
                                                  : OVR_LENGTH_METRES;
    if (length->unit == OVR_LENGTH_METRES && !(metres > 0))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "unknown unit '%s'; must be m, mm, um, nm, inch, "
                        "..., or %s",
                        ovr_quote(unit).text, scaled);
    if (length->unit == OVR_LENGTH_METRES)
        length->value *= metres;
    return OVR_OK;
}
