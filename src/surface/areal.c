/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Areal grids and lines selected from them: a row, a column, the row nearest to
 * y, or a line of any direction through the centre, each as a single line or as
 * the mean over a band.
 *
 * Points of an oblique line are interpolated bilinearly from their four
 * neighbours, at the smaller of both distances.  This damps a wave of three
 * distances by up to a quarter; rows and columns are not interpolated.
 */
#include "surface/areal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "base/given.h"
#include "overroll/areal.h"
#include "surface/columns.h"

static const double pi = 3.14159265358979323846;

ovr_status ovr_areal_reserve(ovr_profile *p, size_t nx, size_t ny, double dx,
                             double dy, ovr_error *err)
{
    ovr_areal *map = &p->map;
    if (nx < 2 || ny < 1 || nx > OVR_POINTS_MAX || ny > OVR_POINTS_MAX / nx)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "%zu x %zu points: must be 2 to %d", nx, ny,
                           OVR_POINTS_MAX);
    if (!(dx > 0) || !isfinite(dx * (double)nx) || !(dy > 0 || ny == 1) ||
        !isfinite(dy * (double)ny))
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "the spacings of points, %g m and %g m, must be "
                           "positive",
                           dx, dy);
    map->nx = nx;
    map->ny = ny;
    map->dx = dx;
    map->dy = dy;
    map->z = ovr_arena_take(&p->map_arena, nx * ny, sizeof *map->z, err);
    return map->z ? OVR_OK : OVR_NO_MEMORY;
}

ovr_status ovr_areal_need_spacing(ovr_profile *p, const ovr_profile_source *s,
                                  double *dx, double *dy, double *scale,
                                  ovr_error *err)
{
    const char *key = s->spacing > 0 ? "unit_z" : "spacing";
    bool other = s->spacing_across > 0;
    *dx = s->spacing;
    *dy = other ? s->spacing_across : s->spacing;
    *scale = ovr_unit_given('z', s->unit_z ? s->unit_z : "", &p->view.scaled_z);
    p->view.scaled_x = s->spacing_scaled;
    if (s->spacing > 0 && *scale > 0) {
        ovr_profile_note(p, "spacing %s%s%s, z in %s (%s)",
                         ovr_along(p, *dx).text, other ? " x " : "",
                         other ? ovr_along(p, *dy).text : "", s->unit_z,
                         ovr_named(p, "unit_z").text);
        return OVR_OK;
    }
    return ovr_about(
        err, key,
        ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                    "the file does not specify the spacing of points and the "
                    "unit of heights; set %s%s, %s%s",
                    ovr_named(p, "spacing").text,
                    p->options ? " '0.5 um'" : " = 0.5 um",
                    ovr_named(p, "unit_z").text, p->options ? " um" : " = um"));
}

/* --------------------------------------------------------------- lines */

/* A straight line in the plane of the grid, in units of the grid spacings. */
typedef struct line {
    double x, y;   /* first point */
    double sx, sy; /* distance of successive points */
    double bx, by; /* distance of successive lines of the band */
    size_t n;
    long half;     /* lines of the band on each side */
    double length; /* distance between points, in the unit of lengths */
} line;

/* Interpolates bilinearly; NAN outside the grid, and if a neighbour with
 * nonzero weight is missing. */
static double height_at(const ovr_areal *map, double x, double y)
{
    const double eps = 1e-9;
    double i = floor(x + eps), j = floor(y + eps), sum = 0;
    double u = fmax(x - i, 0), v = fmax(y - j, 0);
    if (u < eps)
        u = 0;
    if (v < eps)
        v = 0;
    for (int k = 0; k < 4; k++) {
        double weight = (k & 1 ? u : 1 - u) * (k & 2 ? v : 1 - v);
        double column = i + (k & 1), row = j + (k >> 1);
        if (weight <= 0)
            continue;
        if (!(column >= 0 && column < (double)map->nx && row >= 0 &&
              row < (double)map->ny))
            return NAN;
        sum += weight * map->z[(size_t)row * map->nx + (size_t)column];
    }
    return sum;
}

/* Returns the mean height over the lines of the band, without missing heights;
 * NAN if more than half are missing. */
static double band_height(const ovr_areal *map, const line *l, size_t k)
{
    double sum = 0, x = l->x + (double)k * l->sx, y = l->y + (double)k * l->sy;
    long count = 0;
    for (long m = -l->half; m <= l->half; m++) {
        double z = height_at(map, x + (double)m * l->bx, y + (double)m * l->by);
        if (!isnan(z)) {
            sum += z;
            count++;
        }
    }
    return 2 * count > 2 * l->half ? sum / (double)count : NAN;
}

static bool has_heights(const ovr_areal *map, const line *l)
{
    size_t found = 0;
    for (size_t k = 0; k < l->n && found < 2; k++)
        found += isnan(band_height(map, l, k)) ? 0 : 1;
    return found == 2;
}

static line row_line(const ovr_areal *map, size_t row)
{
    return (line){0, (double)row, 1, 0, 0, 1, map->nx, 0, map->dx};
}

static line column_line(const ovr_areal *map, size_t column)
{
    return (line){(double)column, 0, 0, 1, 1, 0, map->ny, 0, map->dy};
}

/* Returns the longest line through the centre at `angle` (radians) from the x
 * axis. */
static line oblique_line(const ovr_areal *map, double angle)
{
    const double eps = 1e-9;
    double step = fmin(map->dx, map->dy), c = cos(angle), s = sin(angle);
    double half_x = (double)(map->nx - 1) / 2,
           half_y = (double)(map->ny - 1) / 2;
    double sx = step * c / map->dx, sy = step * s / map->dy;
    double steps = fmin(fabs(sx) > eps ? half_x / fabs(sx) : INFINITY,
                        fabs(sy) > eps ? half_y / fabs(sy) : INFINITY);
    double half = floor(steps + eps);
    return (line){
        half_x - half * sx, half_y - half * sy,   sx, sy,  -step * s / map->dx,
        step * c / map->dy, 2 * (size_t)half + 1, 0,  step};
}

/* Sets the number of lines of the band on each side of the middle one. */
static void set_band(const ovr_areal *map, double band, line *l)
{
    double across = hypot(l->bx * map->dx, l->by * map->dy);
    if (band > 0)
        l->half = (long)fmin(floor(band / 2 / across + 1e-9), 1e6);
}

/* ----------------------------------------------------- choice of the line */

static ovr_status check_index(const ovr_profile *p, const char *key, int asked,
                              size_t count, ovr_error *err)
{
    if (asked >= 0 && (size_t)asked <= count)
        return OVR_OK;
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%s = %d must be %s%zu",
                                 ovr_named(p, key).text, asked,
                                 count > 1 ? "1 to " : "", count));
}

static ovr_status check_choice(const ovr_profile *p,
                               const ovr_profile_source *s, ovr_error *err)
{
    const ovr_areal *map = &p->map;
    double height = (double)(map->ny - 1) * map->dy;
    int given = (s->row != 0) + (s->column != 0) + !isnan(s->y) +
                !isnan(s->direction);
    if (given > 1)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "only one of %s, %s, %s and %s can be given",
                           ovr_named(p, "row").text,
                           ovr_named(p, "column").text, ovr_named(p, "y").text,
                           ovr_named(p, "direction").text);
    if (!isnan(s->y) && !(s->y >= 0 && s->y <= height * (1 + 1e-9)))
        return ovr_about(err, "y",
                         ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                     "%s = %s: rows are from 0 to %s",
                                     ovr_named(p, "y").text,
                                     ovr_along(p, s->y).text,
                                     ovr_along(p, height).text));
    if (check_index(p, "row", s->row, map->ny, err))
        return OVR_BAD_INPUT;
    return check_index(p, "column", s->column, map->nx, err);
}

/* Returns the nearest line of the same direction that has two heights; -1 if
 * there is none. */
static long nearest_filled(const ovr_areal *map, bool rows, size_t from)
{
    long count = (long)(rows ? map->ny : map->nx), at = (long)from;
    for (long d = 0; d < count; d++)
        for (int side = -1; side <= 1; side += 2) {
            long k = at + side * d;
            line l;
            if (k < 0 || k >= count)
                continue;
            l = rows ? row_line(map, (size_t)k) : column_line(map, (size_t)k);
            if (has_heights(map, &l))
                return k;
        }
    return -1;
}

static ovr_status fail_empty(const ovr_profile *p, const char *key, size_t k,
                             ovr_error *err)
{
    bool rows = strcmp(key, "column") != 0;
    long filled = nearest_filled(&p->map, rows, k);
    if (filled < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "no %s has two heights", rows ? "row" : "column");
    return ovr_about(err, key,
                     ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "%s %zu has no heights; %s = %ld has",
                                 rows ? "row" : "column", k + 1,
                                 ovr_named(p, rows ? "row" : "column").text,
                                 filled + 1));
}

/* Selects the requested row or column, counted from 0. */
static ovr_status choose_given(ovr_profile *p, const ovr_profile_source *s,
                               line *chosen, ovr_error *err)
{
    const ovr_areal *map = &p->map;
    bool column = s->column > 0;
    size_t k = column       ? (size_t)s->column - 1
               : s->row > 0 ? (size_t)s->row - 1
                            : (size_t)lround(s->y / map->dy);
    if (!column && k > map->ny - 1)
        k = map->ny - 1;
    *chosen = column ? column_line(map, k) : row_line(map, k);
    set_band(map, s->band, chosen);
    if (!has_heights(map, chosen))
        return fail_empty(p, column ? "column" : s->row ? "row" : "y", k, err);
    ovr_profile_note(p, "%s %zu of %zu", column ? "column" : "row", k + 1,
                     column ? map->nx : map->ny);
    return OVR_OK;
}

/* Fails with a message that names the nearest directions, in whole degrees,
 * whose lines have heights. */
static ovr_status fail_direction(const ovr_profile *p, double degrees,
                                 ovr_error *err)
{
    char remedy[80];
    snprintf(remedy, sizeof remedy, "use %s",
             ovr_named(p, "row or column").text);
    for (int d = 1; d <= 180; d++) {
        double other = degrees + (d & 1 ? (d + 1) / 2 : -d / 2);
        line l = oblique_line(&p->map, other * pi / 180);
        if (l.n < 2 || !has_heights(&p->map, &l))
            continue;
        snprintf(remedy, sizeof remedy, "%s = %g has",
                 ovr_named(p, "direction").text, other);
        break;
    }
    return ovr_about(err, "direction",
                     ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                 "the line at %g degrees through the centre "
                                 "has no heights; %s",
                                 degrees, remedy));
}

static ovr_status choose_oblique(ovr_profile *p, double degrees, double band,
                                 line *chosen, ovr_error *err)
{
    *chosen = oblique_line(&p->map, degrees * pi / 180);
    set_band(&p->map, band, chosen);
    if (chosen->n < 2 || !has_heights(&p->map, chosen))
        return fail_direction(p, degrees, err);
    ovr_profile_note(p, "line through the centre at %.4g degrees to the x axis",
                     degrees);
    return OVR_OK;
}

/* Selects the line perpendicular to the lay, or the middle row if the surface
 * has no lay. */
static ovr_status choose_default(ovr_profile *p, double band, line *chosen,
                                 ovr_error *err)
{
    const ovr_areal *map = &p->map;
    ovr_areal_numbers numbers;
    ovr_status status = ovr_areal_measure(map, &numbers, err);
    double lay = fabs(numbers.lay) < 5e-4 ? 0 : numbers.lay; /* avoids -0 */
    double tilt = fabs(lay);
    bool column;
    long k;
    if (status)
        return status;
    if (tilt > 10 && tilt < 80)
        if (!choose_oblique(p, lay > 0 ? lay - 90 : lay + 90, band, chosen,
                            NULL)) {
            ovr_profile_note(p,
                             "this line is across the lay, which is at %.3g "
                             "degrees (%s selects another line)",
                             lay,
                             ovr_named(p, "row, column, y or direction").text);
            return OVR_OK;
        }
    column = tilt <= 10;
    k = nearest_filled(
        map, !column,
        isnan(lay) && map->ny < 8 ? 0 : (column ? map->nx : map->ny) / 2);
    if (k < 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "no %s of the %zu x %zu points has two heights",
                           column ? "column" : "row", map->nx, map->ny);
    *chosen = column ? column_line(map, (size_t)k) : row_line(map, (size_t)k);
    set_band(map, band, chosen);
    if (isnan(lay))
        ovr_profile_note(p, "row %ld of %zu (%s selects another)", k + 1,
                         map->ny, ovr_named(p, "row").text);
    else
        ovr_profile_note(p,
                         "%s %ld of %zu, across the lay, which is at %.3g "
                         "degrees to the x axis (%s selects another)",
                         column ? "column" : "row", k + 1,
                         column ? map->nx : map->ny, lay,
                         ovr_named(p, column ? "column" : "row").text);
    return OVR_OK;
}

static ovr_status extract_line(ovr_profile *p, const line *l, ovr_error *err)
{
    ovr_status status = ovr_profile_reserve(p, l->n, err);
    if (status)
        return status;
    ovr_profile_regular(p, l->n, l->sy == 0 ? p->offset : 0, l->length);
    for (size_t k = 0; k < l->n; k++)
        p->z[k] = band_height(&p->map, l, k);
    double last = (double)(l->n - 1), dx = p->map.dx, dy = p->map.dy;
    const double ends[] = {l->x * dx, l->y * dy, (l->x + last * l->sx) * dx,
                           (l->y + last * l->sy) * dy};
    memcpy(p->view.line, ends, sizeof ends);
    if (l->half)
        ovr_profile_note(p, "mean over a band of %ld lines", 2 * l->half + 1);
    return ovr_profile_finish(p, l->n, err);
}

static ovr_status choose(ovr_profile *p, const ovr_profile_source *s,
                         line *chosen, ovr_error *err)
{
    ovr_status status = check_choice(p, s, err);
    if (status)
        return status;
    if (s->row || s->column || !isnan(s->y))
        return choose_given(p, s, chosen, err);
    if (!isnan(s->direction))
        return choose_oblique(p, s->direction, s->band, chosen, err);
    return choose_default(p, s->band, chosen, err);
}

/* Rejects spacings so different that a line in an oblique direction would have
 * too many points. */
static ovr_status check_spacings(const ovr_profile *p, ovr_error *err)
{
    const double factor = 1e6, dx = p->map.dx, dy = p->map.dy;
    if (isnormal(dx) && (p->map.ny == 1 || (isnormal(dy) && dx <= factor * dy &&
                                            dy <= factor * dx)))
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                       "the spacings of points, %g m and %g m, must differ by "
                       "a factor of at most %g",
                       dx, dy, factor);
}

ovr_status ovr_areal_finish(ovr_profile *p, const ovr_profile_source *source,
                            double scale, ovr_error *err)
{
    ovr_areal *map = &p->map;
    size_t all = map->nx * map->ny;
    ovr_status status = check_spacings(p, err);
    line chosen;
    if (status)
        return status;
    ovr_profile_drop_codes(p, map->z, all);
    map->missing = 0;
    for (size_t i = 0; i < all; i++) {
        map->z[i] *= scale;
        if (!isfinite(map->z[i])) {
            map->z[i] = NAN;
            map->missing++;
        }
    }
    map->scaled_x = p->view.scaled_x;
    map->scaled_z = p->view.scaled_z;
    if (map->missing == all)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "none of the %zu points has a height", all);
    if (p->map_only)
        return OVR_OK;
    p->view.rows = map->ny;
    p->view.columns = map->nx;
    if (map->ny == 1 && !source->column && isnan(source->direction)) {
        status = check_choice(p, source, err);
        chosen = row_line(map, 0);
    } else {
        status = choose(p, source, &chosen, err);
    }
    if (!status)
        status = extract_line(p, &chosen, err);
    ovr_arena_release(&p->map_arena);
    p->map_arena = ovr_arena_make(&p->arena.allocator);
    map->z = NULL;
    return status;
}

/* ------------------------------------------------------------ whole grids */

ovr_areal *ovr_areal_read(const ovr_profile_source *source,
                          const ovr_allocator *allocator, ovr_error *err)
{
    ovr_profile_source own;
    ovr_profile *p;
    if (OVR_TAKE(ovr_profile_source, &own, source, err))
        return NULL;
    own.row = own.column = 0;
    own.y = own.band = own.direction = NAN;
    p = ovr_profile_read_file(&own, true, allocator, err);
    if (!p)
        return NULL;
    if (p->map.z && p->map.ny > 1) {
        p->map.format = p->view.format;
        p->map.notes = p->notes;
        p->map.owner = p;
        return &p->map;
    }
    ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                "contains a single line of heights, not an areal surface");
    ovr_profile_free(p);
    return NULL;
}

void ovr_areal_free(ovr_areal *areal)
{
    if (areal)
        ovr_profile_free(areal->owner);
}
