/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Profiles in text: two columns x z (or two of more columns, named by the
 * header or the caller), or one column z with a spacing.
 *
 *   1. The encoding is detected. The first line whose fields are all numbers
 *      starts the data; a single number above it is the number of points.
 *   2. The lines above specify units and columns; the caller's values take
 *      precedence. One error lists all missing information.
 *   3. Rows become points. Rows in reverse order, x repeated by rounding, and
 *      missing heights are corrected or marked, with notes.
 */
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "surface/columns.h"
#include "surface/profile.h"

/* ------------------------------------------------------ order of the points */

/* Sorts the points of a text: reverses them, and separates points with the same
 * rounded x. */

static void reverse(double *a, size_t n)
{
    for (size_t i = 0; i < n / 2; i++) {
        double kept = a[i];
        a[i] = a[n - 1 - i];
        a[n - 1 - i] = kept;
    }
}

static void turn_round(ovr_profile *p, size_t n)
{
    if (!(p->x[n - 1] < p->x[0]))
        return;
    reverse(p->x, n);
    reverse(p->z, n);
    for (size_t i = 0; i < n; i++)
        p->x[i] += 0; /* avoids -0 */
    ovr_profile_note(p, "x decreases in the file; the profile was reversed");
}

/* Equal neighbouring x result from rounding. If all x lie within half a
 * rounding step (and a little more) of a straight line, they are replaced by
 * the line. Otherwise points with the same x are averaged. */
static bool regular_but_rounded(const ovr_profile *p, size_t n, double *first,
                                double *step)
{
    double quantum = INFINITY, middle = (double)(n - 1) / 2;
    double mean = 0, sum = 0, squares = 0;
    for (size_t i = 0; i < n; i++) {
        double t = (double)i - middle;
        mean += (p->x[i] - p->x[0]) / (double)n;
        sum += t * (p->x[i] - p->x[0]);
        squares += t * t;
        if (i && p->x[i] > p->x[i - 1])
            quantum = fmin(quantum, p->x[i] - p->x[i - 1]);
    }
    *step = sum / squares;
    *first = p->x[0] + mean - *step * middle;
    for (size_t i = 0; i < n; i++)
        if (!(fabs(p->x[i] - *first - (double)i * *step) <= 0.6 * quantum))
            return false;
    return *step > 0;
}

static size_t average_repeats(ovr_profile *p, size_t n)
{
    size_t m = 0;
    for (size_t i = 0, j; i < n; i = j, m++) {
        double sum = 0, count = 0;
        for (j = i; j < n && p->x[j] == p->x[i]; j++)
            if (!isnan(p->z[j]))
                sum += p->z[j], count++;
        p->x[m] = p->x[i];
        p->z[m] = count > 0 ? sum / count : NAN;
    }
    return m;
}

/* Makes x increase, or fails with the line number at which x turns back (`line`
 * has that of each point). *n may decrease. Adds notes about changes. */
static ovr_status sort_points(ovr_profile *p, size_t *n, const long *line,
                              ovr_error *err)
{
    bool backwards = *n > 1 && p->x[*n - 1] < p->x[0];
    size_t repeats = 0, m;
    double first, step;
    for (size_t i = 1; i < *n; i++) {
        double d = backwards ? p->x[i - 1] - p->x[i] : p->x[i] - p->x[i - 1];
        repeats += d == 0;
        if (d < 0)
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line[i],
                               "x is not monotonic: %.9g follows %.9g", p->x[i],
                               p->x[i - 1]);
    }
    if (*n > 1)
        turn_round(p, *n);
    if (!repeats)
        return OVR_OK;
    if (regular_but_rounded(p, *n, &first, &step)) {
        ovr_profile_regular(p, *n, first, step);
        ovr_profile_note(p,
                         "x repeats %zu times because of rounding; equal "
                         "spacing assumed",
                         repeats);
        return OVR_OK;
    }
    m = average_repeats(p, *n);
    ovr_profile_note(
        p, "points with equal x were averaged: %zu points became %zu", *n, m);
    *n = m;
    return OVR_OK;
}

static ovr_status fail(const ovr_text_table *t, long line, ovr_error *err,
                       const char *words)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, line, "%s", words);
}

/* --------------------------------------------------- 1. start of the data */

/* Returns the number of columns if the line contains only numbers, otherwise
 * 0. */
static size_t columns_of(ovr_line line, ovr_layout *layout)
{
    *layout = ovr_layout_of(line);
    return ovr_count_numbers(line, *layout);
}

/* True if a single number above rows with several columns is the number of
 * rows. */
static bool is_count(ovr_lines after, size_t columns)
{
    ovr_layout layout;
    ovr_line line;
    if (columns != 1)
        return false;
    while (ovr_next_line(&after, &line))
        if (ovr_trim(line).size)
            return columns_of(line, &layout) > 1;
    return false;
}

/* Finds the line that determines the layout of columns: "0;1,5" is more
 * informative than "0 0". */
static ovr_status find_data(ovr_text_table *t, ovr_error *err)
{
    ovr_lines lines = ovr_lines_of(t->content), before;
    ovr_line line;
    size_t columns;
    t->counted = NAN;
    for (before = lines; ovr_next_line(&lines, &line); before = lines) {
        if (memchr(line.text, 0, line.size))
            return fail(t, line.number, err,
                        "contains a NUL byte and is neither a text file nor "
                        "SDF, SMD, X3P, SUR or NumPy; export the profile in "
                        "one of these formats");
        columns = columns_of(line, &t->layout);
        if (!columns)
            continue;
        if (isnan(t->counted) && is_count(lines, columns)) {
            if (!ovr_number(ovr_trim(line), false, &t->counted))
                t->counted = NAN;
            continue;
        }
        t->data = before;
        t->header.columns = columns;
        return OVR_OK;
    }
    return fail(t, 0, err,
                "no line of numbers; a profile must have two columns x z, or "
                "one column z with a spacing (decimal commas need semicolons)");
}

static void read_header(ovr_text_table *t)
{
    ovr_lines lines = ovr_lines_of(t->content);
    ovr_line line;
    while (lines.at < t->data.at && ovr_next_line(&lines, &line))
        ovr_header_line(&t->header, line, t->layout.separator);
}

/* ------------------------------------------------------------- 3. the rows */

/* True for a comment; "#N/A" in the first column is none. */
static bool is_comment(ovr_line line)
{
    ovr_line piece;
    if (line.text[0] != '#' && line.text[0] != '%')
        return false;
    return !ovr_next_field(&line, ovr_layout_of(line).separator, &piece) ||
           !ovr_is_missing(piece);
}

bool ovr_next_row(ovr_lines *lines, ovr_line *line)
{
    while (ovr_next_line(lines, line)) {
        const ovr_line said = ovr_trim(*line);
        if (said.size && !is_comment(said))
            return true;
    }
    return false;
}

/* Reads a cell; z may be missing, x may not. */
static ovr_status read_cell(const ovr_text_table *t, const ovr_fields *fields,
                            long line, bool height, double *value,
                            ovr_error *err)
{
    size_t k = (size_t)(height ? t->z : t->x);
    if (k >= fields->count) {
        if (k == fields->count && fields->open && height) {
            *value = NAN;
            return OVR_OK;
        }
        return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, line,
                           "%zu columns, but column %zu is needed",
                           fields->count, k + 1);
    }
    if (ovr_number(fields->field[k], t->layout.comma, value))
        return OVR_OK;
    *value = NAN;
    if (height && ovr_is_missing(fields->field[k]))
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, t->profile->file, line,
                       "'%s' must be a number",
                       ovr_quote(fields->field[k]).text);
}

static ovr_status read_row(ovr_text_table *t, ovr_line line, size_t i,
                           ovr_error *err)
{
    ovr_profile *p = t->profile;
    ovr_fields fields;
    ovr_status status;
    double valid;
    t->number[i] = line.number;
    if (!ovr_split(line, t->layout.separator, &fields))
        return fail(t, line.number, err,
                    "has more than 64 columns, the maximum");
    status = read_cell(t, &fields, line.number, true, &p->z[i], err);
    if (!status && t->x >= 0)
        status = read_cell(t, &fields, line.number, false, &p->x[i], err);
    if (!status && t->valid >= 0 && t->valid < (int)fields.count &&
        ovr_number(fields.field[t->valid], t->layout.comma, &valid) &&
        valid == 0)
        p->z[i] = NAN;
    return status;
}

static ovr_status read_rows(ovr_text_table *t, size_t *n, ovr_error *err)
{
    ovr_lines lines = t->data;
    ovr_line line;
    ovr_status status;
    for (*n = 0; ovr_next_row(&lines, &line);)
        ++*n;
    lines = t->data;
    status = ovr_profile_reserve(t->profile, *n, err);
    if (status)
        return status;
    t->number = ovr_arena_take(&t->profile->arena, *n, sizeof(long), err);
    if (!t->number)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < *n && ovr_next_row(&lines, &line); i++)
        if ((status = read_row(t, line, i, err)))
            return status;
    return OVR_OK;
}

/* Removes a count of rows above a single column, which was read as its first
 * value. */
static void drop_count(ovr_text_table *t, size_t *n)
{
    ovr_profile *p = t->profile;
    if (t->x < 0 && *n > 2 && p->z[0] == (double)(*n - 1) &&
        fabs(p->z[0]) > 4 * fmax(fabs(p->z[1]), fabs(p->z[2]))) {
        memmove(p->z, p->z + 1, (*n - 1) * sizeof(double));
        *n -= 1;
        t->counted = (double)*n;
    }
    if (isnan(t->counted))
        return;
    if (t->counted == (double)*n)
        ovr_profile_note(p, "a count line states %zu points", *n);
    else
        ovr_profile_note(p, "a count line states %g points, but there are %zu",
                         t->counted, *n);
}

/* Computes x from the caller's or the header's spacing if there is no column
 * x. */
static ovr_status lay_out(ovr_text_table *t, size_t n, ovr_error *err)
{
    const ovr_profile_source *s = t->source;
    ovr_profile *p = t->profile;
    double spacing = s->spacing, metres = t->header.spacing_metres;
    if (s->spacing > 0) {
        p->view.scaled_x = s->spacing_scaled;
    } else {
        if (!(metres > 0))
            ovr_find_unit(t, 'x', s->unit_x, &metres, &p->view.scaled_x);
        spacing = t->header.spacing * metres;
    }
    if (!(spacing > 0) || !isfinite(spacing * (double)n))
        return fail(t, 0, err, "the spacing must be a positive length");
    ovr_profile_regular(p, n, 0, spacing);
    ovr_profile_note(p, "one column z; spacing %s", ovr_along(p, spacing).text);
    return OVR_OK;
}

static void scale(double *a, size_t n, double by)
{
    for (size_t i = 0; i < n; i++)
        a[i] *= by;
}

static ovr_status make_points(ovr_text_table *t, ovr_error *err)
{
    ovr_profile *p = t->profile;
    double unit_x = 1, unit_z;
    size_t n = 0;
    ovr_status status;
    if (t->x >= 0)
        ovr_find_unit(t, 'x', t->source->unit_x, &unit_x, &p->view.scaled_x);
    ovr_find_unit(t, 'z', t->source->unit_z, &unit_z, &p->view.scaled_z);
    status = read_rows(t, &n, err);
    if (status)
        return status;
    drop_count(t, &n);
    ovr_profile_drop_codes(p, p->z, n);
    status = t->x >= 0 ? sort_points(p, &n, t->number, err)
                       : lay_out(t, n, err);
    if (status)
        return status;
    if (t->x >= 0)
        scale(p->x, n, unit_x);
    scale(p->z, n, unit_z);
    return ovr_profile_finish(p, n, err);
}

/* True if the decimal separator is a comma. Semicolons also separate numbers
 * with decimal points. */
static bool has_decimal_comma(const ovr_text_table *t)
{
    ovr_lines lines = t->data;
    ovr_line line;
    while (t->layout.comma && ovr_next_row(&lines, &line))
        if (memchr(line.text, ',', line.size))
            return true;
    return false;
}

ovr_status ovr_read_text(ovr_profile *profile, const ovr_profile_source *source,
                         ovr_bytes content, ovr_error *err)
{
    ovr_text_table t = {
        .profile = profile, .source = source, .content = content};
    const char *encoding;
    bool map;
    ovr_status status = ovr_decode(&t.content, profile->file, &profile->arena,
                                   &encoding, err);
    profile->view.format = "text";
    if (!status)
        status = find_data(&t, err);
    if (status)
        return status;
    if (*encoding)
        ovr_profile_note(profile, "encoding %s", encoding);
    read_header(&t);
    status = ovr_read_text_map(&t, &map, err);
    if (status || map)
        return status;
    status = ovr_find_columns(&t, err);
    if (!status)
        status = ovr_check_given(&t, err);
    if (status)
        return status;
    if (t.valid >= 0)
        ovr_profile_note(profile, "column %d: heights marked by 0 are missing",
                         t.valid + 1);
    if (t.x >= 0)
        ovr_profile_note(profile, "column %d is x, column %d is z, of %zu%s",
                         t.x + 1, t.z + 1, t.header.columns,
                         has_decimal_comma(&t) ? "; commas are decimal points"
                                               : "");
    return make_points(&t, err);
}
