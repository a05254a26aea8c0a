/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/two_columns.h"

#include <math.h>
#include <string.h>

#include "base/error.h"
#include "surface/table_line.h"

enum { ROWS_MAX = 1000000 };

typedef struct reading {
    ovr_two_columns *to;
    const char *file;
    ovr_layout layout; /* layout of the first row; 0: unknown */
    bool found[2];     /* units in the header */
    bool swapped;      /* the second column comes first */
    int decimals;      /* maximum number of decimals in the second column */
    double last;       /* first number of the preceding row */
} reading;

/* ------------------------------------------------------------------ header */

/* Reads the next word of a header; blanks, brackets and separators separate
 * words. */
static bool next_word(ovr_line *rest, char *word, size_t capacity)
{
    static const char parting[] = " \t,;()[]#=_:\"";
    size_t from = 0, to;
    while (from < rest->size && strchr(parting, rest->text[from]))
        from++;
    for (to = from; to < rest->size && !strchr(parting, rest->text[to]);)
        to++;
    size_t length = to - from < capacity - 1 ? to - from : capacity - 1;
    memcpy(word, rest->text + from, length);
    word[length] = '\0';
    *rest = (ovr_line){rest->text + to, rest->size - to, rest->number};
    return length > 0;
}

/* Returns the SI value of a unit as written in headers; NAN for other words. */
static double unit_of(const char *word, ovr_dimension dimension)
{
    static const char *const angles[][2] = {
        {"degrees", "deg"}, {"degree", "deg"},  {"\302\260", "deg"},
        {"\260", "deg"},    {"radians", "rad"}, {"radian", "rad"}};
    const ovr_line piece = {word, strlen(word), 0};
    for (size_t k = 0; k < sizeof angles / sizeof *angles; k++)
        if (ovr_line_is(piece, angles[k][0]))
            word = angles[k][1];
    double metres = dimension == OVR_LENGTH ? ovr_length_unit(piece, false) : 0;
    return metres > 0 ? metres : ovr_unit_value(word, dimension);
}

/* Stores the units named in a line before the numbers. */
static void note_units(reading *r, ovr_line line)
{
    ovr_two_columns *c = r->to;
    char word[32];
    if (c->header[0] == OVR_PURE)
        return;
    while (next_word(&line, word, sizeof word))
        for (int k = 0; k < 2; k++) {
            double unit = unit_of(word, c->header[k]);
            if (isnan(unit) || r->found[k])
                continue;
            r->swapped = r->swapped || (k == 1 && !r->found[0]);
            r->found[k] = true;
            c->unit[k] = unit;
        }
}

/* Checks the units when the first row is reached. */
static ovr_status check_units(reading *r, long line, ovr_error *err)
{
    ovr_two_columns *c = r->to;
    c->named = r->found[0] && r->found[1];
    if (c->named || c->header[0] == OVR_PURE ||
        (c->optional && !r->found[0] && !r->found[1]))
        return OVR_OK;
    if (r->found[0] || r->found[1])
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "the header names a unit of the %s and none of the "
                           "%s: name both, such as '%s'",
                           c->name[r->found[1]], c->name[r->found[0]],
                           c->example);
    return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                       "the header must name the units of two columns, "
                       "%s (%s) and %s (%s), for example '%s'",
                       c->name[0], ovr_units_allowed(c->header[0]), c->name[1],
                       ovr_units_allowed(c->header[1]), c->example);
}

/* -------------------------------------------------------------------- rows */

/* Returns the number of decimals as written: 3 of "0.125", 5 of "1.25e-3". */
static int decimals_of(ovr_line number)
{
    const char *s = number.text, *end = s + number.size;
    int n = 0;
    while (s < end && !strchr(".,eEdD", *s))
        s++;
    if (s < end && (*s == '.' || *s == ','))
        while (++s < end && *s >= '0' && *s <= '9')
            n++;
    if (s == end)
        return n;
    bool minus = *++s == '-';
    int power = 0;
    for (s += *s == '-' || *s == '+'; s < end && power < 400; s++)
        power = 10 * power + (*s - '0');
    return minus ? n + power : n - power;
}

static bool begins_with_number(ovr_line line)
{
    ovr_line piece;
    double number;
    bool comma = ovr_layout_of(line).comma;
    return ovr_next_field(&line, ovr_layout_of(line).separator, &piece) &&
           ovr_number(piece, comma, &number);
}

static ovr_status store_pair(reading *r, const double pair[2], long line,
                             ovr_error *err)
{
    ovr_two_columns *c = r->to;
    if (c->minimum < c->maximum &&
        (pair[1] < c->minimum || pair[1] > c->maximum))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "value %g must be %g to %g%s", pair[1], c->minimum,
                           c->maximum, c->of);
    if (c->count && !(pair[0] > r->last))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "the %s must increase: %g follows %g", c->name[0],
                           pair[0], r->last);
    if (c->count == ROWS_MAX)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "has more than %d points, which is the maximum",
                           ROWS_MAX);
    r->last = pair[0];
    c->x[c->count] = pair[0] * c->unit[0];
    c->y[c->count] = pair[1] * c->unit[1];
    c->line[c->count++] = line;
    return OVR_OK;
}

/* Reads a line: two numbers, a comment or an empty line. Other lines are
 * errors. */
static ovr_status read_row(reading *r, ovr_line line, ovr_error *err)
{
    const char *comment = memchr(line.text, '#', line.size);
    double pair[2];
    ovr_fields f;
    if (comment)
        line.size = (size_t)(comment - line.text);
    line = ovr_trim(line);
    if (!line.size)
        return OVR_OK;
    if (!r->layout.separator)
        r->layout = ovr_layout_of(line);
    if (!ovr_split(line, r->layout.separator, &f) || f.count != 2 ||
        !ovr_number(f.field[r->swapped], r->layout.comma, &pair[0]) ||
        !ovr_number(f.field[!r->swapped], r->layout.comma, &pair[1]))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line.number,
                           "must be two numbers, %s and %s, separated as in "
                           "the first row",
                           r->to->name[r->swapped], r->to->name[!r->swapped]);
    int decimals = decimals_of(f.field[!r->swapped]);
    r->decimals = decimals > r->decimals ? decimals : r->decimals;
    return store_pair(r, pair, line.number, err);
}

/* Allocates space for as many rows as there are lines. */
static ovr_status reserve(ovr_two_columns *c, ovr_lines lines, ovr_arena *arena,
                          ovr_error *err)
{
    size_t n = 0;
    ovr_line line;
    while (n < ROWS_MAX && ovr_next_line(&lines, &line))
        n++;
    c->x = ovr_arena_take(arena, n, sizeof *c->x, err);
    c->y = ovr_arena_take(arena, n, sizeof *c->y, err);
    c->line = ovr_arena_take(arena, n, sizeof *c->line, err);
    return ovr_arena_status(arena);
}

ovr_status ovr_two_columns_read(ovr_two_columns *columns, const char *file,
                                ovr_bytes content, ovr_arena *arena,
                                ovr_error *err)
{
    reading r = {.to = columns, .file = file};
    const char *encoding;
    bool rows = columns->header[0] == OVR_PURE;
    ovr_line line;
    ovr_status status = ovr_decode(&content, file, arena, &encoding, err);
    ovr_lines lines = ovr_lines_of(content);
    columns->count = 0;
    if (!status)
        status = reserve(columns, lines, arena, err);
    while (!status && ovr_next_line(&lines, &line)) {
        if (!rows && begins_with_number(line)) {
            status = check_units(&r, line.number, err);
            rows = true;
        }
        if (!rows)
            note_units(&r, line);
        else if (!status)
            status = read_row(&r, line, err);
    }
    columns->rounding = pow(10, -r.decimals) * columns->unit[1];
    return status;
}
