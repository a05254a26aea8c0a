/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [lubricant]: the oil, and its tables from their files. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/entries.h"
#include "base/text.h"
#include "case/resolve.h"

enum { FILE_MOST = 1 << 22, POINTS_MOST = 100000, COLUMNS = 2 };

/* A file of two columns whose header names their units. */
typedef struct columns {
    const char *file;
    double unit[COLUMNS]; /* SI */
    int pressure;         /* which column it is */
    double *value[COLUMNS];
    long *line;
    size_t count;
} columns;

/* ----------------------------------------------------------------- header */

/* The next word of a header: blanks, brackets and separators part them. */
static bool next_word(const char **at, char *word, size_t room)
{
    static const char *const parting = " \t,;()[]#=_:";
    size_t length;
    *at += strspn(*at, parting);
    length = strcspn(*at, parting);
    snprintf(word, room, "%.*s", (int)length, *at);
    *at += length;
    return length > 0;
}

/* The units in a line, in their order; how many there are. */
static int read_units(const char *text, ovr_dimension value, columns *c)
{
    char word[32];
    int n = 0;
    while (n < COLUMNS && next_word(&text, word, sizeof word)) {
        double pressure = ovr_unit_value(word, OVR_PRESSURE);
        double other = ovr_unit_value(word, value);
        if (!isnan(pressure))
            c->pressure = n;
        if (!isnan(pressure) || !isnan(other))
            c->unit[n++] = isnan(pressure) ? other : pressure;
    }
    return n;
}

static ovr_status check_header(const columns *c, const char *text,
                               ovr_dimension value, long line, ovr_error *err)
{
    columns found = *c;
    found.pressure = -1;
    if (read_units(text, value, &found) == COLUMNS && found.pressure >= 0)
        return OVR_OK;
    return ovr_fail_at(err, OVR_BAD_INPUT, c->file, line,
                       "the first line must name the units of two columns, "
                       "pressure (%s) and %s (%s), such as 'pressure [MPa], "
                       "%s'",
                       ovr_units_allowed(OVR_PRESSURE),
                       value == OVR_MASS_DENSITY ? "density" : "viscosity",
                       ovr_units_allowed(value),
                       value == OVR_MASS_DENSITY ? "density [kg/m3]"
                                                 : "viscosity [mPa.s]");
}

/* ------------------------------------------------------------------- rows */

/* Two numbers; false: it is something else. */
static bool read_pair(const char *text, double pair[COLUMNS])
{
    static const char *const parting = " \t,;";
    for (int k = 0; k < COLUMNS; k++) {
        text += strspn(text, parting);
        if (!ovr_read_number(&text, &pair[k]))
            return false;
    }
    text += strspn(text, parting);
    return *text == '\0';
}

static ovr_status take_row(columns *c, const char *text, long line,
                           ovr_error *err)
{
    double pair[COLUMNS];
    if (!read_pair(text, pair))
        return ovr_fail_at(err, OVR_BAD_INPUT, c->file, line,
                           "'%.40s' must be two numbers", text);
    if (c->count == POINTS_MOST)
        return ovr_fail_at(err, OVR_BAD_INPUT, c->file, line,
                           "more than %d points", POINTS_MOST);
    for (int k = 0; k < COLUMNS; k++)
        c->value[k == c->pressure ? 0 : 1][c->count] = pair[k] * c->unit[k];
    c->count++;
    return OVR_OK;
}

static ovr_status read_rows(columns *c, const char *content,
                            ovr_dimension value, ovr_error *err)
{
    ovr_lines lines = ovr_lines_of((ovr_bytes){content, strlen(content)});
    ovr_line line;
    bool header = false;
    ovr_status status = OVR_OK;
    char text[256];
    while (!status && ovr_next_line(&lines, &line)) {
        line = ovr_trim(line);
        if (!line.size || (header && line.text[0] == '#'))
            continue;
        snprintf(text, sizeof text, "%.*s", (int)line.size, line.text);
        if (header) {
            status = take_row(c, text, line.number, err);
            continue;
        }
        status = check_header(c, text, value, line.number, err);
        read_units(text, value, c);
        header = true;
    }
    return status;
}

static ovr_status read_columns(ovr_resolved *r, ovr_dimension value, columns *c,
                               ovr_error *err)
{
    const char *content;
    size_t lines = 1;
    ovr_status status = ovr_text_file(c->file, "table", FILE_MOST, &r->arena,
                                      &content, err);
    if (status)
        return status;
    for (const char *p = content; *p; p++)
        lines += *p == '\n' || *p == '\r';
    for (int k = 0; k < COLUMNS; k++)
        c->value[k] = ovr_arena_take(&r->arena, lines, sizeof(double), err);
    if (!c->value[0] || !c->value[1])
        return OVR_NO_MEMORY;
    return read_rows(c, content, value, err);
}

static ovr_status read_table(ovr_resolved *r, const char *file,
                             ovr_table_of what, ovr_error *err)
{
    ovr_dimension value = what == OVR_TABLE_OF_VISCOSITY ? OVR_DYNAMIC_VISCOSITY
                                                         : OVR_MASS_DENSITY;
    columns c = {.file = file};
    ovr_error why = {0};
    ovr_status status;
    if (!file)
        return OVR_OK;
    status = read_columns(r, value, &c, err);
    if (status)
        return status;
    r->tables[what] = ovr_law_table_create(
        what, c.count, c.value[0], c.value[1], &r->arena.allocator, &why);
    return r->tables[what] ? OVR_OK : ovr_fail_from(err, &why, file, 0);
}

/* -------------------------------------------------------------------- oil */

static ovr_status grade(ovr_resolved *r, ovr_error *err)
{
    ovr_oil *oil = &r->values.oil;
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "lubricant"),
                                         "iso_vg");
    if (isnan(r->values.iso_vg))
        return OVR_OK;
    if (!isnan(oil->nu_40))
        return ovr_fail_slot(err, slot,
                             "viscosity_40 is given too: leave one "
                             "out");
    oil->nu_40 = r->values.iso_vg * 1e-6;
    return OVR_OK;
}

ovr_status ovr_resolve_oil(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_oil *oil = &v->oil;
    ovr_error why = {0};
    ovr_status status = grade(r, err);
    if (!isnan(v->heat.temperature) && !isnan(oil->temperature))
        return ovr_fail_slot(
            err, ovr_block_get(ovr_block_of(r, "heat"), "temperature"),
            "is given in [lubricant] too: leave one out");
    if (isnan(oil->temperature))
        oil->temperature = v->heat.temperature;
    oil->viscosity_law = (ovr_viscosity_law)v->viscosity_law;
    oil->density_law = (ovr_density_law)v->density_law;
    oil->viscosity = v->contact.viscosity;
    oil->alpha = v->contact.alpha;
    oil->mineral = v->oil_kind == 1;
    if (!status && oil->viscosity_law == OVR_VISCOSITY_TABLE)
        status = read_table(r, v->viscosity_file, OVR_TABLE_OF_VISCOSITY, err);
    if (!status && oil->density_law == OVR_DENSITY_TABLE)
        status = read_table(r, v->density_file, OVR_TABLE_OF_DENSITY, err);
    if (status)
        return status;
    oil->viscosity_table = r->tables[OVR_TABLE_OF_VISCOSITY];
    oil->density_table = r->tables[OVR_TABLE_OF_DENSITY];
    bool given = !isnan(oil->alpha);
    if (ovr_oil_complete(oil, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "lubricant"),
                           ovr_block_of(r, "contact"), &why);
    r->alpha_estimated = oil->mineral && !given;
    v->contact.viscosity = oil->viscosity;
    v->contact.alpha = oil->alpha;
    return OVR_OK;
}
