/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Areal surfaces in text: a matrix, each line of which is a row of heights, or
 * points x y z on a regular grid in any order.
 *
 * A matrix is recognized by its header (Gwyddion writes width, height and
 * unit), by more than 64 columns, by the selection of a line, or by three or
 * more columns without names of which the first is not monotonic. Points are
 * recognized by three columns whose x and y form a grid that is at least half
 * full.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "surface/areal.h"
#include "surface/columns.h"

/* Reads one column of the first rows, at most `maximum`; returns their
 * number. */
static size_t read_column(const ovr_text_table *t, size_t column,
                          size_t maximum, double *values)
{
    ovr_lines lines = t->data;
    ovr_line line;
    size_t n = 0;
    while (n < maximum && ovr_next_row(&lines, &line)) {
        ovr_line rest = t->layout.separator == ' ' ? ovr_trim(line) : line;
        ovr_line field = {0};
        size_t k = 0;
        while (k <= column &&
               ovr_next_field(&rest, t->layout.separator, &field))
            k++;
        if (k <= column || !ovr_number(field, t->layout.comma, &values[n]))
            values[n] = NAN;
        n++;
    }
    return n;
}

static bool has_names(const ovr_text_table *t)
{
    for (size_t k = 0; k < t->header.columns && k < OVR_HEADER_FIELDS_MAX; k++)
        if (t->header.column[k].axis)
            return true;
    return false;
}

static bool is_matrix(const ovr_text_table *t)
{
    const ovr_profile_source *s = t->source;
    double first[1000];
    bool rises = true, falls = true; /* monotonic like x */
    size_t n;
    if (t->header.columns > OVR_HEADER_FIELDS_MAX)
        return true;
    if (s->column_x || s->column_z || t->header.columns < 2 || has_names(t))
        return false;
    if ((t->header.width > 0 && t->header.height > 0) || s->row || s->column ||
        !isnan(s->y) || !isnan(s->direction) || t->profile->map_only)
        return true;
    if (t->header.columns < 3)
        return false;
    n = read_column(t, 0, sizeof first / sizeof *first, first);
    for (size_t i = 1; i < n; i++) {
        rises &= first[i] > first[i - 1];
        falls &= first[i] < first[i - 1];
    }
    return n > 2 && !rises && !falls;
}

/* ------------------------------------------------------------------ matrix */

static size_t count_rows(const ovr_text_table *t)
{
    ovr_lines lines = t->data;
    ovr_line line;
    size_t n = 0;
    while (ovr_next_row(&lines, &line))
        n++;
    return n;
}

/* Determines size and unit from the header or the caller's options. */
static ovr_status find_scales(ovr_text_table *t, size_t nx, size_t ny,
                              double *dx, double *dy, double *scale,
                              ovr_error *err)
{
    ovr_profile *p = t->profile;
    const ovr_header *h = &t->header;
    const char *unit_z = t->source->unit_z;
    bool scaled;
    if (!(h->width > 0) || !(h->height > 0)) {
        ovr_status status = ovr_areal_need_spacing(p, t->source, dx, dy, scale,
                                                   err);
        if (status && err) {
            char more[sizeof err->message];
            memcpy(more, err->message, sizeof more);
            return ovr_about(err, err->about,
                             ovr_fail(err, OVR_BAD_INPUT,
                                      "%s (a map of %zu rows of %zu heights)",
                                      more, ny, nx));
        }
        return status;
    }
    *dx = h->width / (double)nx;
    *dy = h->height / (double)ny;
    *scale = h->value_metres;
    if (unit_z && *unit_z) {
        *scale = ovr_unit_given('z', unit_z, &scaled);
        p->view.scaled_z = scaled;
    }
    if (!(*scale > 0))
        return ovr_about(err, "unit_z",
                         ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                                     "the unit of z is not in the header; "
                                     "set %s%s",
                                     ovr_named(p, "unit_z").text,
                                     p->options ? " um" : " = um"));
    ovr_profile_note(p, "width %s, height %s, heights times %s",
                     ovr_metres(h->width).text, ovr_metres(h->height).text,
                     ovr_metres(*scale).text);
    return OVR_OK;
}

static ovr_status read_matrix_row(const ovr_text_table *t, ovr_line line,
                                  double *z, ovr_error *err)
{
    size_t nx = t->header.columns, k = 0;
    ovr_line rest = t->layout.separator == ' ' ? ovr_trim(line) : line, field;
    while (ovr_next_field(&rest, t->layout.separator, &field)) {
        double value = NAN;
        if (k == nx && !field.size && !rest.text)
            break; /* after the last separator */
        if (!ovr_number(field, t->layout.comma, &value) &&
            !ovr_is_missing(field))
            return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file,
                               line.number, "'%s' must be a height",
                               ovr_quote(field).text);
        if (k < nx)
            z[k] = value;
        k++;
    }
    if (k == nx)
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, line.number,
                       "%zu columns, but the rows above have %zu", k, nx);
}

static ovr_status read_matrix(ovr_text_table *t, ovr_error *err)
{
    ovr_profile *p = t->profile;
    size_t nx = t->header.columns, ny = count_rows(t);
    double dx, dy, scale;
    ovr_lines lines = t->data;
    ovr_line line;
    ovr_status status = find_scales(t, nx, ny, &dx, &dy, &scale, err);
    p->view.format = "text (map)";
    if (!status)
        status = ovr_areal_reserve(p, nx, ny, dx, dy, err);
    for (size_t j = 0; j < ny && !status && ovr_next_row(&lines, &line); j++)
        status = read_matrix_row(t, line, p->map.z + j * nx, err);
    return status ? status : ovr_areal_finish(p, t->source, scale, err);
}

/* ----------------------------------------------------------------- x, y, z */

static int compare(const void *a, const void *b)
{
    double x, y;
    memcpy(&x, a, sizeof x);
    memcpy(&y, b, sizeof y);
    return (x > y) - (x < y);
}

typedef struct axis {
    double first, step;
    size_t count;
} axis;

/* Finds distinct, equally spaced values (tolerance: a tenth of the spacing);
 * false if there are none. `sorted` is working memory. */
static bool find_axis(size_t n, const double *values, double *sorted, axis *a)
{
    double span;
    size_t count = 1;
    memcpy(sorted, values, n * sizeof *values);
    qsort(sorted, n, sizeof *sorted, compare);
    span = sorted[n - 1] - sorted[0];
    for (size_t i = 1; i < n; i++)
        count += sorted[i] - sorted[i - 1] > 1e-6 * span;
    if (count < 2 || !(span > 0))
        return false;
    *a = (axis){sorted[0], span / (double)(count - 1), count};
    for (size_t i = 0; i < n; i++) {
        double k = (sorted[i] - a->first) / a->step;
        if (fabs(k - round(k)) > 0.1)
            return false;
    }
    return true;
}

/* Finds the columns of x, y and z; false if there are none. */
static bool find_triple(const ovr_text_table *t, int column[3])
{
    if (t->source->column_x || t->source->column_z || t->header.columns < 3 ||
        t->header.columns > OVR_HEADER_FIELDS_MAX)
        return false;
    for (int k = 0; k < 3; k++)
        column[k] = has_names(t) ? -1 : k;
    for (int k = 0; has_names(t) && k < (int)t->header.columns; k++)
        for (int a = 0; a < 3; a++)
            if (t->header.column[k].axis == "xyz"[a])
                column[a] = k;
    return column[0] >= 0 && column[1] >= 0 && column[2] >= 0 &&
           (has_names(t) || t->header.columns == 3);
}

static ovr_status place_triples(ovr_text_table *t, const axis *ax,
                                const axis *ay, double *const v[3], size_t n,
                                ovr_error *err)
{
    ovr_profile *p = t->profile;
    size_t nx = ax->count;
    double unit_x = 1, unit_z = 1;
    ovr_status status = ovr_check_given(t, err);
    if (status)
        return status;
    ovr_find_unit(t, 'x', t->source->unit_x, &unit_x, &p->view.scaled_x);
    ovr_find_unit(t, 'z', t->source->unit_z, &unit_z, &p->view.scaled_z);
    p->view.format = "text (x y z)";
    status = ovr_areal_reserve(p, nx, ay->count, ax->step * unit_x,
                               ay->step * unit_x, err);
    if (status)
        return status;
    for (size_t k = 0; k < nx * ay->count; k++)
        p->map.z[k] = NAN;
    for (size_t k = 0; k < n; k++) {
        size_t i = (size_t)lround((v[0][k] - ax->first) / ax->step);
        size_t j = (size_t)lround((v[1][k] - ay->first) / ay->step);
        p->map.z[j * nx + i] = v[2][k];
    }
    return ovr_areal_finish(p, t->source, unit_z, err);
}

static ovr_status read_triples(ovr_text_table *t, const int column[3],
                               bool *found, ovr_error *err)
{
    ovr_arena arena = ovr_arena_make(&t->profile->arena.allocator);
    size_t n = count_rows(t);
    double *v[4];
    axis ax = {0}, ay = {0};
    ovr_status status = OVR_OK;
    for (int k = 0; k < 4; k++) {
        v[k] = ovr_arena_take(&arena, n, sizeof **v, err);
        if (!v[k])
            status = OVR_NO_MEMORY;
        else if (k < 3)
            read_column(t, (size_t)column[k], n, v[k]);
    }
    *found = !status && n >= 4;
    for (size_t k = 0; k < n && *found; k++)
        *found = isfinite(v[0][k]) && isfinite(v[1][k]);
    *found = *found && find_axis(n, v[0], v[3], &ax) &&
             find_axis(n, v[1], v[3], &ay) &&
             (double)ax.count * (double)ay.count <= 2 * (double)n;
    if (*found) {
        t->x = column[0];
        t->z = column[2];
        status = place_triples(t, &ax, &ay, v, n, err);
    }
    ovr_arena_release(&arena);
    return status;
}

ovr_status ovr_read_text_map(ovr_text_table *t, bool *found, ovr_error *err)
{
    int column[3];
    ovr_status status = OVR_OK;
    *found = false;
    if (find_triple(t, column))
        status = read_triples(t, column, found, err);
    if (status || *found)
        return status;
    *found = is_matrix(t);
    return *found ? read_matrix(t, err) : OVR_OK;
}
