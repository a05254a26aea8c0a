/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lists and ranges of a study, as texts for the case. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "run/study.h"

enum { VALUE_CAPACITY = 200 };

/* Copies from..end without outer blanks. */
static char *trimmed(const char *from, const char *end, ovr_arena *arena,
                     ovr_error *err)
{
    char text[VALUE_CAPACITY];
    ovr_line line = ovr_trim((ovr_line){from, (size_t)(end - from), 0});
    if (!line.size || line.size >= VALUE_CAPACITY) {
        ovr_fail(err, OVR_BAD_INPUT,
                 line.size ? "a value is too long"
                           : "a value of the list is missing");
        return NULL;
    }
    snprintf(text, sizeof text, "%.*s", (int)line.size, line.text);
    return ovr_arena_text(arena, text, err);
}

/* ------------------------------------------------------------------- list */

static ovr_status read_list(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err)
{
    char stop = strchr(text, '|') ? '|' : ',';
    size_t n = 1;
    for (const char *c = text; *c; c++)
        n += *c == stop;
    *values = ovr_arena_take(arena, n, sizeof **values, err);
    *count = n;
    if (!*values)
        return OVR_NO_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const char *end = strchr(text, stop);
        if (!end)
            end = text + strlen(text);
        (*values)[i] = trimmed(text, end, arena, err);
        if (!(*values)[i])
            return OVR_BAD_INPUT;
        text = end + 1;
    }
    return OVR_OK;
}

/* ------------------------------------------------------------------ range */

typedef struct range {
    double from, to;
    char unit[24]; /* " um", or "" */
    size_t count;
    bool log;
} range;

/* The unit behind a number with a blank before it, or "". */
static bool read_end(const char *text, double *number, char *unit,
                     size_t capacity)
{
    const char *behind = ovr_amount_read(text, number);
    return behind && snprintf(unit, capacity, "%s%s", *behind ? " " : "",
                              behind) < (int)capacity;
}

static void copy_trimmed(char *to, const char *from, const char *end)
{
    ovr_line line = ovr_trim((ovr_line){from, (size_t)(end - from), 0});
    memcpy(to, line.text, line.size);
    to[line.size] = '\0';
}

/* "A to B in N" taken apart. */
static bool split_range(const char *text, char *from, char *to, size_t capacity,
                        size_t *count)
{
    const char *middle = strstr(text, " to ");
    const char *last = middle ? strstr(middle + 4, " in ") : NULL;
    char *end;
    unsigned long n;
    if (!last || (size_t)(middle - text) >= capacity ||
        (size_t)(last - middle - 4) >= capacity)
        return false;
    copy_trimmed(from, text, middle);
    copy_trimmed(to, middle + 4, last);
    last += 4 + strspn(last + 4, " ");
    n = strtoul(last, &end, 10);
    *count = n;
    return *last >= '0' && *last <= '9' && !*end && n > 1 &&
           n <= OVR_STUDY_MAX_TASKS;
}

static ovr_status parse_range(const char *text, range *r, ovr_error *err)
{
    char from[80], to[80], unit[24];
    const char *after = strchr(text, ' ');
    r->log = text[1] == 'o';
    if (!after || !split_range(after + 1, from, to, sizeof from, &r->count))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.80s' must be '%s A to B in N', N at least 2", text,
                        r->log ? "log" : "linear");
    if (!read_end(from, &r->from, unit, sizeof unit) ||
        !read_end(to, &r->to, r->unit, sizeof r->unit))
        return ovr_fail(err, OVR_BAD_INPUT, "'%.80s': A and B must be numbers",
                        text);
    if (unit[0] && strcmp(unit, r->unit) != 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.80s': A and B must have one unit", text);
    if (r->log && !(r->from > 0 && r->to > 0))
        return ovr_fail(err, OVR_BAD_INPUT, "'%.80s': A and B must be above 0",
                        text);
    return OVR_OK;
}

static double range_at(const range *r, size_t i)
{
    double s = (double)i / (double)(r->count - 1);
    if (i == 0 || i + 1 == r->count) /* the ends as given */
        return i ? r->to : r->from;
    return r->log ? r->from * pow(r->to / r->from, s)
                  : r->from + s * (r->to - r->from);
}

/* Ten digits: what is printed is what is computed, and reads well. */
static ovr_status fill_range(const range *r, ovr_arena *arena, char ***values,
                             size_t *count, ovr_error *err)
{
    char text[64];
    *count = r->count;
    *values = ovr_arena_take(arena, r->count, sizeof **values, err);
    for (size_t i = 0; *values && i < r->count; i++) {
        snprintf(text, sizeof text, "%.10g%s", range_at(r, i), r->unit);
        (*values)[i] = ovr_arena_text(arena, text, err);
        if (!(*values)[i])
            return OVR_NO_MEMORY;
    }
    return *values ? OVR_OK : OVR_NO_MEMORY;
}

/* "1..8": whole numbers. */
static bool is_count(const char *text, range *r)
{
    char *end;
    long from = strtol(text, &end, 10), to;
    const char *second = end + 2;
    if (end == text || strncmp(end, "..", 2) != 0)
        return false;
    to = strtol(second, &end, 10);
    if (end == second || *end || to <= from || to - from >= OVR_STUDY_MAX_TASKS)
        return false;
    *r = (range){(double)from, (double)to, "", (size_t)(to - from) + 1, false};
    return true;
}

ovr_status ovr_study_values(const char *text, ovr_arena *arena, char ***values,
                            size_t *count, ovr_error *err)
{
    char from[80], to[80];
    size_t n;
    range r;
    if (split_range(text, from, to, sizeof from, &n) &&
        strncmp(text, "linear ", 7) != 0 && strncmp(text, "log ", 4) != 0)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "'%.80s' is a range: it must begin with linear or log; "
                        "did you mean 'linear %.80s'?",
                        text, text);
    if (is_count(text, &r))
        return fill_range(&r, arena, values, count, err);
    if (strncmp(text, "linear ", 7) != 0 && strncmp(text, "log ", 4) != 0)
        return read_list(text, arena, values, count, err);
    if (parse_range(text, &r, err))
        return OVR_BAD_INPUT;
    return fill_range(&r, arena, values, count, err);
}
