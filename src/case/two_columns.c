/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/two_columns.h"
#include "base/error.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { ROWS_MAX = 1000000, LINE_MAX = 256 };

typedef struct reading {
    ovr_two_columns *to;
    const char *file;
    size_t capacity;
    bool headed;   /* the header has been read */
    bool swapped;  /* the second column comes first */
    bool found[2]; /* units in an optional header */
    int decimals;  /* maximum number of decimals in the second column */
    ovr_arena *arena;
} reading;

static ovr_status grow(reading *r, ovr_error *err)
{
    ovr_two_columns *c = r->to;
    size_t capacity = r->capacity ? 2 * r->capacity : 256;
    double *x = ovr_arena_take(r->arena, capacity, sizeof *x, err);
    double *y = ovr_arena_take(r->arena, capacity, sizeof *y, err);
    if (ovr_arena_status(r->arena))
        return OVR_NO_MEMORY;
    if (c->count) {
        memcpy(x, c->x, c->count * sizeof *x);
        memcpy(y, c->y, c->count * sizeof *y);
    }
    c->x = x;
    c->y = y;
    r->capacity = capacity;
    return OVR_OK;
}

static const char *skip_separators(const char *s)
{
    return s + strspn(s, " \t,;");
}

/* Returns the number of decimals as written: 3 of "0.125", 5 of "1.25e-3". */
static int decimals_of(const char *text)
{
    const char *point = strpbrk(text, ".eE \t,;#\r\n");
    int n = 0;
    if (point && *point == '.')
        n = (int)strspn(point + 1, "0123456789");
    const char *power = strpbrk(text, "eE \t,;#\r\n");
    if (power && (*power == 'e' || *power == 'E'))
        n -= (int)fmax(-400, fmin((double)strtol(power + 1, NULL, 10), 400));
    return n;
}

/* ------------------------------------------------------------------ header */

/* Reads the next word of a header; blanks, brackets and separators separate
 * words. */
static bool next_word(const char **at, char *word, size_t capacity)
{
    static const char *const parting = " \t,;()[]#=_:\"\r\n";
    *at += strspn(*at, parting);
    size_t length = strcspn(*at, parting);
    snprintf(word, capacity, "%.*s", (int)length, *at);
    *at += length;
    return length > 0;
}

/* Returns the unit that a header's word means ("degrees": deg); the word itself
 * if it is none of these. */
static const char *unit_meant(const char *word)
{
    static const char *const words[][2] = {
        {"degrees", "deg"},    {"degree", "deg"},  {"\302\260", "deg"},
        {"\260", "deg"},       {"radians", "rad"}, {"radian", "rad"},
        {"microns", "um"},     {"micron", "um"},   {"\302\265m", "um"},
        {"\316\274m", "um"},   {"\265m", "um"},    {"millimetres", "mm"},
        {"millimeters", "mm"}, {"metres", "m"},    {"meters", "m"}};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strcasecmp(word, words[k][0]) == 0)
            return words[k][1];
    return word;
}

/* Reads the units of both columns from a line, in any order; false if the line
 * has not both. */
static bool read_units(reading *r, const char *text)
{
    ovr_two_columns *c = r->to;
    char word[32];
    bool found[2] = {false, false};
    while (!(found[0] && found[1]) && next_word(&text, word, sizeof word))
        for (int k = 0; k < 2; k++) {
            double unit = ovr_unit_value(unit_meant(word), c->header[k]);
            if (isnan(unit))
                continue;
            if (found[k])
                return false;
            r->swapped = found[1] || (k == 1 && !found[0]);
            c->unit[k] = unit;
            found[k] = true;
        }
    return found[0] && found[1];
}

static ovr_status read_line(reading *r, long line, char *text, ovr_error *err);

/* Stores the units named in a line before the numbers. */
static void note_units(reading *r, const char *text)
{
    ovr_two_columns *c = r->to;
    char word[32];
    while (next_word(&text, word, sizeof word))
        for (int k = 0; k < 2; k++) {
            double unit = ovr_unit_value(unit_meant(word), c->header[k]);
            if (isnan(unit) || r->found[k])
                continue;
            r->swapped = r->swapped || (k == 1 && !r->found[0]);
            r->found[k] = true;
            c->unit[k] = unit;
        }
}

static bool begins_with_number(const char *text)
{
    double number;
    text = skip_separators(text);
    return ovr_read_number(&text, &number);
}

/* Reads a line of a file with an optional header; sets `headed` at the first
 * numbers. */
static ovr_status read_before(reading *r, long line, char *text, ovr_error *err)
{
    static const char mark[] = "\357\273\277"; /* byte order mark of UTF-8 */
    ovr_two_columns *c = r->to;
    bool marked = line == 1 && strncmp(text, mark, strlen(mark)) == 0;
    if (marked)
        memset(text, ' ', strlen(mark));
    if (!begins_with_number(text)) {
        note_units(r, text);
        return OVR_OK;
    }
    r->headed = true;
    c->named = r->found[0] && r->found[1];
    if (r->found[0] != r->found[1])
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "the header names a unit of the %s and none of the "
                           "%s: name both, such as '%s'",
                           c->name[r->found[1]], c->name[r->found[0]],
                           c->example);
    return read_line(r, line, text, err);
}

static ovr_status read_header(reading *r, long line, char *text, ovr_error *err)
{
    const ovr_two_columns *c = r->to;
    char word[32];
    const char *s = text;
    if (!next_word(&s, word, sizeof word)) /* empty line */
        return OVR_OK;
    r->headed = read_units(r, text);
    if (r->headed)
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                       "the first line must name the units of two columns, "
                       "%s (%s) and %s (%s), for example '%s'",
                       c->name[0], ovr_units_allowed(c->header[0]), c->name[1],
                       ovr_units_allowed(c->header[1]), c->example);
}

/* -------------------------------------------------------------------- rows */

/* Reads a line with two numbers only, and the position of the second. */
static bool read_pair(const reading *r, const char *text, double pair[2],
                      const char **second)
{
    for (int k = 0; k < 2; k++) {
        const char *s = skip_separators(text);
        if (k && s == text)
            return false;
        if ((k == 0) == r->swapped)
            *second = s;
        text = s;
        if (!ovr_read_number(&text, &pair[r->swapped ? 1 - k : k]))
            return false;
    }
    return !*skip_separators(text);
}

/* Reads a line: two numbers, a comment or an empty line; otherwise fails. */
static ovr_status read_line(reading *r, long line, char *text, ovr_error *err)
{
    ovr_two_columns *c = r->to;
    const char *second = text;
    double pair[2];
    text[strcspn(text, "#\r\n")] = '\0';
    if (!*skip_separators(text))
        return OVR_OK;
    if (!read_pair(r, text, pair, &second))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "must be two numbers, %s and %s",
                           c->name[r->swapped], c->name[!r->swapped]);
    if (c->minimum < c->maximum &&
        (pair[1] < c->minimum || pair[1] > c->maximum))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "value %g must be %g to %g%s", pair[1], c->minimum,
                           c->maximum, c->of);
    if (c->count == ROWS_MAX)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "has more than %d points, which is the maximum",
                           ROWS_MAX);
    if (c->count == r->capacity && grow(r, err))
        return OVR_NO_MEMORY;
    if (decimals_of(second) > r->decimals)
        r->decimals = decimals_of(second);
    c->x[c->count] = pair[0] * c->unit[0];
    c->y[c->count++] = pair[1] * c->unit[1];
    return OVR_OK;
}

ovr_status ovr_two_columns_read(ovr_two_columns *columns, const char *file,
                                const ovr_slot *slot, ovr_arena *arena,
                                ovr_error *err)
{
    reading r = {.to = columns,
                 .file = file,
                 .headed = columns->header[0] == OVR_PURE,
                 .arena = arena};
    ovr_status (*before)(reading *, long, char *, ovr_error *) =
        columns->optional ? read_before : read_header;
    FILE *in = fopen(file, "r");
    ovr_status status = OVR_OK;
    char text[LINE_MAX];
    if (!in)
        return ovr_fail_slot(err, slot, "cannot read '%s': %s", file,
                             strerror(errno));
    columns->count = 0;
    for (long line = 1; !status && fgets(text, sizeof text, in); line++) {
        if (strlen(text) == sizeof text - 1)
            status = ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                                 "the line is too long");
        else
            status = (r.headed ? read_line : before)(&r, line, text, err);
    }
    if (!status && ferror(in))
        status = ovr_fail_slot(err, slot, "cannot read '%s'", file);
    fclose(in);
    columns->rounding = pow(10, -r.decimals) * columns->unit[1];
    return status;
}
