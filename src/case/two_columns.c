/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/two_columns.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_MOST = 1000000, LINE_MOST = 256 };

typedef struct reading {
    ovr_two_columns *to;
    const char *file;
    size_t room;
    int decimals; /* of the second column, the most of all rows */
    ovr_arena *arena;
} reading;

static ovr_status grow(reading *r, ovr_error *err)
{
    ovr_two_columns *c = r->to;
    size_t room = r->room ? 2 * r->room : 256;
    double *x = ovr_arena_take(r->arena, room, sizeof *x, err);
    double *y = ovr_arena_take(r->arena, room, sizeof *y, err);
    if (!x || !y)
        return OVR_NO_MEMORY;
    if (c->count) {
        memcpy(x, c->x, c->count * sizeof *x);
        memcpy(y, c->y, c->count * sizeof *y);
    }
    c->x = x;
    c->y = y;
    r->room = room;
    return OVR_OK;
}

static const char *skip_separators(const char *s)
{
    return s + strspn(s, " \t,;");
}

/* Decimals of a number as it is written: 3 of "0.125", 5 of "1.25e-3". */
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

/* Two numbers, or nothing (a comment or an empty line), or an error. */
static ovr_status read_line(reading *r, long line, char *text, ovr_error *err)
{
    ovr_two_columns *c = r->to;
    const char *s = skip_separators(text), *second;
    double x, y;
    text[strcspn(text, "#\r\n")] = '\0';
    if (!*s)
        return OVR_OK;
    if (!ovr_read_number(&s, &x) || s == skip_separators(s) ||
        (second = s = skip_separators(s), !ovr_read_number(&s, &y)) ||
        *skip_separators(s))
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "must be two numbers, %s", c->what);
    if (y < c->least || y > c->most)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "value %g must be %g to %g%s", y, c->least, c->most,
                           c->of);
    if (c->count == ROWS_MOST)
        return ovr_fail_at(err, OVR_BAD_INPUT, r->file, line,
                           "more than %d points", ROWS_MOST);
    if (c->count == r->room && grow(r, err))
        return OVR_NO_MEMORY;
    if (decimals_of(second) > r->decimals)
        r->decimals = decimals_of(second);
    c->x[c->count] = x * c->unit[0];
    c->y[c->count++] = y * c->unit[1];
    return OVR_OK;
}

ovr_status ovr_two_columns_read(ovr_two_columns *columns, const char *file,
                                const ovr_slot *slot, ovr_arena *arena,
                                ovr_error *err)
{
    reading r = {columns, file, 0, 0, arena};
    FILE *in = fopen(file, "r");
    ovr_status status = OVR_OK;
    char text[LINE_MOST];
    if (!in)
        return ovr_fail_slot(err, slot, "cannot read '%s': %s", file,
                             strerror(errno));
    columns->count = 0;
    for (long line = 1; !status && fgets(text, sizeof text, in); line++) {
        if (strlen(text) == sizeof text - 1)
            status = ovr_fail_at(err, OVR_BAD_INPUT, file, line,
                                 "the line is too long");
        else
            status = read_line(&r, line, text, err);
    }
    if (!status && ferror(in))
        status = ovr_fail_slot(err, slot, "cannot read '%s'", file);
    fclose(in);
    columns->rounding = pow(10, -r.decimals) * columns->unit[1];
    return status;
}
