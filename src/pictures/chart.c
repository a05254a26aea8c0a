/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A chart as text for gnuplot: its settings, one array for each member of its
 * panels and of its curves, and its numbers as tables. They are drawn by the
 * template chart.gp or a user's template.
 */
#include "pictures/chart.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "results/results.h"

/* --------------------------------------------------------------------- axes */

typedef struct quantity {
    ovr_unit_kind kind;
    ovr_axis hertzian;
    struct {
        double size;
        const char *unit, *label, *plain;
    } unit[3]; /* largest unit first */
} quantity;

#define LENGTH(size, unit, name, symbol)                                       \
    {                                                                          \
        size, unit, name ", {/:Italic " symbol "} (" unit ")",                 \
            name ", " symbol " (" unit ")"                                     \
    }
static const quantity quantities[] = {
    {OVR_KIND_LENGTH,
     {1, "position, {/:Italic x} ({/:Italic b})", "position, x (b)", ""},
     {LENGTH(1e-3, "mm", "position", "x"), LENGTH(1e-6, "µm", "position", "x"),
      LENGTH(1e-9, "nm", "position", "x")}},
    {OVR_KIND_HEIGHT,
     {1, "film thickness, {/:Italic h} ({/:Italic b}^2/{/:Italic R})",
      "film thickness, h (b²/R)", ""},
     {LENGTH(1e-6, "µm", "film thickness", "h"),
      LENGTH(1e-9, "nm", "film thickness", "h"),
      LENGTH(1e-9, "nm", "film thickness", "h")}},
    {OVR_KIND_PRESSURE,
     {1, "pressure, {/:Italic p} ({/:Italic p}_h)", "pressure, p (p_h)", ""},
     {LENGTH(1e9, "GPa", "pressure", "p"), LENGTH(1e6, "MPa", "pressure", "p"),
      LENGTH(1e3, "kPa", "pressure", "p")}},
    {OVR_KIND_TIME,
     {1, "time, {/:Italic t} ({/:Italic b}/{/:Italic u}_m)", "time, t (b/u_m)",
      ""},
     {LENGTH(1, "s", "time", "t"), LENGTH(1e-3, "ms", "time", "t"),
      LENGTH(1e-6, "µs", "time", "t")}},
};

static const quantity *find(ovr_unit_kind kind)
{
    for (size_t k = 0; k < sizeof quantities / sizeof *quantities; k++)
        if (quantities[k].kind == kind)
            return &quantities[k];
    return NULL;
}

bool ovr_axis_has(ovr_unit_kind kind)
{
    return find(kind) != NULL;
}

/* Chooses a unit prefix, used from 0.1 of the unit upwards (0.3 mm instead of
 * 300 um). */
static ovr_axis with_unit(const quantity *q, double scale, double largest)
{
    int k = 0;
    while (k < 2 && !(largest * scale >= 0.1 * q->unit[k].size))
        k++;
    return (ovr_axis){scale / q->unit[k].size, q->unit[k].label,
                      q->unit[k].plain, q->unit[k].unit};
}

double ovr_axis_reach(const double *values, size_t n)
{
    double high = 0;
    for (size_t i = 0; i < n; i++)
        high = fmax(high, fabs(values[i])); /* ignores NAN */
    return high;
}

void ovr_axis_as_is(ovr_unit_kind kind, bool si, double largest, ovr_axis *axis)
{
    const quantity *q = find(kind);
    if (q)
        *axis = si ? with_unit(q, 1, largest) : q->hertzian;
    else
        *axis = (ovr_axis){1, "", "", ""};
}

ovr_status ovr_axis_make(ovr_unit_kind kind, ovr_result *result,
                         ovr_units units, double largest, ovr_axis *axis,
                         ovr_error *err)
{
    const ovr_result_info *info = ovr_result_get_info(result);
    double scale = ovr_result_scale(info, kind);
    const quantity *q = find(kind);
    if (!q)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a quantity of unknown kind cannot be drawn");
    *axis = q->hertzian;
    if (units == OVR_HERTZIAN || (units == OVR_AS_STORED && !info->physical))
        return OVR_OK;
    if (!(scale > 0 && isfinite(scale)))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no SI units: the contact has no physical scales; "
                        "use Hertzian units");
    *axis = with_unit(q, scale, largest);
    return OVR_OK;
}

const char *const ovr_form_names[] = {"png", "svg", "pdf"};
const char *const ovr_mark_names[] = {
    [OVR_MARK_LINE] = "line",     [OVR_MARK_DASHED] = "dashed",
    [OVR_MARK_DOTTED] = "dotted", [OVR_MARK_POINTS] = "points",
    [OVR_MARK_CROSS] = "cross",   [OVR_MARK_BAND] = "band",
    [OVR_MARK_AREA] = "area"};

ovr_status ovr_form_of(const char *path, ovr_form *form, ovr_error *err)
{
    size_t length = strlen(path);
    for (int k = 0; k < OVR_FORMS; k++)
        if (length > 4 && path[length - 4] == '.' &&
            strcasecmp(path + length - 3, ovr_form_names[k]) == 0) {
            *form = (ovr_form)k;
            return OVR_OK;
        }
    return ovr_fail(err, OVR_BAD_INPUT,
                    "%s: the name of a picture must end in .png, .svg or .pdf",
                    path);
}

/* ---------------------------------------------------------------- panels */

ovr_panel ovr_panel_make(const char *x_label, const char *y_label)
{
    return (ovr_panel){.x_label = x_label,
                       .y_label = y_label,
                       .x_from = NAN,
                       .x_to = NAN,
                       .y_from = NAN,
                       .y_to = NAN};
}

/* Adds a curve. The capacity is the next power of two of `count`. */
void ovr_panel_add(ovr_panel *p, ovr_arena *arena, ovr_series series)
{
    size_t n = p->count;
    ovr_series *all = p->series;
    if ((n & (n - 1)) == 0) {
        all = ovr_arena_take(arena, n ? 2 * n : 1, sizeof *all, NULL);
        if (!all)
            return;
        if (n)
            memcpy(all, p->series, n * sizeof *all);
    }
    all[n] = series;
    p->series = all;
    p->count++;
}

void ovr_panel_line(ovr_panel *p, ovr_arena *arena, double x0, double x1,
                    double y0, double y1, ovr_series look)
{
    double *at = ovr_arena_take(arena, 4, sizeof *at, NULL);
    if (!at)
        return;
    at[0] = x0, at[1] = x1, at[2] = y0, at[3] = y1;
    look.n = look.n ? look.n : 2;
    look.x = at;
    look.y = at + 2;
    ovr_panel_add(p, arena, look);
}

/* -------------------------------------------------------------- settings */

/* Members that become arrays of settings, by their offset in a struct. */
typedef enum kind { TEXT, NUMBER, COUNT, FLAG, MARK, COLOUR } kind;
typedef struct member {
    const char *name;
    size_t at;
    kind kind;
    double otherwise; /* value for a number that is 0 */
} member;

#define OF_PANEL(name, member, kind)                                           \
    {                                                                          \
        name, offsetof(ovr_panel, member), kind, 0                             \
    }
static const member of_panels[] = {
    OF_PANEL("note", note, TEXT),
    OF_PANEL("x_label", x_label, TEXT),
    OF_PANEL("y_label", y_label, TEXT),
    OF_PANEL("x_from", x_from, NUMBER),
    OF_PANEL("x_to", x_to, NUMBER),
    OF_PANEL("y_from", y_from, NUMBER),
    OF_PANEL("y_to", y_to, NUMBER),
    OF_PANEL("log_x", log_x, FLAG),
    OF_PANEL("log_y", log_y, FLAG),
    {"tall", offsetof(ovr_panel, height), NUMBER, 1},
    OF_PANEL("ground", ground, FLAG),
    OF_PANEL("unit", bar_unit, TEXT),
    OF_PANEL("equal", equal, FLAG),
    OF_PANEL("cells_x", image.nx, COUNT),
    OF_PANEL("cells_y", image.ny, COUNT),
    OF_PANEL("colour_from", image.from, NUMBER),
    OF_PANEL("colour_to", image.to, NUMBER),
    OF_PANEL("colour_label", image.label, TEXT),
    OF_PANEL("beyond", image.above, FLAG),
    OF_PANEL("contours", image.contours, TEXT),
    OF_PANEL("bold_contours", image.bold_contours, TEXT)};

static const member of_series[] = {
    {"label", offsetof(ovr_series, label), TEXT, 0},
    {"mark", offsetof(ovr_series, mark), MARK, 0},
    {"colour", offsetof(ovr_series, colour), COLOUR, 0},
    {"weight", offsetof(ovr_series, width), NUMBER, 2},
    {"base", offsetof(ovr_series, base), NUMBER, 0},
    {"letters", offsetof(ovr_series, letters), TEXT, 0}};

enum {
    PANEL_MEMBERS = sizeof of_panels / sizeof *of_panels,
    SERIES_MEMBERS = sizeof of_series / sizeof *of_series
};

static void append_number(ovr_text *to, const char *format, double value)
{
    if (isfinite(value))
        ovr_text_print(to, format, value);
    else
        ovr_text_put(to, "NaN");
}

/* Writes a number with a decimal point, because gnuplot uses integer division
 * otherwise. */
static void append_real(ovr_text *to, double value)
{
    char text[40];
    snprintf(text, sizeof text, "%.9g", value);
    ovr_text_put(to, isfinite(value) ? text : "NaN");
    if (strspn(text, "-0123456789") == strlen(text))
        ovr_text_put(to, ".");
}

/* Writes one element of an array: the member of the struct at `from`. */
static void append_member(ovr_text *to, const member *m, const void *from)
{
    const char *at = (const char *)from + m->at;
    const char *text;
    double number;
    switch (m->kind) {
    case TEXT:
        memcpy(&text, at, sizeof text);
        ovr_text_gnuplot(to, text ? text : "");
        break;
    case NUMBER:
        memcpy(&number, at, sizeof number);
        append_real(to, number == 0 ? m->otherwise : number);
        break;
    case COUNT:
        ovr_text_print(to, "%zu", *(const size_t *)(const void *)at);
        break;
    case FLAG: ovr_text_put(to, *(const bool *)at ? "1" : "0"); break;
    case MARK:
        ovr_text_gnuplot(to,
                         ovr_mark_names[*(const ovr_mark *)(const void *)at]);
        break;
    case COLOUR: /* gnuplot counts words from one */
        ovr_text_print(to, "%d", *(const int *)(const void *)at + 1);
        break;
    }
}

static size_t panels_of(const ovr_chart *chart)
{
    return chart->rows * chart->columns;
}

/* Writes the curves of all panels, numbered consecutively from 1. */
static void append_curves(const ovr_chart *chart, ovr_text *to)
{
    size_t panels = panels_of(chart), curves = 0, images = 0;
    for (size_t k = 0; k < panels; k++)
        curves += chart->panel[k].count;
    for (int m = 0; m < SERIES_MEMBERS; m++) {
        const char *comma = "";
        ovr_text_print(to, "array %s[%zu] = [", of_series[m].name,
                       curves ? curves : 1);
        for (size_t k = 0; k < panels; k++)
            for (size_t j = 0; j < chart->panel[k].count; j++) {
                ovr_text_put(to, comma);
                append_member(to, &of_series[m], &chart->panel[k].series[j]);
                comma = ", ";
            }
        ovr_text_put(to, curves ? "]\n" : "0]\n");
    }
    ovr_text_print(to, "array first[%zu]\narray last[%zu]\narray image[%zu]\n",
                   panels, panels, panels);
    size_t before = 0;
    for (size_t k = 0; k < panels; k++) {
        const ovr_panel *p = &chart->panel[k];
        ovr_text_print(to, "first[%zu] = %zu; last[%zu] = %zu; image[%zu] = ",
                       k + 1, before + 1, k + 1, before + p->count, k + 1);
        if (p->image.values)
            ovr_text_print(to, "%zu\n", curves + images++);
        else
            ovr_text_put(to, "-1\n");
        before += p->count;
    }
}

void ovr_chart_settings(const ovr_chart *chart, ovr_form form, ovr_text *to)
{
    size_t panels = panels_of(chart);
    ovr_text_print(to, "kind = '%s'\nform = '%s'\nwidth = %d\nheight = %d\n",
                   chart->kind ? chart->kind : "", ovr_form_names[form],
                   chart->width, chart->height);
    ovr_text_put(to, "title = ");
    ovr_text_gnuplot(to, chart->title ? chart->title : "");
    ovr_text_put(to, "\nsubtitle = ");
    ovr_text_gnuplot(to, chart->subtitle ? chart->subtitle : "");
    ovr_text_print(to,
                   "\nrows = %zu\ncolumns = %zu\nshare_x = %d\nshare_y = %d\n",
                   chart->rows, chart->columns, chart->share_x, chart->share_y);
    for (int m = 0; m < PANEL_MEMBERS; m++) {
        ovr_text_print(to, "array %s[%zu] = [", of_panels[m].name, panels);
        for (size_t k = 0; k < panels; k++) {
            ovr_text_put(to, k ? ", " : "");
            append_member(to, &of_panels[m], &chart->panel[k]);
        }
        ovr_text_put(to, "]\n");
    }
    append_curves(chart, to);
}

/* ---------------------------------------------------------------- tables */

static double factor_of(double factor)
{
    return factor != 0 ? factor : 1;
}

double ovr_series_x(const ovr_series *s, size_t i)
{
    return s->x[i] * factor_of(s->x_factor);
}

double ovr_series_y(const ovr_series *s, size_t i)
{
    return s->y[i] * factor_of(s->factor) + s->shift;
}

static void append_series(const ovr_series *s, const char *digits, ovr_text *to)
{
    for (size_t i = 0; i < s->n; i++) {
        append_number(to, digits, ovr_series_x(s, i));
        ovr_text_put(to, " ");
        append_number(to, digits, ovr_series_y(s, i));
        if (s->mark == OVR_MARK_BAND) {
            ovr_text_put(to, " ");
            append_number(to, digits,
                          s->to[i] * factor_of(s->factor) + s->shift);
        }
        ovr_text_put(to, "\n");
    }
    if (s->n == 0)
        ovr_text_put(to, "NaN NaN NaN\n"); /* a table must not be empty */
}

static void append_image(const ovr_image *image, const char *digits,
                         ovr_text *to)
{
    for (size_t j = 0; j < image->ny; j++) {
        for (size_t i = 0; i < image->nx; i++) {
            append_number(to, digits, image->values[j * image->nx + i]);
            ovr_text_put(to, " ");
        }
        ovr_text_put(to, "\n");
    }
}

static void append_letter(ovr_text *to, const char *character, int bytes)
{
    ovr_text_add(to, character, (size_t)bytes);
}

/* Writes a comment with the contents of a table. */
static void append_heading(const char *label, const ovr_panel *p, ovr_text *to)
{
    ovr_text_put(to, "# ");
    ovr_text_foreign(to, label ? label : "-", append_letter);
    ovr_text_print(to, ": %s, %s\n", p->x_label, p->y_label);
}

void ovr_chart_tables(const ovr_chart *chart, const char *digits, ovr_text *to)
{
    const char *between = "";
    for (int images = 0; images < 2; images++)
        for (size_t k = 0; k < panels_of(chart); k++) {
            const ovr_panel *p = &chart->panel[k];
            size_t tables = images ? p->image.values != NULL : p->count;
            for (size_t j = 0; j < tables; j++) {
                ovr_text_put(to, between);
                append_heading(images ? p->image.label : p->series[j].label, p,
                               to);
                if (images)
                    append_image(&p->image, digits, to);
                else
                    append_series(&p->series[j], digits, to);
                between = "\n\n";
            }
        }
}
